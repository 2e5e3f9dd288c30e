# Each library with those that it uses. Written by scripts/bindings.py; not to be edited.
const libraries = [
    :base => Symbol[],
    :mesh => Symbol[:base],
    :correspondence => Symbol[:base, :mesh],
    :frame_field => Symbol[:base],
    :gltf => Symbol[:base],
    :harmonics => Symbol[:base],
    :hexmesh => Symbol[:base, :mesh],
    :linear => Symbol[:base],
    :polycube => Symbol[:base, :mesh],
    :projected_gradient => Symbol[:base],
    :quaternion => Symbol[:base],
    :sphere_map => Symbol[:base, :mesh],
    :sphere_optimizer => Symbol[:base],
    :tetrahedra => Symbol[:base, :mesh],
    :trust_region => Symbol[:base],
    :volume_map => Symbol[:base, :mesh],
]
