"use strict";
// Shows the clone that lies in this page: it turns by itself until somebody takes hold of it.

const MOODS = {
  smile: { mouthSmileLeft: 0.8, mouthSmileRight: 0.8, cheekSquintLeft: 0.4, cheekSquintRight: 0.4 },
  blink: { eyeBlinkLeft: 1, eyeBlinkRight: 1 },
  "open mouth": { jawOpen: 0.6 },
};
const VIEWS = { front: 0, "three quarter": 40, left: 90, back: 180, right: 270 };
const TURN_SECONDS = 14; // taste
const FACE_SHARE = 0.19; // the head and neck's part of a person's height

const canvas = document.querySelector("canvas");
const status = document.querySelector("#status");
const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
const scene = new THREE.Scene();
scene.background = new THREE.Color(0xe2e4e6);
const camera = new THREE.PerspectiveCamera(24, 1, 0.05, 50);
const controls = new THREE.OrbitControls(camera, canvas);
controls.enableDamping = true;
controls.autoRotate = !window.matchMedia("(prefers-reduced-motion: reduce)").matches;
controls.autoRotateSpeed = 60 / TURN_SECONDS;
// Even light: the photos' own light lies in the texture already.
scene.add(new THREE.AmbientLight(0xffffff, 1.6));
const lamp = new THREE.DirectionalLight(0xffffff, 1.5);
lamp.position.set(-1, 2, 3);
camera.add(lamp);
scene.add(camera);

const state = { person: null, bounds: new THREE.Box3(), face: false, mixer: null };

function bytesOf(base64) {
  return Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)).buffer;
}

function frame(degrees) {
  const size = state.bounds.getSize(new THREE.Vector3());
  const target = state.bounds.getCenter(new THREE.Vector3());
  const shown = state.face ? FACE_SHARE * size.y : size.y;
  if (state.face) target.y = state.bounds.max.y - shown / 2;
  const half = Math.tan((camera.fov * Math.PI) / 360);
  const wide = state.face ? shown : Math.max(size.x, size.z);
  const distance = Math.max(shown / half, wide / (half * camera.aspect)) * 0.56 + (state.face ? shown : size.z) / 2;
  const angle = (degrees * Math.PI) / 180;
  camera.position.set(Math.sin(angle) * distance, 0, Math.cos(angle) * distance).add(target);
  controls.target.copy(target);
  controls.update();
}

function azimuth() {
  return (controls.getAzimuthalAngle() * 180) / Math.PI;
}

function setMood(weights) {
  state.person.traverse((node) => {
    if (!node.morphTargetDictionary) return;
    node.morphTargetInfluences.fill(0);
    for (const [name, weight] of Object.entries(weights)) {
      const index = node.morphTargetDictionary[name];
      if (index !== undefined) node.morphTargetInfluences[index] = weight;
    }
  });
}

function button(text, bar, act) {
  const made = document.createElement("button");
  made.textContent = text;
  made.addEventListener("click", () => act(made));
  document.querySelector(bar).append(made);
  return made;
}

function toggle(text, bar, change, on = false) {
  const made = button(text, bar, () => {
    const pressed = made.getAttribute("aria-pressed") !== "true";
    made.setAttribute("aria-pressed", pressed);
    change(pressed, made);
  });
  made.setAttribute("aria-pressed", on);
  return made;
}

function buildButtons(clips) {
  const turning = toggle("turn", "#views", (pressed) => (controls.autoRotate = pressed), controls.autoRotate);
  controls.addEventListener("start", () => {
    controls.autoRotate = false;
    turning.setAttribute("aria-pressed", false);
  });
  for (const [name, degrees] of Object.entries(VIEWS)) button(name, "#views", () => frame(degrees));
  toggle("face", "#views", (pressed) => {
    state.face = pressed;
    frame(azimuth());
  });
  const moods = Object.entries(MOODS).map(([name, weights]) =>
    toggle(name, "#moods", (pressed, made) => {
      for (const other of moods) if (other !== made) other.setAttribute("aria-pressed", false);
      setMood(pressed ? weights : {});
    }),
  );
  for (const clip of clips) {
    toggle(clip.name, "#moods", (pressed) => {
      const action = state.mixer.clipAction(clip);
      if (pressed) action.reset().play();
      else action.stop();
    });
  }
}

function resize() {
  const { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width === width * devicePixelRatio && canvas.height === height * devicePixelRatio) return;
  renderer.setPixelRatio(devicePixelRatio);
  renderer.setSize(width, height, false);
  camera.aspect = width / height;
  camera.updateProjectionMatrix();
  if (state.person) frame(azimuth());
}

const timer = new THREE.Timer();
function draw(now) {
  timer.update(now);
  resize();
  if (state.mixer) state.mixer.update(timer.getDelta());
  controls.update(timer.getDelta());
  renderer.render(scene, camera);
}

new THREE.GLTFLoader().parse(
  bytesOf(document.querySelector("#clone").textContent.trim()),
  "",
  (loaded) => {
    state.person = loaded.scene;
    scene.add(state.person);
    state.bounds.setFromObject(state.person, true);
    state.mixer = new THREE.AnimationMixer(state.person);
    buildButtons(loaded.animations);
    resize();
    frame(VIEWS["three quarter"]);
    status.remove();
    renderer.setAnimationLoop(draw);
    document.body.dataset.ready = "yes";
  },
  (error) => {
    status.textContent = `The clone cannot be shown: ${error.message ?? error}`;
  },
);
