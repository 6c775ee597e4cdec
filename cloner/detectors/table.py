"""Registry of the detectors; each loads on first use."""

from __future__ import annotations

from cloner.registry import Registry

DETECTORS = Registry("detector")
DETECTORS.add("people", "cloner.detectors.nets.people:detect_people")
DETECTORS.add("pose", "cloner.detectors.nets.litert:detect_pose")
DETECTORS.add("padded_pose", "cloner.detectors.nets.people:padded_pose")
DETECTORS.add("pose_in_mask", "cloner.detectors.nets.people:pose_in_mask")
DETECTORS.add("label_features", "cloner.detectors.nets.litert:label_features")
DETECTORS.add("release_nets", "cloner.detectors.nets.litert:release_nets")
DETECTORS.add("face", "cloner.detectors.nets.litert:detect_face")
DETECTORS.add("guessed_face", "cloner.detectors.nets.litert:guess_hidden_face")
DETECTORS.add("refined_face", "cloner.detectors.face.face_curves:refine_face")
DETECTORS.add("body_points", "cloner.detectors.body.body_points:propose_body_points")
DETECTORS.add("face_points", "cloner.detectors.face.face_points:propose_face_points")
DETECTORS.add("complete_face", "cloner.detectors.face.face_points:complete_face")
