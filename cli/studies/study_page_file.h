// The page of a study as a file.
#pragma once

#include <filesystem>

#include "studies/study_outputs.h"

namespace orbicube::cli {

// Writes the page, with the first `modes` modes as sliders, as an output of the session. `data` are the maps of
// mean.vtk. Throws Failure.
void write_study_page(const StudyResult& result, const std::filesystem::path& path, const mesh::Mesh& mean,
                      const std::vector<PointData>& data, Eigen::Index modes, Session& session);

}  // namespace orbicube::cli
