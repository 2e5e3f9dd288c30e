#include "session/unused_options.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "session/failure.h"

namespace orbicube::cli {
namespace {

// The text of an option, or what stands for it by default.
std::string given_or(const CLI::App& verb, const std::string& option, const std::string& otherwise) {
  return verb.count(option) > 0 ? verb.get_option(option)->as<std::string>() : otherwise;
}

// `use`: what the option is for.
void refuse_if(bool unused, const std::string& option, const std::string& use) {
  if (unused) throw Failure(Exit::wrong_input, "", "usage", option + " is for " + use);
}

// Refuses an option that is given without any of those that use it.
void refuse_without(const CLI::App& verb, const std::string& option, std::initializer_list<const char*> users) {
  if (verb.count(option) == 0) return;
  std::string use;
  for (const char* user : users) {
    if (verb.count(user) > 0) return;
    use += (use.empty() ? "" : std::string(user) == *(users.end() - 1) ? " and " : ", ") + std::string(user);
  }
  refuse_if(true, option, use);
}

}  // namespace

void refuse_unused_sphere_options(const CLI::App& verb) {
  const auto is_zero = [&](const char* option) {
    return verb.count(option) > 0 && !(verb.get_option(option)->as<double>() > 0);
  };
  if (is_zero("--angle-weight") && is_zero("--area-weight"))
    throw Failure(Exit::wrong_input, "", "usage", "--angle-weight and --area-weight: one of them must be positive");
  refuse_without(verb, "--grid", {"--remesh"});
  refuse_without(verb, "--image-grid", {"--image"});
  const std::string method = given_or(verb, "--method", "balanced");
  for (const char* weight : {"--angle-weight", "--area-weight"})
    refuse_if(verb.count(weight) > 0 && (method == "stretch" || method == "isometric" || method == "conformal"), weight,
              "the methods balanced, angle-area and dissertation");
  if (method == "dissertation" || method == "seed") return;
  for (const char* option :
       {"--level-splits", "--level-tolerance", "--final-tolerance", "--max-level-iterations", "--max-final-iterations"})
    refuse_if(verb.count(option) > 0, option, "--method dissertation");
}

void refuse_unused_repair_options(const CLI::App& verb) {
  const std::vector<std::string> skipped =
      verb.count("--skip") > 0 ? verb.get_option("--skip")->as<std::vector<std::string>>() : std::vector<std::string>();
  const auto is_skipped = [&](const char* step) {
    return std::find(skipped.begin(), skipped.end(), step) != skipped.end();
  };
  const auto refuse = [&](const char* option, const char* step) {
    refuse_if(verb.count(option) > 0 && is_skipped(step), option,
              std::string("the step ") + step + ", which is skipped");
  };
  refuse("--weld", "weld");
  refuse("--slivers", "slivers");
  refuse("--slivers", "clean");
  refuse("--max-move", "slivers");
  refuse("--max-move", "clean");
  refuse("--t-junctions", "t-junctions");
  refuse("--gap", "contacts");
  refuse("--gap", "orient");
  for (const char* option : {"--largest", "--keep", "--min-part", "--cavities"})
    refuse(option, "parts");
  refuse("--cavities", "orient");
  refuse("--fill-holes", "holes");
  refuse("--flat-patches", "holes");
  refuse_if(verb.count("--cavities") > 0 && verb.count("--min-part") == 0 && given_or(verb, "--keep", "1") == "1",
            "--cavities", "several parts; give --keep N, or 0 for all");
}

void refuse_unused_surface_options(const CLI::App& verb) {
  refuse_if(verb.count("--cavities") > 0 && verb.count("--keep-handles") == 0, "--cavities", "--keep-handles");
  refuse_if(verb.count("--smoothing") > 0 && verb.count("--max-slide") > 0 &&
                !(verb.get_option("--max-slide")->as<double>() > 0),
            "--smoothing", "a positive --max-slide");
}

void refuse_unused_frames_options(const CLI::App& verb) {
  for (const char* option :
       {"--boundary", "--method", "--face-weights", "--feature-angle", "--rounds", "--no-align-boundary"})
    refuse_if(verb.count("--unchanged") > 0 && verb.count(option) > 0, option,
              "a computation; --unchanged reports and draws a field only");
  const bool dissertation = given_or(verb, "--method", "smooth") == "dissertation";
  const std::string start = given_or(verb, "--start", "auto");
  const std::string own_start = "--method smooth; --method dissertation starts from identity";
  refuse_if(dissertation && start != "auto" && start != "identity", "--start " + start, own_start);
  refuse_if(dissertation && verb.count("--start-field") > 0, "--start-field", own_start);
  refuse_if(verb.count("--rounds") > 0 && (dissertation || start != "auto" || verb.count("--start-field") > 0),
            "--rounds", "--start auto of --method smooth");
}

void refuse_unused_polycube_options(const CLI::App& verb) {
  const bool common = verb.count("IN") > 1;
  const std::string optimize = given_or(verb, "--optimize", "");
  refuse_if(verb.count("--measure") > 0 && optimize != "domain" && !common, "--measure",
            "--optimize domain and for several surfaces; corners minimize the mean over the surface");
  const bool printed = given_or(verb, "--construct", "auto") == "dissertation";
  refuse_if(verb.count("--area-weight") > 0 && optimize.empty() && !common && !printed, "--area-weight",
            "--optimize, for --method dissertation and for several surfaces");
  const bool corners = optimize == "corners" || optimize == "all";
  refuse_if(verb.count("--corner-search") > 0 && !corners, "--corner-search", "--optimize corners and --optimize all");
  refuse_if(verb.count("--rounds") > 0 && (common || !(printed || corners)), "--rounds",
            "--method dissertation and for --optimize corners and --optimize all of one surface");
  refuse_if(corners && verb.count("--rounds") > 0 && verb.get_option("--rounds")->as<int>() == 0, "--rounds 0",
            "--method dissertation; --optimize " + optimize + " has one round or more");
  refuse_if(verb.count("--landmarks") > 0 && !common, "--landmarks", "several surfaces");
  refuse_without(verb, "--cells", {"--quads"});
  refuse_without(verb, "--cell-size", {"--quads"});
  for (const char* option : {"--atlas-size", "--atlas-padding", "--texture"})
    refuse_without(verb, option, {"--atlas"});
  refuse_if(verb.count("--constraints") > 0 && common, "--constraints",
            "one surface; corresponding points of several are --landmarks");
}

void refuse_unused_harmonics_options(const CLI::App& verb) {
  refuse_without(verb, "--align", {"--align-to"});
  refuse_without(verb, "--width", {"--low", "--high", "--band"});
  refuse_without(verb, "--text", {"--reconstruct", "--refined-map"});
}

void refuse_unused_map_options(const CLI::App& verb) {
  const bool polycube = verb.get_option_no_throw("--via") != nullptr && given_or(verb, "--via", "sphere") == "polycube";
  refuse_if(polycube && verb.count("--align") > 0, "--align", "--via sphere");
  refuse_if(verb.count("--landmarks") > 0 && verb.count("--align") > 0, "--align",
            "spheres without --landmarks, which replace it");
  if (verb.get_option_no_throw("--corners") != nullptr)
    refuse_if(!polycube && verb.count("--corners") > 0, "--corners", "--via polycube");
}

void refuse_unused_morph_options(const CLI::App& verb) {
  const bool polycube = verb.get_option_no_throw("--polycube") != nullptr && verb.count("--polycube") > 0;
  refuse_if(verb.count("--align") > 0 && (polycube || verb.count("--landmarks") > 0), "--align",
            "spheres without landmarks; --polycube and --landmarks have their own alignment");
  refuse_if(verb.count("--tolerance") > 0 && (polycube || given_or(verb, "--grid", "both") != "both"), "--tolerance",
            "--grid both");
  const bool blended = verb.count("--blend") > 0;
  for (const char* option : {"--intermediates", "--seconds", "--show-polycube"})
    if (verb.get_option_no_throw(option) != nullptr)
      refuse_if(blended && verb.count(option) > 0, option, "morph targets; --blend writes one shape");
}

void refuse_unused_hex_options(const CLI::App& verb) {
  refuse_without(verb, "--cut", {"--glb"});
  const std::string method = given_or(verb, "--method", "auto");
  const bool follows_frames = method == "frames" || (method == "auto" && verb.count("--frames") > 0),
             has_features = given_or(verb, "--features", "machined") != "off",
             is_near = verb.count("--distance") == 0 || verb.get_option("--distance")->as<double>() > 0;
  refuse_if(verb.count("--frames") > 0 && !follows_frames, "--frames", "--method frames");
  refuse_if(verb.count("--padding") > 0 && follows_frames, "--padding", "polycubes and grids, without frames");
  refuse_if(verb.count("--corners") > 0 && (follows_frames || method == "grid"), "--corners", "--method polycube");
  refuse_if(verb.count("--max-cells") > 0 && !is_near && !has_features, "--max-cells",
            "a positive --distance and for --features");
  refuse_if(verb.count("--feature-angle") > 0 && !has_features && (method == "polycube" || method == "grid"),
            "--feature-angle", "--features and --method frames");
}

void refuse_unused_tetrahedralize_options(const CLI::App& verb) {
  refuse_without(verb, "--growth", {"--sizing"});
}

void refuse_unused_study_options(const CLI::App& verb) {
  for (const char* option : {"--permutations", "--test"})
    refuse_without(verb, option, {"--groups", "--covariate"});
  refuse_if(verb.count("--subjects") > 0 && given_or(verb, "--stage", "all") != "subjects", "--subjects",
            "--stage subjects");
}

void refuse_unused_view_options(const CLI::App& verb) {
  refuse_without(verb, "--size", {"--png"});
}

}  // namespace orbicube::cli
