// A surface with the texture atlas of its polycube as glTF: for engines, normal maps and painting.
#pragma once

#include <filesystem>
#include <string>

#include "polycube/outputs/atlas.h"
#include "polycube/surface/surface_map.h"
#include "session/session.h"

namespace orbicube::cli {

struct AtlasRequest {
  std::filesystem::path output;
  polycube::AtlasOptions options;
  std::filesystem::path colors;  // glTF file whose colors the texture has; empty: a checker along the polycube's axes
};

// Vertices on edges of the polycube are there once for each patch. TEXCOORD_0 is the place in the atlas, NORMAL smooth
// across patches, TANGENT along the first texture coordinate; the polycube is a morph target with normals. Returns
// figures for the report, among them the number of triangles that float32 makes flat or flipped in the texture. Throws
// Failure, errors of make_atlas and of writing.
Json write_atlas_scene(const AtlasRequest& request, const polycube::SurfaceMap& map, const polycube::PatchGraph& graph,
                       const std::string& name, const base::Host& host);

}  // namespace orbicube::cli
