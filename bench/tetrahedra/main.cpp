// Fills surfaces beside the command `tetgen` (Debian: tetgen), with the same settings. Seconds are those of the
// processor, children included, so that a busy machine does not change them much. The command's are without reading and
// writing files, as it prints them itself; ours are with every check.
//
//     bench-tetrahedra [surface files...]
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/search/tetrahedron_quality.h"
#include "mesh/shapes/make_shape.h"
#include "tetrahedra/tetrahedra.h"

using namespace orbicube;

namespace {

double seconds_of(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

struct Row {
  double seconds = 0;
  std::size_t tetrahedra = 0;
};

// What follows `label` in the text, or 0.
double number_after(const std::string& text, const std::string& label) {
  const std::size_t at = text.find(label);
  return at == std::string::npos ? 0 : std::strtod(text.c_str() + at + label.size(), nullptr);
}

// Nothing is filled in when there is no such command, or it fails.
Row run_command(const mesh::Mesh& surface, const std::filesystem::path& folder, const base::Host& host) {
  const std::filesystem::path file = folder / "surface.off";
  mesh::write_mesh(file, surface, {}, host);
  FILE* command = popen(("tetgen -pYq1.4MNEF '" + file.string() + "' 2>&1").c_str(), "r");
  std::string text;
  for (int c = command != nullptr ? std::fgetc(command) : EOF; c != EOF; c = std::fgetc(command))
    text += static_cast<char>(c);
  if (command != nullptr) pclose(command);
  return {number_after(text, "Total running seconds:") - number_after(text, "Opening") -
              number_after(text, "Output seconds:"),
          static_cast<std::size_t>(number_after(text, "Mesh tetrahedra:"))};
}

void row(const std::string& name, const mesh::Mesh& surface, const std::filesystem::path& folder,
         const base::Host& host) {
  const double parent = seconds_of(RUSAGE_SELF), child = seconds_of(RUSAGE_CHILDREN);
  std::printf("%-16s %9zu", name.c_str(), surface.triangles.size());
  try {
    const tetrahedra::Solid solid = tetrahedra::fill(surface.positions, surface.triangles, {}, host);
    const double ours = seconds_of(RUSAGE_SELF) - parent, tetgen = seconds_of(RUSAGE_CHILDREN) - child;
    const auto q = mesh::tetrahedron_quality(solid.positions, solid.tetrahedra, host);
    const auto count = static_cast<double>(solid.tetrahedra.size());
    std::printf(" %9zu %8.2f %8.2f %9.0f %8.2f %8.2f", solid.tetrahedra.size(), ours + tetgen, ours,
                count / (ours + tetgen), q.min_dihedral, q.mean_radius_ratio);
  } catch (const base::Error& error) {
    std::printf(" %s: %s\n", error.kind(), error.what());
    return;
  }
  const Row command = run_command(surface, folder, host);
  if (command.tetrahedra > 0) {
    std::printf(" | %9zu %8.2f %9.0f", command.tetrahedra, command.seconds,
                static_cast<double>(command.tetrahedra) / command.seconds);
  }
  std::printf("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  base::Host host;
  host.thread_count = 1;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("bench-tetrahedra-" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  std::printf("%-16s %9s %9s %8s %8s %9s %8s %8s | %9s %8s %9s\n", "surface", "triangles", "tets", "s", "of it us",
              "tets/s", "angle", "ratio", "command", "s", "tets/s");
  for (int i = 1; i < argc; ++i)
    row(std::filesystem::path(argv[i]).filename().string(), mesh::read_mesh(argv[i], {}, host), folder, host);
  if (argc == 1) {
    for (const std::size_t triangles : {2000, 8000, 32000, 128000})
      row("creature", mesh::make_shape("creature", {.triangles = triangles, .seed = 1}, host), folder, host);
  }
  std::filesystem::remove_all(folder);
  return 0;
}
