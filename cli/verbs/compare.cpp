// orbicube compare: how far shapes are from each other, by their spherical harmonics, whichever way they lie.
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/counted.h"
#include "base/files/file.h"
#include "harmonics/functions/coefficient_file.h"
#include "harmonics/functions/spectrum.h"
#include "scenes/heat_map.h"
#include "verbs/verbs.h"

namespace orbicube::cli {
namespace {

struct CompareOptions {
  std::vector<std::string> files;
  std::string output, picture;
  std::uint32_t first = 0, last = harmonics::largest_degree;
  bool keep_size = false;
};

using Matrix = std::vector<std::vector<double>>;

// Rows of numbers, with the files' names in comments: what table readers take.
std::string table(const CompareOptions& options, const Matrix& distance) {
  std::string text = "# D_n of the coefficients in\n";
  for (std::size_t i = 0; i < options.files.size(); ++i)
    text += "# " + std::to_string(i + 1) + " " + options.files[i] + "\n";
  for (const std::vector<double>& row : distance) {
    for (std::size_t j = 0; j < row.size(); ++j) {
      char digits[32];
      text += j > 0 ? " " : "";
      text.append(digits, std::to_chars(digits, digits + sizeof digits, row[j]).ptr);
    }
    text += '\n';
  }
  return text;
}

// The root of the mean square distance of the surface from its mean point, over the sphere, times the root of 4 pi:
// what all degrees but 0 have together.
double size_of(const harmonics::Coefficients& shape) {
  std::vector<double> norms(shape.degree + std::size_t{1});
  harmonics::degree_norms(shape, norms);
  double sum = 0;
  for (std::size_t l = 1; l < norms.size(); ++l)
    sum += norms[l] * norms[l];
  return std::sqrt(sum);
}

// Rows with number and name, in colors where they are looked at.
void show(const CompareOptions& options, const Matrix& distance, Session& session) {
  const bool colors = ::isatty(STDOUT_FILENO) == 1 && std::getenv("NO_COLOR") == nullptr;
  std::size_t longest = 0;
  double largest = 0;
  for (std::size_t i = 0; i < distance.size(); ++i) {
    longest = std::max(longest, std::filesystem::path(options.files[i]).filename().string().size());
    largest = std::max(largest, *std::max_element(distance[i].begin(), distance[i].end()));
  }
  const std::size_t digits = std::to_string(distance.size()).size();
  char text[80];
  std::string head(digits + 1 + longest, ' ');
  for (std::size_t i = 0; i < distance.size(); ++i) {
    std::snprintf(text, sizeof text, " %10zu", i + 1);
    head += text;
  }
  session.say(head);
  for (std::size_t i = 0; i < distance.size(); ++i) {
    std::string line = std::to_string(i + 1);
    line.insert(0, digits - line.size(), ' ');
    std::string name = std::filesystem::path(options.files[i]).filename().string();
    name.resize(longest, ' ');
    line += " " + name;
    for (const double d : distance[i]) {
      const double share = largest > 0 ? d / largest : 0;
      const auto [red, green, blue] = heat_color(share);
      if (colors) {
        std::snprintf(text, sizeof text, "\033[48;2;%u;%u;%um\033[%sm", unsigned{red}, unsigned{green}, unsigned{blue},
                      share < 0.5 ? "97" : "30");
        line += text;
      }
      std::snprintf(text, sizeof text, " %10.4g", d);
      line += text + std::string(colors ? "\033[0m" : "");
    }
    session.say(line);
  }
}

void compare(const CompareOptions& options, Session& session) {
  session.options() = {{"files", options.files},      {"output", options.output}, {"png", options.picture},
                       {"min_degree", options.first}, {"degree", options.last},   {"keep_size", options.keep_size}};
  if (options.first > options.last) throw Failure(Exit::wrong_input, "", "usage", "--from is above --degree");
  std::deque<harmonics::Coefficients> shapes;
  for (const std::string& file : options.files) {
    const base::Stage stage(session.host(), 1.0 / static_cast<double>(options.files.size() - shapes.size()));
    shapes.push_back(about(file, Role::input, [&] {
      return harmonics::read_coefficients(file, harmonics::FileFormat::by_ending, session.host());
    }));
    if (shapes.back().channels != shapes.front().channels) {
      throw Failure(Exit::wrong_input, file, "invalid-argument",
                    base::counted(shapes.back().channels, "function") + "; " + options.files.front() + " has " +
                        std::to_string(shapes.front().channels));
    }
  }
  Json sizes = Json::array();
  for (harmonics::Coefficients& shape : shapes) {
    const double size = size_of(shape);
    sizes.push_back(size);
    if (options.keep_size || !(size > 0)) continue;
    for (double& value : shape.values)
      value /= size;
  }
  const std::size_t n = shapes.size();
  Matrix distance(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      distance[i][j] = harmonics::shape_distance(shapes[i], shapes[j], options.first, options.last);
  }
  const auto write = [&session](const std::string& path, const auto& bytes_of) {
    if (path.empty()) return;
    about(path, Role::output, [&] {
      base::OutputFile file(session.stage(path));
      file.write(bytes_of());
      file.commit();
    });
  };
  write(options.output, [&] { return table(options, distance); });
  write(options.picture, [&] { return heat_map_png(distance, session.host()); });
  session.figures() = {
      {"output", options.output}, {"shapes", n}, {"names", options.files}, {"size", sizes}, {"distance", distance}};
  show(options, distance, session);
}

}  // namespace

void add_compare(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("compare", "compute the distances between shapes from their spherical harmonics");
  const auto options = std::make_shared<CompareOptions>();
  const auto degree = unnamed(CLI::Range(0U, harmonics::largest_degree));
  verb->add_option("COEFFS", options->files, "coefficients, written by 'orbicube harmonics': .sh .shtools .txt .coef")
      ->required()
      ->expected(2, 1 << 20)
      ->type_name("COEFFS...");
  verb->add_option("-o,--output", options->output, "write the matrix as a text table")->type_name("matrix.txt");
  verb->add_option("--png", options->picture,
                   "draw the matrix: black for equal shapes, light yellow for the maximum distance")
      ->type_name("FILE.png");
  verb->add_option("--degree", options->last, "compare degrees up to L [default: all]")->check(degree)->type_name("L");
  verb->add_option("--min-degree", options->first,
                   "compare degrees from L on; 1 ignores the positions of the shapes [default: 0]")
      ->check(degree)
      ->type_name("L");
  verb->add_flag("--keep-size", options->keep_size, "compare shapes without normalization of their sizes");
  add_common_options(*verb, common);
  verb->footer(
      "The distance is the sum over the degrees l of (|f_l| - |g_l|)^2, |f_l| the norm of all coefficients of degree "
      "l.\nRotations of a shape or its map have no effect, so that no alignment is necessary. Shapes are first "
      "normalized\nto norm 1 of all degrees from 1 on.");
  verb->callback([options, &common] {
    Session session(common, "compare", options->files.front());
    session.run([&] { compare(*options, session); });
  });
}

}  // namespace orbicube::cli
