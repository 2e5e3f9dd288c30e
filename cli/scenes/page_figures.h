// A sphere map with its figures as the report page shows it, and the page as a file.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "harmonics/fitting/fit.h"
#include "harmonics/functions/coefficients.h"
#include "mesh/mesh.h"
#include "scenes/report_page.h"
#include "session/session.h"
#include "sphere_map/optimization/measure.h"

namespace orbicube::cli {

// Views of the shape, its map (unit vectors) and what measuring it gave, which have to stay, and the rows of the page's
// table. The weights are those that the map was measured with.
PageResult page_result(const std::string& name, const mesh::Mesh& shape, std::span<const mesh::Vector3> directions,
                       const sphere_map::Measurement& map, const sphere_map::FaceDistortion& faces, double angle_weight,
                       double area_weight);

// Adds the slider with the shape's spherical harmonics (three channels; a view, which has to stay) and their rows.
// `error` is that of the reconstruction from the highest degree, for a shape of area 4 pi.
void add_harmonics(PageResult& result, const harmonics::Coefficients& coefficients, const harmonics::FitReport& fit,
                   double error);

// Writes the page and returns its size in bytes. Throws Failure.
std::size_t write_page(const std::string& path, std::span<const PageResult> results, const std::string& title,
                       Session& session);

}  // namespace orbicube::cli
