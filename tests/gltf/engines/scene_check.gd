# Plays the scene of examples/godot and prints one line of JSON: its morph targets, and their weights at each shape and on the way.
extends SceneTree

var main
var frames = 0

func _initialize():
	main = load("res://main.tscn").instance()
	get_root().add_child(main)

func weights():
	var result = []
	for name in main.names:
		result.append(main.mesh.get("blend_shapes/" + name))
	return result

func _idle(_delta):
	frames += 1
	if frames < 10:
		return false
	var moved = weights()
	main.playing = false
	var shown = []
	for shapes in [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0]:
		main.show_at(shapes)
		shown.append(weights())
	var size = main.mesh.get_aabb().get_longest_axis_size() * main.mesh.global_transform.basis.get_scale().x
	print("SCENE " + to_json({"names": main.names, "moved": moved, "shown": shown,
		"size": size, "vertices": main.mesh.mesh.surface_get_array_len(0)}))
	quit()
	return true
