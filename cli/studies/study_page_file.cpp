#include "studies/study_page_file.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "base/counted.h"
#include "base/files/file.h"
#include "scenes/study_page.h"

namespace orbicube::cli {
namespace {

struct Told {
  const char* title;
  MapKind kind;
};

// The arrays of mean.vtk that the page shows as colors.
const std::map<std::string, Told>& told_maps() {
  static const std::map<std::string, Told> maps = {
      {"standard_deviation", {"Standard deviation", MapKind::size}},
      {"group_q", {"Groups: false-discovery rate", MapKind::probability}},
      {"group_p_family_wise", {"Groups: family-wise p", MapKind::probability}},
      {"group_p", {"Groups: p of each point alone", MapKind::probability}},
      {"group_t2", {"Groups: Hotelling's T2", MapKind::size}},
      {"group_difference", {"Groups: difference, along normals", MapKind::vectors}},
      {"covariate_q", {"Covariate: false-discovery rate", MapKind::probability}},
      {"covariate_p_family_wise", {"Covariate: family-wise p", MapKind::probability}},
      {"covariate_p", {"Covariate: p of each point alone", MapKind::probability}},
      {"covariate_t2", {"Covariate: Hotelling's T2", MapKind::size}},
      {"covariate_slope", {"Covariate: slope, along normals", MapKind::vectors}}};
  return maps;
}

void add_data(const std::vector<PointData>& data, Eigen::Index modes, const Json& figures, StudyPage& page) {
  page.first_map = "standard_deviation";
  for (Eigen::Index k = 0; k < modes; ++k) {
    const std::string id = "mode_" + std::to_string(k + 1);
    for (const PointData& of_points : data)
      if (of_points.name == id)
        page.shifts.push_back({id, "Mode " + std::to_string(k + 1), "standard deviations", 3, of_points.values});
  }
  for (const PointData& of_points : data) {
    const auto told = told_maps().find(of_points.name);
    if (told == told_maps().end()) continue;
    page.maps.push_back({of_points.name, told->second.title, told->second.kind, of_points.values});
    if (of_points.name == "covariate_q" || of_points.name == "group_q") page.first_map = of_points.name;
    if (of_points.name != "group_difference") continue;
    const Json& values = figures.at("groups").at("values");
    page.groups = values.get<std::vector<std::string>>();
    page.shifts.push_back(
        {of_points.name, page.groups.back() + " minus " + page.groups.front(), "differences", 3, of_points.values});
  }
}

using Column = std::pair<const char*, const char*>;  // key of the figures, title
constexpr std::array<Column, 8> columns = {{{"vertices", "Vertices"},
                                            {"triangles", "Triangles"},
                                            {"area", "Area"},
                                            {"volume", "Volume"},
                                            {"correlation", "Correlation"},
                                            {"turn", "Turn, degrees"},
                                            {"flipped", "Flipped"},
                                            {"max_distance_percent", "Max. distance, %"}}};

StudyPageSubject page_subject(const StudyResult& result, std::size_t i, Eigen::Index modes, const std::string& column) {
  const MappedSubject& mapped = result.subjects.mapped[i];
  const StudySubject& listed = result.list[mapped.number];
  StudyPageSubject subject{listed.name, {}, result.from_mean[i], result.outlier[i] != 0, 0, {}};
  if (!column.empty()) subject.values.emplace_back(listed.values.at(column));
  subject.values.emplace_back(result.from_mean[i]);
  for (const auto& [key, title] : columns) {
    const Json value = mapped.figures.value(key, Json());
    subject.values.emplace_back(value.is_number() ? value.get<double>() : std::nan(""));
  }
  for (Eigen::Index k = 0; k < modes; ++k)
    subject.scores.push_back(result.modes.scores(static_cast<Eigen::Index>(i), k) /
                             std::sqrt(result.modes.variances(k)));
  return subject;
}

void add_subjects(const StudyResult& result, Eigen::Index modes, const Json& figures, StudyPage& page) {
  const std::string column = page.groups.empty() ? std::string() : figures.at("groups").at("column").get<std::string>();
  if (!column.empty()) page.columns.push_back(column);
  page.columns.emplace_back("From the mean");
  for (const auto& [key, title] : columns)
    page.columns.emplace_back(title);
  for (std::size_t i = 0; i < result.subjects.mapped.size(); ++i) {
    StudyPageSubject subject = page_subject(result, i, modes, column);
    if (!column.empty()) subject.group = std::get<std::string>(subject.values[0]) == page.groups.back() ? 1 : 0;
    page.subjects.push_back(std::move(subject));
  }
  for (const FailedSubject& failed : result.subjects.failed)
    page.failed.push_back({result.list[failed.number].name, failed.kind + ": " + failed.text});
}

std::string summary_of(const StudyResult& result, const Json& figures) {
  std::string text = base::counted(result.subjects.mapped.size(), "subject") + " on " +
                     base::counted(static_cast<std::size_t>(result.modes.mean.size() / 3), "point");
  if (!result.subjects.failed.empty()) text += ", " + std::to_string(result.subjects.failed.size()) + " failed";
  if (figures.contains("groups"))
    text += "; groups differ at " + base::counted(figures["groups"]["points_q_0.05"].get<std::size_t>(), "point") +
            " at a false-discovery rate of 0.05";
  return text;
}

}  // namespace

void write_study_page(const StudyResult& result, const std::filesystem::path& path, const mesh::Mesh& mean,
                      const std::vector<PointData>& data, Eigen::Index modes, Session& session) {
  StudyPage page;
  page.title = "Study of shapes";
  page.summary = summary_of(result, session.figures());
  page.mean = mean.positions;
  page.triangles = mean.triangles;
  for (const double variance : result.modes.variances)
    page.fractions.push_back(variance / result.modes.variances.sum());
  add_data(data, modes, session.figures(), page);
  add_subjects(result, modes, session.figures(), page);
  const std::string text = study_page(page);
  about(path, Role::output, [&] {
    base::OutputFile file(session.stage(path));
    file.write(text);
    file.commit();
  });
}

}  // namespace orbicube::cli
