"""Run inside Blender: imports one file, a moment into its motion, and draws it with its software renderer."""

import sys
from math import radians

import numpy

numpy.bool = bool  # the add-on of Debian's Blender 3.4 is older than its NumPy
import bpy  # noqa: E402
from mathutils import Vector  # noqa: E402

path, out, width, height, at = sys.argv[sys.argv.index("--") + 1 :]
bpy.ops.wm.read_factory_settings(use_empty=True)
if path.endswith((".glb", ".gltf", ".vrm")):
    bpy.ops.import_scene.gltf(filepath=path)
elif path.endswith((".wrl", ".x3d")):
    bpy.ops.preferences.addon_enable(module="io_scene_x3d")
    import io_scene_x3d.import_x3d as add_on

    add_on.open = lambda file, mode, **more: open(file, mode.replace("U", ""), **more)  # "U" went with Python 3.11
    bpy.ops.import_scene.x3d(filepath=path, axis_forward="-Z", axis_up="Y")
elif path.endswith(".obj"):
    bpy.ops.wm.obj_import(filepath=path)
elif path.endswith(".ply"):
    (bpy.ops.wm.ply_import if hasattr(bpy.ops.wm, "ply_import") else bpy.ops.import_mesh.ply)(filepath=path)
else:
    bpy.ops.wm.usd_import(filepath=path)
scene = bpy.context.scene
rest = scene.frame_current
for armature in [one for one in bpy.data.objects if one.type == "ARMATURE"]:
    walk = next((one for one in bpy.data.actions if one.name.startswith("walk")), None)
    if walk is not None:
        for track in armature.animation_data.nla_tracks:
            track.mute = True
        armature.animation_data.action = walk
        if hasattr(walk, "slots"):  # since 4.4 an action has a slot for every object that it moves
            armature.animation_data.action_slot = next(
                (slot for slot in walk.slots if slot in list(armature.animation_data.action_suitable_slots)), None
            )


def corners(frame):
    scene.frame_set(frame)
    graph = bpy.context.evaluated_depsgraph_get()
    found = []
    for one in bpy.data.objects:
        if one.type == "MESH" and one.visible_get():
            mesh = one.evaluated_get(graph).to_mesh()
            found += [one.matrix_world @ mesh.vertices[row].co for row in range(0, len(mesh.vertices), 97)]
    return found


before, after = corners(0), corners(round(float(at) * scene.render.fps))
low = Vector([min(point[k] for point in after) for k in range(3)])
high = Vector([max(point[k] for point in after) for k in range(3)])
middle, size = (low + high) / 2, high - low
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
scene.collection.objects.link(camera)
scene.camera = camera
camera.data.sensor_fit = "VERTICAL"
camera.data.angle_y = radians(28)
away = 1.15 * size.z / 2 / 0.2493
camera.location = middle + Vector((0.42 * away, -0.9 * away, 0))
camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.data.energy = 3.0
sun.rotation_euler = (radians(50), 0, radians(-20))
scene.collection.objects.link(sun)
world = bpy.data.worlds.new("world")
world.use_nodes = True
world.node_tree.nodes["Background"].inputs[0].default_value = (0.75, 0.76, 0.78, 1)
world.node_tree.nodes["Background"].inputs[1].default_value = 0.7
scene.world = world
scene.render.engine = "CYCLES"
scene.cycles.samples = 32
scene.cycles.use_denoising = False
scene.view_settings.view_transform = "Standard"
scene.render.resolution_x, scene.render.resolution_y = int(width), int(height)
scene.render.filepath = out
bpy.ops.render.render(write_still=True)
moved = max((a - b).length for a, b in zip(before, after, strict=True)) if before else 0.0
shapes = max(
    (len(one.data.shape_keys.key_blocks) for one in bpy.data.objects if one.type == "MESH" and one.data.shape_keys),
    default=0,
)
bones = max((len(one.data.bones) for one in bpy.data.objects if one.type == "ARMATURE"), default=0)
meshes = sum(max(len(one.material_slots), 1) for one in bpy.data.objects if one.type == "MESH" and one.visible_get())
clips = len({one.name.split("_")[0].split(".")[0] for one in bpy.data.actions})
sys.stdout.write(
    f"SEEN height_m={size.z:.3f} moved_m={moved:.3f} bones={bones} shapes={shapes} meshes={meshes} clips={clips}\n"
)
