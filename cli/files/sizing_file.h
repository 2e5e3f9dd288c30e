// Files that say how long edges should be where: a line `x y z length` for each place, or a line `length` for each
// vertex of a surface. What follows a # and empty lines do not count.
#pragma once

#include <filesystem>
#include <span>

#include "base/host.h"
#include "tetrahedra/sizing.h"

namespace orbicube::cli {

// Throws Error "io"; "parse", "non-finite", "invalid-argument" (a length that is not positive), "truncated",
// "trailing-data" (fewer or more lines than vertices), with the line; "cancelled".
base::Array<tetrahedra::SizePoint> read_sizing(const std::filesystem::path& path,
                                               std::span<const mesh::Vector3> vertices, const base::Host& host);

}  // namespace orbicube::cli
