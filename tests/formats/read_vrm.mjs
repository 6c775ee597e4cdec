// Bundled by the test: reads the VRM inside the page with the format's own reader and tells what it found.
import { Vector3 } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { VRMLoaderPlugin } from "@pixiv/three-vrm";

const bytes = Uint8Array.from(atob(document.querySelector("#vrm").textContent), (c) => c.charCodeAt(0)).buffer;
const loader = new GLTFLoader();
loader.register((parser) => new VRMLoaderPlugin(parser));
loader.parse(
  bytes,
  "",
  (gltf) => {
    const vrm = gltf.userData.vrm;
    const place = (bone) => {
      vrm.scene.updateMatrixWorld(true);
      return vrm.humanoid.getRawBoneNode(bone).getWorldPosition(new Vector3());
    };
    const before = place("leftHand").y;
    const hips = place("hips").y;
    vrm.humanoid.getNormalizedBoneNode("leftUpperArm").rotation.z = 1;
    vrm.expressionManager.setValue("blink", 1);
    vrm.update(0.016);
    let mesh = null;
    vrm.scene.traverse((node) => { if (!mesh && node.morphTargetDictionary) mesh = node; });
    window.result = {
      metaVersion: vrm.meta.metaVersion,
      bones: Object.keys(vrm.humanoid.humanBones),
      expressions: vrm.expressionManager.expressions.map((one) => one.expressionName),
      lookAt: Boolean(vrm.lookAt),
      hips_m: hips,
      hand_raised_m: Math.abs(place("leftHand").y - before),
      blink_weight: mesh.morphTargetInfluences[mesh.morphTargetDictionary.eyeBlinkLeft],
    };
  },
  (error) => { window.result = { error: String(error) }; },
);
