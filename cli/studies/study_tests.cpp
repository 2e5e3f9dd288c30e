#include "studies/study_tests.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/counted.h"
#include "correspondence/statistics/group_test.h"
#include "correspondence/study/robust_placement.h"
#include "report/text.h"

namespace orbicube::cli {
namespace {

std::optional<double> number_in(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

const std::string& value_of(const StudySubject& subject, const std::string& column) {
  return subject.values.at(column);
}

[[noreturn]] void refuse(const std::string& input, const std::string& text) {
  throw Failure(Exit::wrong_input, input, "invalid-argument", text);
}

std::set<std::string> values_of(const std::vector<const StudySubject*>& subjects, const std::string& column) {
  std::set<std::string> values;
  for (const StudySubject* subject : subjects)
    values.insert(value_of(*subject, column));
  return values;
}

void require_column(const std::string& option, const std::string& column, const StudySubject& subject,
                    const std::string& input) {
  if (column.empty() || subject.values.contains(column)) return;
  std::string known;
  for (const auto& value : subject.values)
    known += (known.empty() ? "'" : ", '") + value.first + "'";
  refuse(input, option + ": there is no column '" + column + "'" +
                    (known.empty() ? "; give a table of the subjects that has it" : "; there are " + known));
}

void add_maps(const std::string& what, const char* vectors, correspondence::GroupTest test,
              std::vector<PointData>& maps) {
  maps.push_back({what + "_t2", false, std::move(test.t2)});
  maps.push_back({what + "_p", false, std::move(test.p)});
  maps.push_back({what + "_p_family_wise", false, std::move(test.p_family_wise)});
  maps.push_back({what + "_q", false, std::move(test.q)});
  maps.push_back({what + "_" + vectors, true, std::move(test.difference)});
}

Json figures_of(const correspondence::GroupTest& test, const std::string& column) {
  constexpr double level = 0.05;
  const auto below = [&](const std::vector<double>& values) {
    return std::count_if(values.begin(), values.end(), [](double value) { return value <= level; });
  };
  return {{"column", column},
          {"max_t2", *std::max_element(test.t2.begin(), test.t2.end())},
          {"min_p", *std::min_element(test.p.begin(), test.p.end())},
          {"min_p_family_wise", *std::min_element(test.p_family_wise.begin(), test.p_family_wise.end())},
          {"min_q", *std::min_element(test.q.begin(), test.q.end())},
          {"points_family_wise_0.05", below(test.p_family_wise)},
          {"points_q_0.05", below(test.q)}};
}

void say_test(const std::string& what, const Json& figures, std::size_t points, Session& session) {
  session.say("  " + what + ": " + std::to_string(figures["points_q_0.05"].get<std::size_t>()) + " of " +
              base::counted(points, "point") + " at a false-discovery rate of 0.05; minimum family-wise p " +
              number(figures["min_p_family_wise"].get<double>()));
}

}  // namespace

void require_columns(const StudyTests& tests, const std::vector<StudySubject>& list, const std::string& input) {
  std::vector<const StudySubject*> all;
  for (const StudySubject& subject : list)
    all.push_back(&subject);
  require_column("--groups", tests.groups, list.front(), input);
  require_column("--covariate", tests.covariate, list.front(), input);
  if (!tests.groups.empty()) {
    if (const std::size_t count = values_of(all, tests.groups).size(); count != 2)
      refuse(input,
             "--groups: column '" + tests.groups + "' has " + base::counted(count, "value") + "; give one with two");
  }
  for (const StudySubject* subject : all) {
    if (!tests.covariate.empty() && !number_in(value_of(*subject, tests.covariate))) {
      refuse(input, "--covariate: column '" + tests.covariate + "': '" + value_of(*subject, tests.covariate) + "' of " +
                        subject->file.string() + " is no number");
    }
  }
}

std::vector<PointData> run_tests(const StudyTests& tests, const std::vector<StudySubject>& list,
                                 const StudySubjects& subjects, const correspondence::Population& shapes,
                                 std::span<const mesh::Triangle> grid, Session& session) {
  base::Array<mesh::Vector3> normals;
  if (tests.test == "normal") normals = correspondence::normals_of_mean(shapes, grid, session.host());
  const correspondence::GroupTestOptions options{tests.permutations, session.seed(), normals};
  const auto points = static_cast<std::size_t>(shapes.cols() / 3);
  std::vector<const StudySubject*> mapped;
  for (const MappedSubject& subject : subjects.mapped)
    mapped.push_back(&list[subject.number]);
  std::vector<PointData> maps;
  if (!tests.groups.empty()) {
    const std::set<std::string> names = values_of(mapped, tests.groups);
    std::vector<std::uint8_t> group;
    for (const StudySubject* subject : mapped)
      group.push_back(value_of(*subject, tests.groups) == *names.begin() ? 0 : 1);
    correspondence::GroupTest test = correspondence::compare_groups(shapes, group, options, session.host());
    Json& figures = session.figures()["groups"] = figures_of(test, tests.groups);
    const auto ones = std::count(group.begin(), group.end(), std::uint8_t{1});
    figures["values"] = names;
    figures["subjects"] = {group.size() - static_cast<std::size_t>(ones), ones};
    say_test("groups '" + *names.begin() + "' and '" + *names.rbegin() + "'", figures, points, session);
    add_maps("group", "difference", std::move(test), maps);
  }
  if (!tests.covariate.empty()) {
    std::vector<double> values;
    for (const StudySubject* subject : mapped)
      values.push_back(*number_in(value_of(*subject, tests.covariate)));
    correspondence::GroupTest test = correspondence::regress(shapes, values, options, session.host());
    Json& figures = session.figures()["covariate"] = figures_of(test, tests.covariate);
    say_test("covariate '" + tests.covariate + "'", figures, points, session);
    add_maps("covariate", "slope", std::move(test), maps);
  }
  return maps;
}

}  // namespace orbicube::cli
