// The surfaces that have a map: what is refused of others, and triangles turned to be consistent and outward-oriented.
#pragma once

#include "base/host.h"
#include "mesh/mesh.h"
#include "mesh/topology/orient.h"

namespace orbicube::correspondence {

// Orients a closed surface of genus 0. Returns what was turned. Throws Error for any other: the kinds of
// mesh::require_closed_genus_zero.
mesh::OrientReport orient_genus_zero(mesh::Mesh& surface, const base::Host& host);

// Orients a closed, connected surface of any genus, which goes to `genus`. Throws Error for any other.
mesh::OrientReport orient_any_genus(mesh::Mesh& surface, std::int64_t& genus, const base::Host& host);

}  // namespace orbicube::correspondence
