// Bundled with esbuild: shows a GLB, a VRM or a flat VRML with three.js, a moment into its motion, and tells what it saw.
import { AmbientLight, AnimationMixer, Box3, Color, DirectionalLight, PerspectiveCamera, Scene, Vector3,
  WebGLRenderer } from "three";
import { MeshoptDecoder } from "three/examples/jsm/libs/meshopt_decoder.module.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { VRMLLoader } from "three/examples/jsm/loaders/VRMLLoader.js";
import { VRMLoaderPlugin } from "@pixiv/three-vrm";

const { kind, at, pictures } = window.asked;
const bytes = Uint8Array.from(atob(document.querySelector("#file").textContent), (c) => c.charCodeAt(0));
const wait = (milliseconds) => new Promise((done) => setTimeout(done, milliseconds));

async function load() {
  if (kind === "wrl") return { scene: new VRMLLoader().parse(new TextDecoder().decode(bytes), pictures), animations: [] };
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
  if (kind === "vrm") loader.register((parser) => new VRMLoaderPlugin(parser));
  const gltf = await loader.parseAsync(bytes.buffer, "");
  const vrm = gltf.userData.vrm;
  if (vrm) {
    vrm.humanoid.getNormalizedBoneNode("leftUpperArm").rotation.z = 1.0;
    vrm.expressionManager.setValue("happy", 1);
    vrm.update(0.016);
  }
  return { scene: vrm ? vrm.scene : gltf.scene, animations: vrm ? [] : gltf.animations };
}

function points(scene) {
  const found = [];
  scene.updateMatrixWorld(true);
  scene.traverse((mesh) => {
    if (!mesh.isMesh) return;
    mesh.geometry.computeBoundingSphere();
    if (mesh.geometry.boundingSphere.radius > 100) return; // the sky of a VRML world
    if (mesh.skeleton) mesh.skeleton.update();
    const place = mesh.geometry.attributes.position, point = new Vector3();
    for (let k = 0; k < place.count; k += 97) {
      mesh.getVertexPosition(k, point);
      found.push(point.clone().applyMatrix4(mesh.matrixWorld));
    }
  });
  return found;
}

try {
  const { scene: model, animations } = await load();
  const scene = new Scene();
  scene.background = new Color(0.88, 0.89, 0.9);
  scene.add(model, new AmbientLight(0xffffff, kind === "wrl" ? 0.5 : 1.6));
  const sun = new DirectionalLight(0xffffff, 2.2);
  sun.position.set(-1, 2, 3);
  scene.add(sun);
  const before = points(model);
  const walk = animations.find((one) => one.name === "walk");
  if (walk) {
    const mixer = new AnimationMixer(model);
    mixer.clipAction(walk).play();
    mixer.setTime(at);
  }
  const after = points(model);
  const box = new Box3().setFromPoints(after), middle = box.getCenter(new Vector3()), size = box.getSize(new Vector3());
  const camera = new PerspectiveCamera(28, innerWidth / innerHeight, 0.05, 50000);
  const away = 1.12 * Math.max(size.y, size.x * innerHeight / innerWidth) / 2 / Math.tan((14 * Math.PI) / 180);
  camera.position.set(middle.x + 0.42 * away, middle.y, middle.z + 0.9 * away);
  camera.lookAt(middle);
  const renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
  renderer.setSize(innerWidth, innerHeight);
  document.body.append(renderer.domElement);
  for (let k = 0; k < 8; k += 1) {
    renderer.render(scene, camera);
    await wait(120);
  }
  const moved = Math.max(...after.map((point, k) => point.distanceTo(before[k])));
  let joints = 0, targets = 0;
  model.traverse((one) => {
    if (one.isSkinnedMesh) joints = Math.max(joints, one.skeleton.bones.length);
    if (one.isMesh && one.morphTargetInfluences) targets = Math.max(targets, one.morphTargetInfluences.length);
  });
  const meshes = renderer.info.render.calls, clips = animations.length;
  window.result = { height_m: size.y, moved_m: moved, meshes, joints, clips, targets };
} catch (error) {
  window.result = { error: String(error && error.stack ? error.stack : error) };
}
