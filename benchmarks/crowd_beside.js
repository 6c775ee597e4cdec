// Others' ways of drawing the same people, for crowd_frames.py: three's skinned meshes with a mixer each, and the levels of
// a pack's glTF as instances of @three.ez/instanced-mesh, whose bones a processor sets. Bundled by esbuild; never shipped.
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { clone } from "three/addons/utils/SkeletonUtils.js";
import { createInstancedMesh2From } from "@three.ez/instanced-mesh";

const LEVELS_M = [0, 9.2, 15.8, 30.4]; // where a person of 1.75 m is as tall as each level is good for

async function opened(base64) {
  const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
  return new GLTFLoader().parseAsync(bytes.buffer, "");
}

function stage() {
  const canvas = document.createElement("canvas");
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
  renderer.setSize(1280, 720, false);
  const camera = new THREE.PerspectiveCamera(45, 1280 / 720, 0.1, 1200), scene = new THREE.Scene();
  camera.position.set(0, 1.7, 0);
  camera.lookAt(0, 1.4, -40);
  scene.add(new THREE.HemisphereLight(0xffffff, 0x888888, 2), new THREE.DirectionalLight(0xffffff, 1));
  return { renderer, camera, scene };
}

function timed({ renderer, camera, scene }, before, times) {
  const gl = renderer.getContext(), pixel = new Uint8Array(4), found = [];
  for (let k = 0; k < times; k++) {
    const begun = performance.now();
    before(k / 16);
    renderer.render(scene, camera);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    found.push(performance.now() - begun);
  }
  return { found, draws: renderer.info.render.calls, triangles: renderer.info.render.triangles };
}

// places: x, z, heading of each person
export async function naive(files, places, times) {
  const own = stage(), gltfs = await Promise.all(files.map(opened)), mixers = [];
  places.forEach(([x, z, heading], k) => {
    const gltf = gltfs[k % gltfs.length], person = clone(gltf.scene), mixer = new THREE.AnimationMixer(person);
    person.position.set(x, 0, z);
    person.rotation.y = heading;
    mixer.clipAction(THREE.AnimationClip.findByName(gltf.animations, "walk")).play();
    mixer.setTime(k * 0.37);
    mixers.push(mixer);
    own.scene.add(person);
  });
  return timed(own, () => mixers.forEach((mixer) => mixer.update(1 / 30)), times);
}

export async function instanced(files, places, times) {
  const own = stage(), people = [];
  for (const [which, file] of files.entries()) {
    const gltf = await opened(file), mine = places.filter((_, k) => k % files.length === which);
    const mixer = new THREE.AnimationMixer(gltf.scene), meshes = [];
    mixer.clipAction(THREE.AnimationClip.findByName(gltf.animations, "walk")).play();
    gltf.scene.updateMatrixWorld(true);
    const parts = (level) => {
      const found = [];
      gltf.scene.traverse((node) => { if (node.isSkinnedMesh && (node.name + node.parent.name).includes(`LOD${level}`)) found.push(node); });
      return found;
    };
    const finest = parts(0), others = [1, 2, 3].map(parts);
    finest.forEach((mesh, part) => {
      const many = createInstancedMesh2From(mesh, { capacity: mine.length, renderer: own.renderer });
      many.initSkeleton(mesh.skeleton);
      others.forEach((level, k) => many.addLOD(level[part].geometry, level[part].material, LEVELS_M[k + 1]));
      many.addInstances(mine.length, (one, k) => {
        const [x, z, heading] = mine[k];
        one.position.set(x, 0, z);
        one.quaternion.setFromAxisAngle(new THREE.Vector3(0, 1, 0), heading);
      });
      own.scene.add(many);
      meshes.push(many);
    });
    people.push((now) => {
      for (let k = 0; k < mine.length; k++) {
        mixer.setTime(now + k * 0.37);
        meshes.forEach((many) => many.setBonesAt(k));
      }
    });
  }
  return timed(own, (now) => people.forEach((move) => move(now)), times);
}
