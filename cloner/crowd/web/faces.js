"use strict";
// Who speaks in a film, who feels what, and how faces move then: the same rules as cloner/crowd/staged/faces.py.

const SPOKEN_HZ = 30, MOST_AT_ONCE = 8, FACE_WEIGHTS = 20;
const MOVES = { format: THREE.RGBAIntegerFormat, type: THREE.ShortType, internalFormat: "RGBA16I" };
const ROWS = { format: THREE.RedIntegerFormat, type: THREE.UnsignedShortType, internalFormat: "R16UI" };

// What person.vert reads of faces, which are still until somebody speaks.
function faceUniforms() {
  return {
    faces: { value: arrayTexture(new Int16Array(4), 1, 1, 1, MOVES) },
    faceRows: { value: flatTexture(new Uint16Array(1), 1, 1, ROWS) }, faceHigh: { value: 1 },
    feels: { value: flatTexture(new Float32Array(4), 1, 1, FLOATS) }, faced: { value: 0 },
    speakers: { value: 0 }, speaks: { value: new Array(MOST_AT_ONCE).fill(-1) },
    mouths: { value: new Float32Array(MOST_AT_ONCE * FACE_WEIGHTS) },
  };
}

// `rows` tells where each of the body's vertices lies in a face; `moves` are each clone's, one target after another.
function faceTextures(rows, moves) {
  const targets = FACE_WEIGHTS + facts.faces.feelings.length, count = moves[0].length / 3 / targets, high = Math.ceil(count / WIDE);
  const data = new Int16Array(moves.length * targets * high * WIDE * 4);
  moves.forEach((own, clone) => {
    for (let t = 0; t < targets; t++)
      for (let k = 0; k < count; k++)
        for (let axis = 0, to = ((clone * targets + t) * high * WIDE + k) * 4; axis < 3; axis++) data[to + axis] = own[(t * count + k) * 3 + axis];
  });
  const tall = Math.ceil(rows.length / WIDE), padded = new Uint16Array(tall * WIDE);
  padded.set(rows);
  return {
    faces: arrayTexture(data, WIDE, targets * high, moves.length, MOVES),
    faceRows: flatTexture(padded, WIDE, tall, ROWS), faceHigh: high,
  };
}

// Everybody's face anew, in place of what uniforms had.
function dressFaces(uniforms, body, people) {
  const { faceHigh, ...made } = faceTextures(body.face, people.map((one) => one.face));
  uniforms.faceHigh.value = faceHigh;
  for (const [name, texture] of Object.entries(made)) {
    uniforms[name].value.dispose();
    uniforms[name].value = texture;
  }
}

// What faces of those who act show: a texture of which feeling, from 1, and how much of it.
function feelingsOf(count) {
  const { feelings } = facts.faces, names = facts.people[0].clips.map((one) => one.name);
  const shown = names.map((name) => feelings.indexOf(name) + 1), rows = Math.ceil(count / ROW), data = new Float32Array(rows * ROW * 4);
  const texture = flatTexture(data, ROW, rows, FLOATS);
  return {
    texture,
    feel(acted, now) {
      for (let who = 0; who < count; who++) {
        const [clip, share] = acted.felt(who, now);
        data[4 * who] = shown[clip];
        data[4 * who + 1] = share;
      }
      texture.needsUpdate = true;
    },
  };
}

// `weights` are the rows that `said` speaks of.
function spokenOf(said, weights) {
  return {
    said,
    move({ speakers, speaks, mouths }, now) {
      const who = speaks.value.fill(-1);
      let count = 0;
      mouths.value.fill(0);
      for (const one of said) {
        const at = (now - one.when) * SPOKEN_HZ;
        if (at < 0 || at > one.frames - 1 || who.includes(one.who) || count === MOST_AT_ONCE) continue;
        const row = Math.min(Math.floor(at), Math.max(one.frames - 2, 0)), share = at - row;
        const first = (one.first + row) * FACE_WEIGHTS, last = (one.first + Math.min(row + 1, one.frames - 1)) * FACE_WEIGHTS;
        for (let t = 0; t < FACE_WEIGHTS; t++)
          mouths.value[count * FACE_WEIGHTS + t] = weights[first + t] + (weights[last + t] - weights[first + t]) * share;
        who[count++] = one.who;
      }
      speakers.value = count;
    },
  };
}
