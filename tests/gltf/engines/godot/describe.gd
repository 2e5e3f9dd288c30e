# Prints one line of JSON for each scene of the project: what Godot imported of its first mesh.
extends SceneTree

func find_mesh(node):
	if node is MeshInstance:
		return node
	for child in node.get_children():
		var found = find_mesh(child)
		if found != null:
			return found
	return null

func _init():
	for path in OS.get_cmdline_args():
		if not path.begins_with("res://"):
			continue
		var scene = load(path)
		if scene == null:
			continue
		var instance = scene.instance()
		var mesh = find_mesh(instance).mesh
		var names = []
		for i in range(mesh.get_blend_shape_count()):
			names.append(mesh.get_blend_shape_name(i))
		var arrays = mesh.surface_get_arrays(0)
		var shapes = mesh.surface_get_blend_shape_arrays(0)
		var moved = []
		for shape in shapes:
			var largest = 0.0
			for v in range(shape[Mesh.ARRAY_VERTEX].size()):
				largest = max(largest, (shape[Mesh.ARRAY_VERTEX][v] - arrays[Mesh.ARRAY_VERTEX][v]).length())
			moved.append(largest)
		print("IMPORTED " + to_json({
			"path": path,
			"vertices": arrays[Mesh.ARRAY_VERTEX].size(),
			"triangles": arrays[Mesh.ARRAY_INDEX].size() / 3,
			"surfaces": mesh.get_surface_count(),
			"uv": arrays[Mesh.ARRAY_TEX_UV] != null,
			"normals": arrays[Mesh.ARRAY_NORMAL] != null,
			"morphTargets": names,
			"moved": moved,
		}))
		instance.free()
	quit()
