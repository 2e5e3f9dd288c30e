// Shapes of files on the sphere, their spheres brought into line: what morphs and maps through spheres start from.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "files/surface_file.h"
#include "morphs/morph_alignment.h"
#include "solids/repaired_surface.h"

namespace orbicube::cli {

inline constexpr const char* align_help =
    "rotation of the spheres without landmarks: shape, to maximum correlation for any poses of the shapes; rotation, "
    "the same for equal poses; none [default: shape]";

struct SphereShapesOptions {
  std::vector<std::string> inputs;
  std::string landmarks;  // file, or empty
  std::string align;      // shape, rotation or none
  Mending mending;
  Keep keep_first = Keep::surface;  // of the file of the first shape
};

// Reads the shapes and maps each to the sphere. Throws Failure.
std::deque<MorphShape> map_shapes(const SphereShapesOptions& options, Session& session);

// Aligns the spheres of the further shapes to that of the first. Throws Failure.
void align_shapes(std::deque<MorphShape>& shapes, const SphereShapesOptions& options, Session& session);

}  // namespace orbicube::cli
