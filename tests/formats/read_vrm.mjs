// Bundled by the test: reads the VRM inside the page with the format's own reader and tells what it found.
import { Object3D, Quaternion, Vector3 } from "three";
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
    const eyeTurned = (x_m, y_m) => {
      // The target hangs on the head, a metre before the eyes: where it stands is the angle that the format speaks of.
      const target = new Object3D();
      vrm.scene.updateMatrixWorld(true);
      const from = vrm.lookAt.getLookAtWorldPosition(new Vector3());
      target.position.copy(from).add(new Vector3(x_m, y_m, 1));
      vrm.scene.add(target);
      vrm.lookAt.target = target;
      vrm.update(0.016);
      return ["leftEye", "rightEye"].map((bone) => {
        const ahead = new Vector3(0, 0, 1).applyQuaternion(vrm.humanoid.getRawBoneNode(bone).getWorldQuaternion(new Quaternion()));
        return [Math.atan2(ahead.x, ahead.z), Math.asin(ahead.y)].map((angle) => (angle * 180) / Math.PI);
      });
    };
    const gaze = { left: eyeTurned(1, 0), up: eyeTurned(0, 1), down: eyeTurned(0, -1) };
    let mesh = null;
    vrm.scene.traverse((node) => { if (!mesh && node.morphTargetDictionary) mesh = node; });
    const springs = () => {
      const manager = vrm.springBoneManager;
      if (!manager || manager.joints.size === 0) return null;
      const head = vrm.humanoid.getRawBoneNode("head");
      const joints = [...manager.joints];
      const tip = joints[joints.length - 1].child;
      const tipAt = () => (vrm.scene.updateMatrixWorld(true), tip.getWorldPosition(new Vector3()));
      const nearest = () => Math.min(...joints.flatMap((joint) => joint.colliderGroups.flatMap((group) => group.colliders.map(
        (one) => one.shape.calculateCollision(one.matrixWorld, joint.child.getWorldPosition(new Vector3()), 0, new Vector3())))));
      const run = (frames) => { for (let k = 0; k < frames; k++) vrm.update(1 / 60); };
      const normalised = vrm.humanoid.getNormalizedBoneNode("head");
      const first = tipAt();
      run(180);
      const rest = tipAt();
      const held = head.worldToLocal(rest.clone());
      normalised.rotation.y = 1;
      run(1);
      const rigid = (vrm.scene.updateMatrixWorld(true), head.localToWorld(held.clone()));
      const lag = tipAt().distanceTo(rigid);
      run(180);
      const before = tipAt();
      run(1);
      const still = tipAt().distanceTo(before);
      normalised.rotation.set(0, 0, 0);
      const inside = [-0.6, 0.6].map((nod) => { normalised.rotation.x = nod; run(180); return nearest(); });
      normalised.rotation.set(0, 0, 0);
      return {
        joints: joints.length, colliders: manager.colliders.length, sag_m: rest.distanceTo(first), lag_m: lag,
        still_m: still, inside_m: inside,
      };
    };
    const hems = () => {
      const joints = [...(vrm.springBoneManager?.joints ?? [])].filter((joint) => joint.bone.name.startsWith("hem"));
      if (joints.length === 0) return null;
      const at = () => (vrm.scene.updateMatrixWorld(true), joints.map((joint) => joint.child.getWorldPosition(new Vector3())));
      const farthest = (a, b) => Math.max(...a.map((point, k) => point.distanceTo(b[k])));
      const nearest = () => Math.min(...joints.flatMap((joint) => joint.colliderGroups.flatMap((group) => group.colliders.map(
        (one) => one.shape.calculateCollision(one.matrixWorld, joint.child.getWorldPosition(new Vector3()), 0, new Vector3())))));
      const run = (frames) => { for (let k = 0; k < frames; k++) vrm.update(1 / 60); };
      const first = at();
      run(180);
      const rest = at(), inside = [nearest()];
      const thigh = vrm.humanoid.getNormalizedBoneNode("leftUpperLeg"), knee = vrm.humanoid.getNormalizedBoneNode("leftLowerLeg");
      thigh.rotation.x = -0.6;
      knee.rotation.x = 0.3;
      run(1);
      const sudden = at();
      run(180);
      const lifted = at();
      inside.push(nearest());
      run(1);
      const still = farthest(at(), lifted);
      thigh.rotation.set(0, 0, 0);
      knee.rotation.set(0, 0, 0);
      run(180);
      return {
        joints: joints.length, sag_m: farthest(first, rest), lag_m: farthest(sudden, lifted), lift_m: farthest(rest, lifted),
        still_m: still, back_m: farthest(at(), rest), inside_m: inside,
      };
    };
    const skirt = hems(), swinging = springs();
    window.result = {
      springs: swinging,
      hems: skirt,
      metaVersion: vrm.meta.metaVersion,
      bones: Object.keys(vrm.humanoid.humanBones),
      expressions: vrm.expressionManager.expressions.map((one) => one.expressionName),
      lookAt: Boolean(vrm.lookAt),
      gaze_deg: gaze,
      name: vrm.meta.name,
      authors: vrm.meta.authors,
      hips_m: hips,
      hand_raised_m: Math.abs(place("leftHand").y - before),
      blink_weight: mesh.morphTargetInfluences[mesh.morphTargetDictionary.eyeBlinkLeft],
    };
  },
  (error) => { window.result = { error: String(error) }; },
);
