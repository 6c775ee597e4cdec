"use strict";
// Who stands on what, when: the same as cloner/crowd/footing.py, number for number.

const [FROM, UNTIL, CLIP, OTHER, FIRST, LAST, SHARE, SHARE_LAST, AT_X, AT_Z, HEADING, HEADING_LAST] = [...Array(12).keys()];
const FOOTING = 12, LEFT = 3, RIGHT = 27, ALONE = 2, SHARED = 21, LIFT_PARTS = 8, TURN_PARTS = 28, BLEND_S = 0.4;
const WALK_FRAMES = 48, TOUCH = 6, BY_FOOTINGS = 3, GONE = 4, CLIP_STEP = 1024, ACTED = "scenario";

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
  let { footings, touches, clips } = arrays;
  const begins = Uint32Array.from(starts.subarray(0, count)), ends = Uint32Array.from(starts.subarray(1));
  const current = begins.slice(), known = new Int32Array(count).fill(-1), parts = [], before = new Map();

  function fill(who, now, rows) {
    const i = who * 4 * PERSON_TEXELS;
    let k = current[who];
    if (now < footings[k * FOOTING + FROM]) k = begins[who];
    while (k + 1 < ends[who] && now >= footings[(k + 1) * FOOTING + FROM]) k++;
    current[who] = k;
    const at = k * FOOTING, clone = rows[i + 6], scale = rows[i + 7], clip = footings[at + CLIP];
    if (now < footings[at + FROM] || now >= footings[at + UNTIL]) { rows[i] = GONE; return; }
    const length = clips[2 * (clone * kinds + clip)], seconds = clips[2 * (clone * kinds + clip) + 1];
    const since = now - footings[at + FROM], heading = footings[at + HEADING];
    if (footings[at + LAST] < 0) {
      const whole = footings[at + FIRST] + since / seconds, place = (whole - Math.floor(whole)) * length;
      const frame = Math.min(Math.floor(place), length - 1);
      let x = footings[at + AT_X], z = footings[at + AT_Z];
      if (footings[at + OTHER] >= 0 && since < BLEND_S) {
        const share = 1 - smooth(since / BLEND_S);
        x += (footings[at + SHARE] - x) * share;
        z += (footings[at + SHARE_LAST] - z) * share;
        putPose(rows, i, x, z, heading, clip, frame, footings[at + OTHER], -1 - footings[at + LAST], share);
      } else putPose(rows, i, x, z, heading, clip, frame, clip, (frame + 1) % length, place - frame);
      return;
    }
    if (known[who] !== k) {
      parts[who] = partsOf(footings, at, touches, clone * kinds * WALK_FRAMES * TOUCH, scale);
      known[who] = k;
    }
    const own = parts[who], last = own.length / 5 - 1;
    const place = (since / (footings[at + UNTIL] - footings[at + FROM])) * last, n = Math.min(Math.floor(place), last - 1);
    const p = 5 * n, frame = own[p] % length;
    if (own[p + 1] >= 1 && own[p + 6] >= 1) {
      const share = place - n, between = (k) => own[p + k] + (own[p + 5 + k] - own[p + k]) * share;
      putPose(rows, i, between(3), between(4), between(2), clip, frame, clip, (frame + 1) % length,
              own[p + 5] > own[p] ? share : 0);
    } else {
      const other = footings[at + OTHER], [rest, second] = other >= 0 ? [IDLE, other] : [-1 - other, frame];
      putPose(rows, i, own[p + 3], own[p + 4], own[p + 2], clip, frame, rest, second, 1 - own[p + 1]);
    }
  }

  const walks = (who) => footings[current[who] * FOOTING + LAST] >= 0;
  const long = (list, more) => { const grown = new Float32Array(more); grown.set(list.subarray(0, more)); return grown; };
  return {
    count, people, current, walks,
    at(now, rows, time = () => now) { for (let who = 0; who < count; who++) fill(who, time(who), rows); },
    // A clone that was not there at first, as the next one or in another's stead.
    dress(clone, own_touches, own_clips) {
      if ((clone + 1) * own_touches.length > touches.length) touches = long(touches, (clone + 1) * own_touches.length);
      if ((clone + 1) * own_clips.length > clips.length) clips = long(clips, (clone + 1) * own_clips.length);
      touches.set(own_touches, clone * own_touches.length);
      clips.set(own_clips, clone * own_clips.length);
    },
    // Somebody's part is taken by who has footings and a row of his own.
    take(who, own, row) {
      const at = who * 4 * PERSON_TEXELS, first = footings.length / FOOTING;
      if (!before.has(who)) before.set(who, people.slice(at, at + 4 * PERSON_TEXELS));
      footings = long(footings, footings.length + own.length);
      footings.set(own, first * FOOTING);
      begins[who] = current[who] = first;
      ends[who] = footings.length / FOOTING;
      people.set(row, at);
    },
    // And given back.
    give(who) {
      begins[who] = current[who] = starts[who];
      ends[who] = starts[who + 1];
      people.set(before.get(who), who * 4 * PERSON_TEXELS);
      before.delete(who);
    },
  };
}
