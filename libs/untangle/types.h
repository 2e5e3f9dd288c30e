// The words of meshes that this library shares with the others.
#pragma once

#include <cstdint>
#include <span>

#include "base/host.h"
#include "mesh/mesh.h"

namespace orbicube::untangle {

using base::Array;
using mesh::Index;
using mesh::no_index;
using mesh::Tetrahedron;
using mesh::Triangle;
using mesh::Vector3;

}  // namespace orbicube::untangle
