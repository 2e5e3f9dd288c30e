// A polycube map as glTF: the surface with a checker along the polycube's axes, and the polycube as its morph target.
#pragma once

#include <filesystem>
#include <string>

#include "polycube/surface/surface_map.h"
#include "session/session.h"

namespace orbicube::cli {

// Vertices on edges of the polycube are there once for each patch, since texture coordinates differ from patch to
// patch: TEXCOORD_0 is the position in the plane of the patch, from the polycube's lowest corner, in units that the
// scene's extras give (texture_unit). Coordinates are rounded to float32. Returns figures for the report, among them
// the number of triangles that are flat or flipped on the polycube after that.
Json write_polycube_scene(const std::filesystem::path& path, const polycube::SurfaceMap& map, const std::string& name,
                          const base::Host& host);

}  // namespace orbicube::cli
