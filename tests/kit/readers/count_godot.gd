# Run by Godot 3 without a window: tells what its importer made of the file that the variable ASKED names.
extends SceneTree
# How far each target moves the vertex that it moves farthest, of all surfaces, millimetres.
func tell_moves(mesh, row, moves):
	var rest = mesh.surface_get_arrays(row)[Mesh.ARRAY_VERTEX]
	var shapes = mesh.surface_get_blend_shape_arrays(row)
	for k in range(shapes.size()):
		var most = moves.get(mesh.get_blend_shape_name(k), 0.0)
		var bent = shapes[k][Mesh.ARRAY_VERTEX]
		for v in range(rest.size()):
			most = max(most, 1000.0 * bent[v].distance_to(rest[v]))
		moves[mesh.get_blend_shape_name(k)] = most
func walk(node, told):
	if node is MeshInstance:
		told["meshes"] += node.mesh.get_surface_count()
		told["targets"] = max(told["targets"], node.mesh.get_blend_shape_count())
		var box = node.get_aabb()
		for row in range(node.mesh.get_surface_count()):
			tell_moves(node.mesh, row, told["moves_mm"])
		told["low"] = min(told["low"], box.position.y)
		told["high"] = max(told["high"], box.position.y + box.size.y)
	if node is Skeleton:
		told["joints"] = max(told["joints"], node.get_bone_count())
	if node is AnimationPlayer:
		told["clips"] += node.get_animation_list().size()
	for child in node.get_children():
		walk(child, told)
func _init():
	var told = {"meshes": 0, "targets": 0, "joints": 0, "moves_mm": {}, "clips": 0, "low": 1e9, "high": -1e9}
	walk(load("res://" + OS.get_environment("ASKED")).instance(), told)
	print("SEEN ", to_json(told))
	quit()
