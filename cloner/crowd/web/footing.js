"use strict";
// Who stands on what, when: the same as cloner/crowd/staged/footing.py, number for number.

const [FROM, UNTIL, CLIP, OTHER, FIRST, LAST, SHARE, SHARE_LAST, AT_X, AT_Z, HEADING, HEADING_LAST, FEELS] = [...Array(13).keys()];
const FOOTING = 13, FEELS_S = 0.6, LEFT = 3, RIGHT = 27, ALONE = 2, SHARED = 21, LIFT_PARTS = 8, TURN_PARTS = 28, BLEND_S = 0.4;
const WALK_FRAMES = 48, TOUCH = 6, BY_FOOTINGS = 3, GONE = 4, CLIP_STEP = 1024, ACTED = "scenario";
const PAST_S = 20; // footings over for so long are not kept

function smooth(share) {
  const s = Math.min(Math.max(share, 0), 1);
  return s * s * (3 - 2 * s);
}

// A footing (its place in the list) that is no standing, in equal parts: 5 numbers each: frame, share, heading, x, z.
function partsOf(list, at, touches, clone_touch, scale) {
  const first = Math.round(list[at + FIRST]), last = Math.round(list[at + LAST]), base = first < RIGHT ? LEFT : RIGHT;
  const from = list[at + SHARE], to = list[at + SHARE_LAST], turns = first === last;
  const begins = !turns && from === 0, ends = !turns && !begins && to === 0;
  const steps = last - first, count = turns ? TURN_PARTS : steps + (begins || ends ? LIFT_PARTS : 0);
  const held = TURN_PARTS - 2 * LIFT_PARTS, low = Math.max(first, base + ALONE), high = Math.min(last, base + SHARED);
  const before_it = -1 - Math.round(list[at + OTHER]), kind = WALK_FRAMES * TOUCH;
  const own_touch = clone_touch + list[at + CLIP] * kind, rest_touch = clone_touch + before_it * kind;
  const found = new Float64Array(5 * (count + 1)), up = (k) => smooth(k / LIFT_PARTS);
  for (let k = 0; k <= count; k++) {
    let frame = first, share, turned;
    if (turns) {
      share = Math.min(up(k), up(count - k));
      turned = smooth((k - LIFT_PARTS) / held);
    } else {
      frame = first + Math.min(begins ? Math.max(k - LIFT_PARTS, 0) : k, steps);
      turned = smooth((frame - low) / (high - low));
      share = begins ? to * up(Math.min(k, LIFT_PARTS)) : ends ? from * up(Math.min(count - k, LIFT_PARTS))
        : before_it >= 0 ? turned : from + (to - from) * turned;
    }
    found[5 * k] = frame;
    found[5 * k + 1] = share;
    found[5 * k + 2] = list[at + HEADING] + (list[at + HEADING_LAST] - list[at + HEADING]) * turned;
  }
  let x = 0, z = 0;
  found[3] = list[at + AT_X];
  found[4] = list[at + AT_Z];
  for (let k = 0; k < count; k++) {
    const frame = (found[5 * k] % WALK_FRAMES) * TOUCH, p = own_touch + frame, on = found[5 * k + 5] > found[5 * k] ? 2 : 0;
    const point = (shift, share, axis) => {
      const rest = (before_it >= 0 ? touches[rest_touch + frame + shift + axis] : touches[p + 4 + axis]) * scale;
      return rest + (touches[p + shift + axis] * scale - rest) * share;
    };
    const turned = (heading, px, pz) => [Math.cos(heading) * px + Math.sin(heading) * pz,
                                         Math.cos(heading) * pz - Math.sin(heading) * px];
    const s0 = found[5 * k + 1], s1 = found[5 * k + 6];
    const before = turned(found[5 * k + 2], point(0, s0, 0), point(0, s0, 1));
    const after = turned(found[5 * k + 7], point(on, s1, 0), point(on, s1, 1));
    x += before[0] - after[0];
    z += before[1] - after[1];
    found[5 * k + 8] = found[3] + x;
    found[5 * k + 9] = found[4] + z;
  }
  return found;
}

// Two frames of which the second has a share of at most a half.
function putPose(row, i, x, z, heading, clip, frame, other, second, share) {
  if (share > 0.5) return putPose(row, i, x, z, heading, other, second, clip, frame, 1 - share);
  row[i] = BY_FOOTINGS;
  row[i + 1] = x;
  row[i + 2] = z;
  row[i + 3] = heading;
  row[i + 4] = frame;
  row[i + 5] = share;
  row[i + 11] = clip;
  row[i + 16] = other * CLIP_STEP + second;
}

// Everybody of a pack that acts a scenario: `arrays` are those of acted.bin, `clones` how many there are.
function actedOf(arrays, clones) {
  const { starts, people } = arrays, count = starts.length - 1, kinds = arrays.clips.length / 2 / clones;
  let { touches, clips } = arrays;
  const ways = Array.from({ length: count }, (_, who) => arrays.footings.subarray(FOOTING * starts[who], FOOTING * starts[who + 1]));
  const current = new Uint32Array(count), gone = new Uint32Array(count), known = new Int32Array(count).fill(-1), parts = [];

  function fill(who, now, rows) {
    const i = who * 4 * PERSON_TEXELS, own = ways[who], many = own.length / FOOTING;
    let k = current[who] - gone[who];
    if (k < 0 || k >= many || now < own[k * FOOTING + FROM]) k = 0;
    while (k + 1 < many && now >= own[(k + 1) * FOOTING + FROM]) k++;
    current[who] = gone[who] + k;
    const at = k * FOOTING, clone = rows[i + 6], scale = rows[i + 7], clip = own[at + CLIP];
    if (!many || now < own[at + FROM] || now >= own[at + UNTIL]) { rows[i] = GONE; return; }
    const length = clips[2 * (clone * kinds + clip)], seconds = clips[2 * (clone * kinds + clip) + 1];
    const since = now - own[at + FROM], heading = own[at + HEADING];
    if (own[at + LAST] < 0) {
      const whole = own[at + FIRST] + since / seconds, place = (whole - Math.floor(whole)) * length;
      const frame = Math.min(Math.floor(place), length - 1);
      let x = own[at + AT_X], z = own[at + AT_Z];
      if (own[at + OTHER] >= 0 && since < BLEND_S) {
        const share = 1 - smooth(since / BLEND_S);
        x += (own[at + SHARE] - x) * share;
        z += (own[at + SHARE_LAST] - z) * share;
        putPose(rows, i, x, z, heading, clip, frame, own[at + OTHER], -1 - own[at + LAST], share);
      } else putPose(rows, i, x, z, heading, clip, frame, clip, (frame + 1) % length, place - frame);
      return;
    }
    if (known[who] !== current[who]) {
      parts[who] = partsOf(own, at, touches, clone * kinds * WALK_FRAMES * TOUCH, scale);
      known[who] = current[who];
    }
    const found = parts[who], last = found.length / 5 - 1;
    const place = (since / (own[at + UNTIL] - own[at + FROM])) * last, n = Math.min(Math.floor(place), last - 1);
    const p = 5 * n, frame = found[p] % length;
    if (found[p + 1] >= 1 && found[p + 6] >= 1) {
      const share = place - n, between = (k) => found[p + k] + (found[p + 5 + k] - found[p + k]) * share;
      putPose(rows, i, between(3), between(4), between(2), clip, frame, clip, (frame + 1) % length,
              found[p + 5] > found[p] ? share : 0);
    } else {
      const other = own[at + OTHER], [rest, second] = other >= 0 ? [IDLE, other] : [-1 - other, frame];
      putPose(rows, i, found[p + 3], found[p + 4], found[p + 2], clip, frame, rest, second, 1 - found[p + 1]);
    }
  }

  const long = (list, more) => { const grown = new Float32Array(more); grown.set(list); return grown; };
  return {
    count, people, current,
    walks: (who) => ways[who][(current[who] - gone[who]) * FOOTING + LAST] >= 0,
    at(now, rows, time = () => now) { for (let who = 0; who < count; who++) fill(who, time(who), rows); },
    // As which walk somebody feels now, and how much of it the face shows: `at` was asked for this time.
    felt(who, now) {
      const own = ways[who], k = current[who] - gone[who], at = k * FOOTING;
      if (k < 0 || at >= own.length) return [0, 0];
      const feels = own[at + FEELS], before = own[Math.max(k - 1, 0) * FOOTING + FEELS], since = (now - own[at + FROM]) / FEELS_S;
      return [since < 0.5 ? before : feels, before === feels ? 1 : Math.abs(2 * Math.min(since, 1) - 1)];
    },
    // A clone that was not there at first, as the next one or in another's stead.
    dress(clone, own_touches, own_clips) {
      if ((clone + 1) * own_touches.length > touches.length) touches = long(touches, (clone + 1) * own_touches.length);
      if ((clone + 1) * own_clips.length > clips.length) clips = long(clips, (clone + 1) * own_clips.length);
      touches.set(own_touches, clone * own_touches.length);
      clips.set(own_clips, clone * own_clips.length);
    },
    // Somebody is somebody else now: what was worked out for the other one's feet is not kept.
    turn(who, row) { people.set(row, who * 4 * PERSON_TEXELS); known[who] = -1; },
    // Somebody's footings from now on.
    begin(who, own) { ways[who] = own; gone[who] = current[who] = 0; known[who] = -1; },
    // More footings; the last one may have become longer. What is over for long is not kept.
    go_on(who, own, now) {
      const past = ways[who], many = past.length / FOOTING;
      let first = 0, last = many;
      while (first < many && past[first * FOOTING + UNTIL] < now - PAST_S) first++;
      while (last > first && past[(last - 1) * FOOTING + FROM] >= own[FROM]) last--;
      const kept = past.subarray(first * FOOTING, last * FOOTING), grown = long(kept, kept.length + own.length);
      grown.set(own, kept.length);
      ways[who] = grown;
      gone[who] += first;
    },
    first: (who) => ways[who].slice(0, FOOTING),
  };
}
