# Plays the morph targets of res://morph.glb in turn: the mesh as it is, then each target, then back.
# Left and right choose a shape; space stops and goes on.
extends Spatial

export var seconds_a_shape = 2.0
export var rest = 0.6 # seconds at each shape

var mesh: MeshInstance
var names = []
var at = 0.0 # shapes from the first one on
var playing = true

func find_mesh(node):
	if node is MeshInstance:
		return node
	for child in node.get_children():
		var found = find_mesh(child)
		if found != null:
			return found
	return null

func _ready():
	var scene = load("res://morph.glb")
	if scene == null:
		push_error("there is no morph.glb: README.md says how it is made")
		return
	var shape = scene.instance()
	$Turntable.add_child(shape)
	var player = shape.get_node_or_null("AnimationPlayer")
	if player != null:
		player.stop() # the file brings an animation of its own; this script shows how it is done by hand
	mesh = find_mesh(shape)
	for i in range(mesh.mesh.get_blend_shape_count()):
		names.append(mesh.mesh.get_blend_shape_name(i))
	# Two units in size, in the middle.
	var box = mesh.get_aabb()
	var size = max(box.size.x, max(box.size.y, box.size.z))
	shape.scale = Vector3.ONE * 2.0 / size
	shape.translation = -(box.position + 0.5 * box.size) * 2.0 / size

# Weights of the targets when so many shapes have passed: between two neighbors one falls as the other rises.
func show_at(shapes):
	var count = names.size() + 1
	var from = int(floor(shapes)) % count
	var part = smoothstep(0, 1, shapes - floor(shapes))
	for i in range(names.size()):
		var weight = 0.0
		if i + 1 == from:
			weight = 1.0 - part
		if i + 1 == (from + 1) % count:
			weight = part
		mesh.set("blend_shapes/" + names[i], weight)

func _process(delta):
	if mesh == null:
		return
	$Turntable.rotate_y(0.3 * delta)
	if playing:
		at += delta / (seconds_a_shape + rest)
	var shapes = floor(at) + min(1.0, (at - floor(at)) * (seconds_a_shape + rest) / seconds_a_shape)
	show_at(shapes)

func _input(event):
	if event.is_action_pressed("ui_select"):
		playing = not playing
	elif event.is_action_pressed("ui_right"):
		at = floor(at) + 1
	elif event.is_action_pressed("ui_left"):
		at = max(0, ceil(at) - 1)
