// orbicube study: many subjects on one grid, and what is common to them and differs.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include "base/counted.h"
#include "correspondence/statistics/outliers.h"
#include "correspondence/study/robust_placement.h"
#include "files/surface_file.h"
#include "images/label_file.h"
#include "report/grid_choice.h"
#include "report/text.h"
#include "session/unused_options.h"
#include "studies/rounding.h"
#include "studies/study_list.h"
#include "studies/study_outputs.h"
#include "studies/study_part.h"
#include "studies/study_subjects.h"
#include "studies/study_tests.h"
#include "studies/subject_file.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct StudyOptions {
  std::string input, output;
  std::string grid = "icosphere:5";
  std::string align = "shape";
  std::string placement = "robust";
  std::size_t modes = 5;
  std::int32_t label = 0;
  StudyPart part;
  StudyTests tests;
};

Json json_of(const StudyOptions& options) {
  return {{"output", options.output},       {"stage", options.part.stage},
          {"only", options.part.subjects},  {"grid", options.grid},
          {"align", options.align},         {"placement", options.placement},
          {"modes", options.modes},         {"label", options.label},
          {"groups", options.tests.groups}, {"covariate", options.tests.covariate},
          {"test", options.tests.test},     {"permutations", options.tests.permutations}};
}

// Makes the folders and returns the first. Throws Failure.
std::filesystem::path made_folder(const StudyOptions& options) {
  std::filesystem::path folder = std::filesystem::path(options.output).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();  // a slash at its end
  require_folder(folder);
  std::error_code problem;
  if (std::filesystem::equivalent(folder, options.input, problem))
    throw Failure(Exit::wrong_input, options.output, "usage", "this is the folder of the subjects; give another");
  std::filesystem::create_directories(folder / "subjects", problem);
  if (problem) {
    throw Failure(Exit::wrong_input, options.output, "io", "cannot create the folder: " + problem.message());
  }
  return folder;
}

correspondence::GroupPose placed(const std::string& placement, correspondence::Population& shapes,
                                 std::span<const mesh::Triangle> triangles, const base::Host& host) {
  using correspondence::Pose;
  if (placement == "robust") return correspondence::place_robustly(shapes, triangles, host);
  if (placement == "kept") return correspondence::place_group(Pose::kept, shapes, host);
  return correspondence::place_group(placement == "scaled" ? Pose::scaled : Pose::turned, shapes, host);
}

correspondence::Population population_of(const StudySubjects& subjects) {
  const auto rows = static_cast<Eigen::Index>(subjects.mapped.size());
  const auto columns = static_cast<Eigen::Index>(3 * subjects.mapped[0].positions.size());
  correspondence::Population shapes(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const base::Array<mesh::Vector3>& positions = subjects.mapped[static_cast<std::size_t>(i)].positions;
    shapes.row(i) = Eigen::Map<const Eigen::RowVectorXd>(positions.front().data(), columns);
  }
  return shapes;
}

void say_result(const StudyResult& result, const std::string& output, Session& session) {
  const StudySubjects& subjects = result.subjects;
  note_failed(result.list, subjects, session);
  const auto reused = session.figures()["reused"].get<std::size_t>();
  session.say("wrote " + output + ": " + base::counted(subjects.mapped.size(), "subject") + " on " +
              base::counted(subjects.mapped[0].positions.size(), "vertex", "vertices") +
              (reused > 0 ? ", " + std::to_string(reused) + " of them taken from the study before" : ""));
  const Json& fractions = session.figures()["modes"]["fractions"];
  for (std::size_t k = 0; k < std::min<std::size_t>(3, fractions.size()); ++k)
    session.say("  mode " + std::to_string(k + 1) + ": " + number(100 * fractions[k].get<double>()) +
                " % of the variance");
  for (std::size_t i = 0; i < subjects.mapped.size(); ++i) {
    if (result.outlier[i] != 0)
      session.say("  outlier: " + result.list[subjects.mapped[i].number].name + ", " + number(result.from_mean[i]) +
                  " from the mean");
  }
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void analyze_group(const StudyOptions& options, const StudySubjects& subjects, StudyResult& result,
                   correspondence::Population& shapes, Session& session) {
  const base::Host& host = session.host();
  about(options.input, Role::input, [&] {
    result.pose = placed(options.placement, shapes, result.triangles, host);
    result.distances = correspondence::distances_between(shapes, host);
    result.modes = correspondence::principal_modes(shapes, host);
    result.from_mean = correspondence::distances_from_mean(shapes, result.modes.mean);
    result.outlier = correspondence::outliers(result.from_mean);
    result.tests = run_tests(options.tests, result.list, subjects, shapes, result.triangles, session);
  });
}

void study(const StudyOptions& options, const CommonOptions& common, Session& session) {
  session.options() = json_of(options);
  session.figures()["rounding"] = rounding_digest();
  const GridChoice grid = grid_choice(options.grid, "--grid");
  const base::Host& host = session.host();
  const std::vector<StudySubject> list = read_study_list(options.input, host);
  require_columns(options.tests, list, options.input);
  if (options.label != 0 && std::ranges::none_of(list, [](const StudySubject& s) { return is_label_image(s.file); }))
    throw Failure(Exit::wrong_input, options.input, "usage", "--label is for label images, and no subject is one");
  if (options.part.stage == "list") return say_list(list, session);
  const SubjectWork work = work_of(options.part, list, options.input);
  const std::filesystem::path folder = made_folder(options);
  const correspondence::SubjectOptions of_subjects{grid.kind, grid.resolution, options.align != "none",
                                                   options.align == "shape", session.seed()};
  const bool group = options.part.stage == "all" || options.part.stage == "group";
  const StudySubjects subjects = session.portion(group ? 0.95 : 1, [&] {
    return map_subjects(list, work, folder / "subjects", of_subjects, options.label, common, session);
  });
  if (!group) {
    add_subject_figures(list, subjects, session);
    require_lasting_results(list, work, subjects);
    return say_subjects(list, subjects, folder.string(), session);
  }
  correspondence::Population shapes = population_of(subjects);
  const sphere_map::Grid common_grid = sphere_map::make_grid(grid.kind, grid.resolution, host);
  StudyResult result{list, subjects, common_grid.triangles, {}, {}, {}, {}};
  analyze_group(options, subjects, result, shapes, session);
  write_study(result, folder, options.modes, session);
  say_result(result, options.output, session);
}

void add_test_options(CLI::App& verb, StudyTests& tests) {
  verb.add_option("--groups", tests.groups,
                  "column of LIST with two values: test where the groups differ (Hotelling's T2 of each point)")
      ->type_name("COLUMN");
  verb.add_option("--covariate", tests.covariate,
                  "column of LIST with numbers: test where the shapes change with it (regression of each point)")
      ->type_name("COLUMN");
  verb.add_option("--test", tests.test,
                  "what is tested at each point: normal, its position along the normal of the mean, which shows where "
                  "surfaces differ; position, all coordinates, which shifts along the surface change, too [default: "
                  "normal]")
      ->check(unnamed(CLI::IsMember({"normal", "position"})))
      ->type_name("WHAT");
  verb.add_option("--permutations", tests.permutations,
                  "number of permutations from which p-values are computed [default: 1000]")
      ->check(unnamed(CLI::Range(1, 1'000'000)))
      ->type_name("N");
}

}  // namespace

void add_study(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("study", "analyze the shapes of a group of subjects");
  const auto options = std::make_shared<StudyOptions>();
  verb->add_option("SUBJECTS", options->input,
                   "folder of closed genus-0 surfaces and label images, or a table of them: CSV with a column 'file'. "
                   "Surfaces: " +
                       surface_endings + "; label images: " + label_image_endings)
      ->required()
      ->type_name("FOLDER|LIST");
  verb->add_option("-o,--output", options->output, "folder to write to, created if it does not exist")
      ->type_name("FOLDER");
  verb->add_option("--grid", options->grid,
                   std::string("vertices of every subject [default: icosphere:5]: ") + grid_help)
      ->type_name("GRID");
  verb->add_option("--align", options->align,
                   "rotation of the spheres: shape, to maximum correlation with the first subject for any poses; "
                   "rotation, the same for equal poses; none [default: shape]")
      ->check(unnamed(CLI::IsMember({"shape", "rotation", "none"})))
      ->type_name("HOW");
  verb->add_option(
          "--placement", options->placement,
          "pose of the subjects before they are compared: robust, translated and rotated to where their surfaces vary "
          "least; turned, by least squares of all points; scaled, to one size as well; kept, as in their files "
          "[default: robust]")
      ->check(unnamed(CLI::IsMember({"robust", "turned", "scaled", "kept"})))
      ->type_name("HOW");
  verb->add_option("--label", options->label,
                   "label whose voxels are the object, in images [default: the only one besides 0]")
      ->check(unnamed(CLI::Range(std::numeric_limits<std::int32_t>::min(), std::numeric_limits<std::int32_t>::max())))
      ->type_name("N");
  verb->add_option("--modes", options->modes,
                   "number of principal modes in mean.vtk, modes.glb and study.html [default: 5]")
      ->check(unnamed(CLI::Range(0, 100)))
      ->type_name("N");
  add_test_options(*verb, options->tests);
  add_part_options(*verb, options->part);
  add_common_options(*verb, common);
  verb->footer(
      "Each subject is repaired, mapped to the sphere and aligned with the first; a subject that fails is reported and "
      "left\nout. Finished subjects are kept in FOLDER/subjects: a study that was stopped continues with the others.\n"
      "Several processes and machines may map subjects in one FOLDER: --stage first; then --stage subjects --subjects "
      "NAME\nof each name that --stage list prints; then --stage group.\n"
      "For example:\n  orbicube study scans -o results");
  verb->callback([options, verb, &common] {
    Session session(common, "study", options->input);
    session.run([&] {
      refuse_unused_study_options(*verb);
      if (options->output.empty() && options->part.stage != "list")
        throw Failure(Exit::wrong_input, "", "usage", "--output is required; see 'orbicube study --help'");
      study(*options, common, session);
    });
  });
}

}  // namespace orbicube::cli
