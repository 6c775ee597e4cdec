"use strict";
// Steps and murmur, made here and heard from where people are, in the room's own echo; silent until somebody asks.

const HEARD_M = 14, VOICES = 4, MOST_STEPS = 10, CHOSEN_S = 1, STEP_LOUD = 0.5, MURMUR_LOUD = 0.12, WET = 0.9, DRIFT_S = 0.3, MOUTH_M = 1.55; // taste

// A buffer of noise shaped by a function of seconds; the same numbers every time.
function noiseOf(context, seconds, shape) {
  const buffer = context.createBuffer(1, Math.ceil(seconds * context.sampleRate), context.sampleRate);
  const data = buffer.getChannelData(0), dice = new Dice(5);
  for (let k = 0; k < data.length; k++) data[k] = (2 * dice.roll() - 1) * shape(k / context.sampleRate);
  return buffer;
}

// A heel: a click and a thump.
function heelOf(context) {
  const buffer = noiseOf(context, 0.14, (t) => 0.7 * Math.exp(-t / 0.006) + 0.12 * Math.exp(-t / 0.03));
  const data = buffer.getChannelData(0);
  for (let k = 0; k < data.length; k++) {
    const t = k / context.sampleRate;
    data[k] += 0.5 * Math.sin(2 * Math.PI * 95 * t) * Math.exp(-t / 0.035);
  }
  return buffer;
}

// Somebody who talks on a thing not understood: syllables, four or five a second, with pauses.
function talkOf(context) {
  const dice = new Dice(11), marks = [];
  for (let t = 0; t < 6;) {
    const long = 0.1 + 0.16 * dice.roll(), pause = dice.roll() < 0.15 ? 0.5 : 0.03;
    marks.push([t, t + long, 0.4 + 0.6 * dice.roll()]);
    t += long + pause;
  }
  let at = 0;
  return noiseOf(context, 6, (t) => {
    while (at + 1 < marks.length && t > marks[at][1]) at++;
    const [from, until, loud] = marks[at];
    return t < from || t > until ? 0 : loud * Math.sin((Math.PI * (t - from)) / (until - from));
  });
}

// `echo` is a WAV's bytes or null; `inside` tells how much of the echo is heard at a place; `speech` are WAVs by name.
async function soundOf(echo, inside, speech) {
  const context = new AudioContext(), out = context.createGain();
  out.connect(context.destination);
  let wet = null;
  if (echo) {
    const room = context.createConvolver();
    room.buffer = await context.decodeAudioData(echo.slice().buffer);
    wet = context.createGain();
    wet.connect(room).connect(out);
  }
  const spoken = {}, speaking = new Map();
  for (const [name, bytes] of Object.entries(speech)) spoken[name] = await context.decodeAudioData(bytes.slice().buffer);
  const heel = heelOf(context), talk = talkOf(context), last = [];
  const placed = () => {
    const panner = new PannerNode(context, { panningModel: "HRTF", distanceModel: "inverse", refDistance: 1, rolloffFactor: 1 });
    panner.connect(out);
    if (wet) panner.connect(wet);
    return panner;
  };
  const put = (panner, x, y, z) => {
    panner.positionX.value = x;
    panner.positionY.value = y;
    panner.positionZ.value = z;
  };
  const voices = Array.from({ length: VOICES }, (_, k) => {
    const source = new AudioBufferSourceNode(context, { buffer: talk, loop: true, playbackRate: 0.8 + 0.14 * k });
    const throat = new BiquadFilterNode(context, { type: "bandpass", frequency: 480 + 130 * k, Q: 1.4 });
    const gain = new GainNode(context, { gain: 0 }), panner = placed();
    source.connect(throat).connect(gain).connect(panner);
    source.start(0, 1.3 * k);
    return { gain, panner };
  });
  let chosen = -9;
  const sound = {
    context, steps: 0, speaking,
    // Who says what now, from where the mouth is; what is paused, or begins again, ends.
    speak(said, now, paused, { x, y, z }) {
      if (context.state !== "running") return;
      said.forEach((one, k) => {
        const buffer = spoken[one.sound], at = now - one.when, goes = speaking.get(k);
        const wanted = buffer && !paused && at >= 0 && at < buffer.duration;
        if (goes && (!wanted || Math.abs(context.currentTime - goes.since - at) > DRIFT_S)) {
          goes.source.stop();
          goes.panner.disconnect();
          speaking.delete(k);
        }
        if (!wanted) return;
        if (!speaking.has(k)) {
          const source = new AudioBufferSourceNode(context, { buffer }), panner = placed();
          source.connect(panner);
          source.start(0, at);
          speaking.set(k, { source, panner, since: context.currentTime - at });
        }
        put(speaking.get(k).panner, x[one.who], y[one.who] + MOUTH_M, z[one.who]);
      });
    },
    // What is heard by this eye of these people now.
    hear(eye, ahead, { x, y, z, rows, count }, acted) {
      const ear = context.listener, now = context.currentTime;
      for (const [name, value] of [["positionX", eye.x], ["positionY", eye.y], ["positionZ", eye.z], ["forwardX", ahead.x],
                                   ["forwardY", ahead.y], ["forwardZ", ahead.z]]) if (ear[name]) ear[name].value = value;
      if (wet) wet.gain.value = WET * inside(eye.x, eye.z);
      const near = [];
      let played = 0;
      for (let i = 0; i < count; i++) {
        const at = i * 4 * PERSON_TEXELS, far = Math.hypot(x[i] - eye.x, z[i] - eye.z);
        const foot = acted.current[i], moved = last[i] !== undefined && foot === last[i] + 1;
        last[i] = foot;
        if (far > HEARD_M || rows[at] >= GONE || rows[at + STONE] > 0.5) continue;
        if (!acted.walks(i)) near.push([far, i]);
        if (!moved || !acted.walks(i) || played >= MOST_STEPS) continue;
        played++;
        sound.steps++;
        const source = new AudioBufferSourceNode(context, { buffer: heel, playbackRate: 0.85 + 0.3 * ((i * 0.618) % 1) });
        const gain = new GainNode(context, { gain: STEP_LOUD }), panner = placed();
        put(panner, x[i], y[i] + 0.05, z[i]);
        source.connect(gain).connect(panner);
        source.onended = () => panner.disconnect();
        source.start();
      }
      if (now - chosen < CHOSEN_S) return;
      chosen = now;
      near.sort((a, b) => a[0] - b[0]);
      voices.forEach(({ gain, panner }, k) => {
        const who = near[k] ? near[k][1] : -1;
        gain.gain.setTargetAtTime(who < 0 ? 0 : MURMUR_LOUD, now, 0.3);
        if (who >= 0) put(panner, x[who], y[who] + 1.5, z[who]);
      });
    },
  };
  return sound;
}
