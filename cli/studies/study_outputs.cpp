#include "studies/study_outputs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/files/file.h"
#include "files/surface_file.h"
#include "morphs/morph_states.h"
#include "studies/study_page_file.h"
#include "studies/study_part.h"

namespace orbicube::cli {
namespace {

std::string text_of(double value) {
  std::array<char, 32> digits;
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

std::string text_of(const Json& value) {
  return value.is_number_float() ? text_of(value.get<double>()) : value.dump();
}

void write_text(const std::filesystem::path& path, const std::string& text, Session& session) {
  about(path, Role::output, [&] {
    base::OutputFile file(session.stage(path));
    file.write(text);
    file.commit();
  });
}

const std::string& name_of(const StudyResult& result, std::size_t i) {
  return result.list[result.subjects.mapped[i].number].name;
}

// A row a mapped subject: its name, and `cell(i, k)` for each column.
template <class Cell>
std::string table(const StudyResult& result, const std::vector<std::string>& columns, const Cell& cell) {
  std::string text = "name";
  for (const std::string& column : columns)
    text += "," + csv_cell(column);
  text += "\n";
  for (std::size_t i = 0; i < result.subjects.mapped.size(); ++i) {
    text += csv_cell(name_of(result, i));
    for (std::size_t k = 0; k < columns.size(); ++k)
      text += "," + cell(i, k);
    text += "\n";
  }
  return text;
}

std::string distances_table(const StudyResult& result) {
  std::vector<std::string> columns;
  for (std::size_t i = 0; i < result.subjects.mapped.size(); ++i)
    columns.push_back(name_of(result, i));
  return table(result, columns, [&](std::size_t i, std::size_t k) {
    return text_of(result.distances(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)));
  });
}

std::string scores_table(const StudyResult& result) {
  std::vector<std::string> columns;
  for (Eigen::Index k = 0; k < result.modes.scores.cols(); ++k)
    columns.push_back("mode_" + std::to_string(k + 1));
  return table(result, columns, [&](std::size_t i, std::size_t k) {
    return text_of(result.modes.scores(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)));
  });
}

// All subjects, those that failed too, without what differs from run to run.
std::string subjects_table(const StudyResult& result) {
  constexpr std::array figures = {"vertices",    "triangles", "area",    "volume",
                                  "correlation", "turn",      "flipped", "max_distance_percent"};
  std::string text = "name,file,status";
  for (const char* figure : figures)
    text += std::string(",") + figure;
  text += ",scale\n";
  std::vector<std::string> rows(result.list.size());
  for (std::size_t i = 0; i < result.subjects.mapped.size(); ++i) {
    const MappedSubject& subject = result.subjects.mapped[i];
    std::string& row = rows[subject.number] = "done";
    for (const char* figure : figures)
      row += "," + text_of(subject.figures.value(figure, Json()));
    row += "," + text_of(result.pose.moved[i].scale);
  }
  for (const FailedSubject& failed : result.subjects.failed)
    rows[failed.number] = failed.kind + std::string(figures.size() + 1, ',');
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += csv_cell(result.list[i].name) + "," + csv_cell(result.list[i].file.string()) + "," + rows[i] + "\n";
  return text;
}

// The displacement of each point by one standard deviation of a mode.
Eigen::VectorXd displacement(const StudyResult& result, Eigen::Index mode) {
  return std::sqrt(result.modes.variances(mode)) * result.modes.modes.col(mode);
}

std::vector<double> values_of(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

std::vector<PointData> data_of_mean(const StudyResult& result, Eigen::Index modes) {
  // The standard deviation of a point is the root of the sum of what all modes have there.
  PointData deviation{"standard_deviation", false,
                      std::vector<double>(static_cast<std::size_t>(result.modes.mean.size() / 3))};
  for (Eigen::Index v = 0; v < result.modes.mean.size() / 3; ++v) {
    double variance = 0;
    for (Eigen::Index k = 0; k < result.modes.variances.size(); ++k)
      variance += result.modes.variances(k) * result.modes.modes.col(k).segment<3>(3 * v).squaredNorm();
    deviation.values[static_cast<std::size_t>(v)] = std::sqrt(variance);
  }
  std::vector<PointData> data = {std::move(deviation)};
  for (Eigen::Index k = 0; k < modes; ++k)
    data.push_back({"mode_" + std::to_string(k + 1), true, values_of(displacement(result, k))});
  data.insert(data.end(), result.tests.begin(), result.tests.end());
  return data;
}

void write_modes(const StudyResult& result, const std::filesystem::path& path, Eigen::Index modes, Session& session) {
  constexpr double deviations = 2;
  std::vector<base::Array<mesh::Vector3>> states;
  states.push_back(points_of(result.modes.mean, session.host().memory));
  std::vector<std::string> names = {"mean"};
  for (Eigen::Index k = 0; k < modes; ++k) {
    for (const double sign : {1.0, -1.0}) {
      const Eigen::VectorXd moved = result.modes.mean + sign * deviations * displacement(result, k);
      states.push_back(points_of(moved, session.host().memory));
      names.push_back("mode " + std::to_string(k + 1) + (sign > 0 ? " +2" : " -2"));
    }
  }
  MorphStates morph{path.string(), names, result.triangles, states};
  write_morph(morph, session);
}

void add_figures(const StudyResult& result, Session& session) {
  add_subject_figures(result.list, result.subjects, session);
  Json& figures = session.figures();
  for (std::size_t i = 0; i < result.subjects.mapped.size(); ++i) {
    figures["subjects"][i]["distance_from_mean"] = result.from_mean[i];
    figures["subjects"][i]["outlier"] = result.outlier[i] != 0;
  }
  figures["alignment"] = {{"rounds", result.pose.rounds}, {"converged", result.pose.converged}};
  const double whole = result.modes.variances.sum();
  Json fractions = Json::array();
  for (const double variance : result.modes.variances)
    fractions.push_back(whole > 0 ? variance / whole : 0);
  figures["modes"] = {{"count", result.modes.variances.size()},
                      {"variances", values_of(result.modes.variances)},
                      {"fractions", fractions}};
}

}  // namespace

base::Array<mesh::Vector3> points_of(const Eigen::VectorXd& coordinates, std::pmr::memory_resource* memory) {
  base::Array<mesh::Vector3> points(memory);
  for (Eigen::Index v = 0; v < coordinates.size() / 3; ++v)
    points.push_back(coordinates.segment<3>(3 * v));
  return points;
}

void write_study(const StudyResult& result, const std::filesystem::path& folder, std::size_t max_modes,
                 Session& session) {
  const Eigen::Index modes = std::min(static_cast<Eigen::Index>(max_modes), result.modes.variances.size());
  write_text(folder / "distances.csv", distances_table(result), session);
  write_text(folder / "scores.csv", scores_table(result), session);
  write_text(folder / "subjects.csv", subjects_table(result), session);
  mesh::Mesh mean(session.host().memory);
  mean.positions = points_of(result.modes.mean, session.host().memory);
  mean.triangles.assign(result.triangles.begin(), result.triangles.end());
  write_output(folder / "mean.ply", mean, true, session);
  write_output(folder / "mean.glb", mean, true, session);
  const std::vector<PointData> data = data_of_mean(result, modes);
  write_point_data(folder / "mean.vtk", mean, data, session);
  write_study_page(result, folder / "study.html", mean, data, modes, session);
  if (modes > 0) write_modes(result, folder / "modes.glb", modes, session);
  add_figures(result, session);
}

}  // namespace orbicube::cli
