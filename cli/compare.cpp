// orbicube compare: how far shapes are from each other, by their spherical harmonics, whichever way they lie.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/file.h"
#include "harmonics/coefficient_file.h"
#include "harmonics/spectrum.h"
#include "heat_map.h"
#include "verbs.h"

namespace orbicube::cli {
namespace {

struct CompareOptions {
  std::vector<std::string> files;
  std::string output, picture;
  std::uint32_t first = 0, last = harmonics::largest_degree;
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

void compare(const CompareOptions& options, Session& session) {
  session.options() = {{"files", options.files},
                       {"output", options.output},
                       {"png", options.picture},
                       {"from", options.first},
                       {"degree", options.last}};
  if (options.first > options.last) throw Failure(Exit::wrong_input, "", "usage", "--from is above --degree");
  std::deque<harmonics::Coefficients> shapes;
  for (const std::string& file : options.files) {
    shapes.push_back(about(file, Role::input, [&] {
      return harmonics::read_coefficients(file, harmonics::FileFormat::by_ending, session.host());
    }));
    if (shapes.back().channels != shapes.front().channels) {
      throw Failure(Exit::wrong_input, file, "invalid-argument",
                    std::to_string(shapes.back().channels) + " functions; " + options.files.front() + " has " +
                        std::to_string(shapes.front().channels));
    }
  }
  const std::size_t n = shapes.size();
  Matrix distance(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j)
      distance[i][j] = harmonics::shape_distance(shapes[i], shapes[j], options.first, options.last);
  }
  const auto write = [](const std::string& path, const auto& bytes_of) {
    if (path.empty()) return;
    about(path, Role::output, [&] {
      base::OutputFile file(path);
      file.write(bytes_of());
      file.commit();
    });
  };
  write(options.output, [&] { return table(options, distance); });
  write(options.picture, [&] { return heat_map_png(distance, session.host().memory); });
  session.figures() = {{"output", options.output}, {"shapes", n}, {"distance", distance}};
  std::size_t longest = 0;
  for (const std::string& file : options.files)
    longest = std::max(longest, std::filesystem::path(file).filename().string().size());
  for (std::size_t i = 0; i < n; ++i) {
    std::string line = std::filesystem::path(options.files[i]).filename().string();
    line.resize(longest, ' ');
    for (const double d : distance[i]) {
      char text[32];
      std::snprintf(text, sizeof text, " %10.4g", d);
      line += text;
    }
    session.say(line);
  }
}

}  // namespace

void add_compare(CLI::App& app, CommonOptions& common) {
  CLI::App* verb =
      app.add_subcommand("compare", "matrix of the distances between shapes, by their spherical harmonics");
  const auto options = std::make_shared<CompareOptions>();
  const auto degree = unnamed(CLI::Range(0U, harmonics::largest_degree));
  verb->add_option("COEFFS", options->files,
                   "coefficients, as 'orbicube harmonics' writes them: .sh .shtools .txt .coef")
      ->required()
      ->expected(2, 1 << 20)
      ->type_name("COEFFS...");
  verb->add_option("-o,--output", options->output, "write the matrix as a table of text")->type_name("matrix.txt");
  verb->add_option("--png", options->picture, "draw the matrix: black is alike, white the largest distance")
      ->type_name("FILE.png");
  verb->add_option("--degree", options->last, "compare degrees up to N (all)")->check(degree)->type_name("N");
  verb->add_option("--from", options->first, "compare degrees from N on (0); 1 leaves out where the shapes lie")
      ->check(degree)
      ->type_name("N");
  add_common_options(*verb, common);
  verb->footer(
      "The distance is the sum over the degrees l of (|f_l| - |g_l|)^2, |f_l| the norm of all coefficients of degree "
      "l.\n"
      "It does not change when a shape or its map is turned. Shapes of different sizes are compared as they are.");
  verb->callback([options, &common] {
    Session session(common, "compare", options->files.front());
    session.run([&] { compare(*options, session); });
  });
}

}  // namespace orbicube::cli
