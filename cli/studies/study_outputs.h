// What a study writes of the group: tables, the mean with values of its points, modes as morph targets, figures.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "correspondence/study/group_pose.h"
#include "studies/point_data_file.h"
#include "studies/study_subjects.h"

namespace orbicube::cli {

struct StudyResult {
  const std::vector<StudySubject>& list;
  const StudySubjects& subjects;
  std::span<const mesh::Triangle> triangles;  // of the grid
  correspondence::GroupPose pose;
  correspondence::PrincipalModes modes;
  Eigen::MatrixXd distances;
  std::vector<PointData> tests;         // of each point of the mean: groups, covariates
  std::vector<double> from_mean{};      // of each mapped subject: root mean square distance of its points
  std::vector<std::uint8_t> outlier{};  // whether that is an outlier
};

// Returns the points of a row of coordinates.
base::Array<mesh::Vector3> points_of(const Eigen::VectorXd& coordinates, std::pmr::memory_resource* memory);

// Writes distances.csv, scores.csv, subjects.csv, mean.ply, mean.glb, mean.vtk, study.html and modes.glb to the folder,
// as outputs of the session, and adds figures. At most `max_modes` modes go to mean.vtk, study.html and modes.glb.
// Throws Failure.
void write_study(const StudyResult& result, const std::filesystem::path& folder, std::size_t max_modes,
                 Session& session);

}  // namespace orbicube::cli
