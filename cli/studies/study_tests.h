// Tests of a study: where two groups of subjects differ, and where shapes change with a covariate.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "correspondence/statistics/principal_modes.h"
#include "mesh/mesh.h"
#include "studies/point_data_file.h"
#include "studies/study_subjects.h"

namespace orbicube::cli {

struct StudyTests {
  std::string groups;           // column of the table with two values, or empty
  std::string covariate;        // column with numbers, or empty
  std::string test = "normal";  // or "position"
  std::size_t permutations = 1000;
};

// Throws Failure unless the columns are there, with two values or with numbers: before long work.
void require_columns(const StudyTests& tests, const std::vector<StudySubject>& list, const std::string& input);

// Tests each point of the shapes on the grid, one row a mapped subject. Returns maps of the points, and adds the
// figures "groups" and "covariate". Throws Failure, and Error as correspondence::regress().
std::vector<PointData> run_tests(const StudyTests& tests, const std::vector<StudySubject>& list,
                                 const StudySubjects& subjects, const correspondence::Population& shapes,
                                 std::span<const mesh::Triangle> grid, Session& session);

}  // namespace orbicube::cli
