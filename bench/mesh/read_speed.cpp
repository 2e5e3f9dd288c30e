// How fast mesh files are written and read, on one core, beside what a program would do with the standard library
// alone.
// Seconds are those of the processor.
//
//   bench-mesh-read-speed [TRIANGLES]      one million by default
//
// Writes a made shape in every format to a new folder for temporary files, reads each file five times from the page
// cache, takes the fastest, and removes the folder. The files are those of write_mesh: 17 digits where they are text.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "mesh/shapes/make_shape.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

using Surface = std::pair<std::vector<std::array<double, 3>>, std::vector<Triangle>>;

// A loop over the lines with std::getline, and strtod and strtoul on each.
Surface read_obj_by_lines(const std::filesystem::path& path) {
  Surface surface;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    const char* at = line.c_str() + 1;
    char* end = nullptr;
    if (line[0] == 'v') {
      std::array<double, 3> p{};
      for (double& x : p) {
        x = std::strtod(at, &end);
        at = end;
      }
      surface.first.push_back(p);
    } else if (line[0] == 'f') {
      Triangle t{};
      for (Index& v : t) {
        v = static_cast<Index>(std::strtoul(at, &end, 10)) - 1;
        at = end;
      }
      surface.second.push_back(t);
    }
  }
  return surface;
}

// Formatted input from a stream.
Surface read_off_by_stream(const std::filesystem::path& path) {
  Surface surface;
  std::ifstream file(path);
  std::string magic;
  std::size_t vertices = 0, faces = 0, edges = 0, corners = 0;
  file >> magic >> vertices >> faces >> edges;
  surface.first.resize(vertices);
  for (auto& p : surface.first)
    file >> p[0] >> p[1] >> p[2];
  surface.second.resize(faces);
  for (Triangle& t : surface.second)
    file >> corners >> t[0] >> t[1] >> t[2];
  return surface;
}

template <class Work>
double seconds_of(const Work& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

template <class Work>
double least_seconds_of(int times, const Work& work) {
  double least = HUGE_VAL;
  for (int i = 0; i < times; ++i)
    least = std::min(least, seconds_of(work));
  return least;
}

// A block of cubes, each cut into six tetrahedra round its diagonal (Kuhn).
Mesh block(Index cubes) {
  Mesh mesh;
  const Index points = cubes + 1;
  for (Index k = 0; k < points; ++k) {
    for (Index j = 0; j < points; ++j) {
      for (Index i = 0; i < points; ++i)
        mesh.positions.push_back(Vector3(i, j, k) / 3.0);
    }
  }
  const std::array<Index, 3> step = {1, points, points * points};
  constexpr std::array<std::array<std::size_t, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (Index k = 0; k < cubes; ++k) {
    for (Index j = 0; j < cubes; ++j) {
      for (Index i = 0; i < cubes; ++i) {
        const Index a = i * step[0] + j * step[1] + k * step[2];
        for (std::size_t o = 0; o < orders.size(); ++o) {
          const Index b = a + step[orders[o][0]];
          const Index c = b + step[orders[o][1]];
          const Index d = c + step[orders[o][2]];
          mesh.tetrahedra.push_back(o < 3 ? Tetrahedron{a, b, c, d} : Tetrahedron{a, c, b, d});
        }
      }
    }
  }
  return mesh;
}

struct Row {
  const char* name;
  const char* file;
  bool binary;
  Surface (*peer)(const std::filesystem::path&);
  const char* peer_name;
};

void print_row(const Row& row, const std::filesystem::path& folder, const Mesh& mesh, const base::Host& host) {
  const std::filesystem::path path = folder / row.file;
  const double writing = seconds_of([&] { write_mesh(path, mesh, {.binary = row.binary}, host); });
  const double megabytes = static_cast<double>(std::filesystem::file_size(path)) * 1e-6;
  std::size_t cells = 0;
  constexpr int times = 5;
  const double reading = least_seconds_of(times, [&] {
    const Mesh again = read_mesh(path, {}, host);
    cells = again.triangles.size() + again.tetrahedra.size();
  });
  if (cells != mesh.triangles.size() + mesh.tetrahedra.size()) std::exit(EXIT_FAILURE);
  std::printf("%-22s %8.1f %10.0f %10.0f %12.2f", row.name, megabytes, megabytes / writing, megabytes / reading,
              static_cast<double>(cells) * 1e-6 / reading);
  if (row.peer) {
    const double peer = least_seconds_of(times, [&] {
      if (row.peer(path).second.size() != mesh.triangles.size()) std::exit(EXIT_FAILURE);
    });
    std::printf("  %6.0f (%s)", megabytes / peer, row.peer_name);
  }
  std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
  ShapeOptions options;
  options.triangles = count > 1 ? static_cast<std::size_t>(std::strtoull(arguments[1], nullptr, 10)) : 1'000'000;
  const base::Host host;
  const Mesh surface = make_shape("creature", options, host);
  const Mesh solid = block(static_cast<Index>(std::cbrt(static_cast<double>(options.triangles) / 6.0)));
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("orbicube-read-speed-" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);

  std::printf("%zu triangles, %zu vertices\n", surface.triangles.size(), surface.positions.size());
  std::printf("%-22s %8s %10s %10s %12s  %s\n", "", "MB", "write MB/s", "read MB/s", "M cells/s", "peer reads MB/s");
  const Row surfaces[] = {{"OBJ", "a.obj", false, read_obj_by_lines, "getline and strtod"},
                          {"OFF", "a.off", false, read_off_by_stream, "std::ifstream >>"},
                          {"PLY, ASCII", "a.ply", false, nullptr, nullptr},
                          {"PLY, binary", "b.ply", true, nullptr, nullptr},
                          {"STL, ASCII, joined", "a.stl", false, nullptr, nullptr},
                          {"STL, binary, joined", "b.stl", true, nullptr, nullptr},
                          {"MEDIT", "a.mesh", false, nullptr, nullptr},
                          {"VTK PolyData, ASCII", "a.vtk", false, nullptr, nullptr},
                          {"VTK PolyData, binary", "b.vtk", true, nullptr, nullptr}};
  const Row solids[] = {{"MEDIT, tetrahedra", "t.mesh", false, nullptr, nullptr},
                        {"VTK grid, ASCII", "t.vtk", false, nullptr, nullptr},
                        {"VTK grid, binary", "u.vtk", true, nullptr, nullptr}};
  for (const Row& row : surfaces)
    print_row(row, folder, surface, host);
  std::printf("%zu tetrahedra, %zu vertices (read with the check that they are those of a solid)\n",
              solid.tetrahedra.size(), solid.positions.size());
  for (const Row& row : solids)
    print_row(row, folder, solid, host);
  std::filesystem::remove_all(folder);
}
