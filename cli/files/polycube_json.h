// A polycube as JSON: corners, edges, patches and the dual graph. docs/polycube.md has the schema.
#pragma once

#include <span>

#include "polycube/outputs/patch_graph.h"
#include "session/session.h"

namespace orbicube::cli {

inline constexpr const char* polycube_format = "orbicube-polycube";

// `positions` are those of the map's vertices in space.
Json json_of(const polycube::PatchGraph& graph, std::int64_t genus, std::span<const mesh::Vector3> positions);

}  // namespace orbicube::cli
