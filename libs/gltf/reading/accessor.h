// Accessors: typed arrays in buffer views, with strides and sparse replacements (glTF 2.0 specification, 3.6.2). Every
// range is checked before it is read, in arithmetic that cannot overflow; values may lie at any alignment.
#pragma once

#include <cstdint>

#include "base/array.h"
#include "gltf/json/asset.h"
#include "mesh/mesh.h"

namespace orbicube::gltf {

using mesh::Index;
using mesh::Vector3;

// Accessors are given by their number, which must be one of the asset's model.

// How many elements the accessor has, from its description only.
std::uint64_t element_count(const Asset& asset, std::size_t accessor);

// The values of a VEC3 accessor: 32-bit floats or, where the file uses KHR_mesh_quantization, 8- and 16-bit integers,
// normalized or not. Throws Error: "accessor-type" for another type, "accessor-range" when the accessor does not fit
// its buffer view or has more elements than the file has bytes, "index-range" for a sparse index beyond it,
// "non-finite" (with the element) for NaN and infinity, "empty-mesh" without elements, and the kinds of Asset::view.
base::Array<Vector3> read_vectors(Asset& asset, std::size_t accessor);

// The values of a SCALAR accessor of unsigned 8-, 16- or 32-bit integers, each below `limit`. Throws Error as
// read_vectors does; "index-range" for a value from `limit` on, and for the largest of its type (primitive restart,
// that glTF does not have).
base::Array<Index> read_indices(Asset& asset, std::size_t accessor, std::size_t limit);

// Bytes of an element of that type, without padding.
std::size_t element_size(const tiny::Accessor& accessor);

// The elements of an accessor of any type, one behind the other as they are stored, sparse ones in place. Throws
// Error as read_vectors does.
base::Array<std::byte> read_elements(Asset& asset, std::size_t accessor);

// Throws Error as read_elements does, without reading the elements.
void check_range(Asset& asset, std::size_t accessor);

}  // namespace orbicube::gltf
