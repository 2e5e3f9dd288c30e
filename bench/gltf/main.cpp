// Prints a table: seconds and MB/s of writing and reading a torus of a million triangles (or the number in the
// argument) in the forms that a file may have, processor time, the best of five runs each. tinygltf reads beside: it
// copies buffers and stops there, where ours checks every value, converts to doubles, and sees whether the surface is
// closed.
//
// Usage: bench-gltf [triangles]
#include <orbicube/gltf.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

#ifdef ORBICUBE_BENCH_TINYGLTF
#include <tiny_gltf.h>
#endif

namespace {

struct Surface {
  std::vector<float> positions, moved, texture_coordinates;
  std::vector<std::uint32_t> triangles;
};

// A torus of n by n / 2 quads. With `seams`, every row has vertices of its own at its two ends, as exporters leave
// them.
Surface torus(std::uint32_t n, bool seams) {
  Surface surface;
  const std::uint32_t m = n / 2, row = seams ? m + 1 : m, rows = seams ? n + 1 : n;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < row; ++j) {
      const double u = 2 * M_PI * (i % n) / n, v = 2 * M_PI * (j % m) / m, r = 2 + std::cos(v);
      for (const double x : {r * std::cos(u), r * std::sin(u), std::sin(v)}) {
        surface.positions.push_back(static_cast<float>(x));
        surface.moved.push_back(static_cast<float>(x / std::sqrt(r * r + 1)));
      }
      surface.texture_coordinates.push_back(static_cast<float>(i) / static_cast<float>(n));
      surface.texture_coordinates.push_back(static_cast<float>(j) / static_cast<float>(m));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const std::uint32_t next = (i + 1) % rows * row, here = i * row, right = (j + 1) % row;
      surface.triangles.insert(surface.triangles.end(),
                               {here + j, next + j, next + right, here + j, next + right, here + right});
    }
  }
  return surface;
}

template <class Run>
double best_seconds(const Run& run) {
  double best = HUGE_VAL;
  for (int i = 0; i < 5; ++i) {
    const std::clock_t start = std::clock();
    if (!run()) return NAN;
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  return best;
}

bool read_ours(const std::string& path, std::int32_t weld) {
  obc_gltf_read_options options;
  obc_gltf_read_options_init(&options, sizeof options);
  options.weld_identical = weld;
  obc_gltf_surface* surface = nullptr;
  const bool read = obc_gltf_read(path.c_str(), &options, nullptr, &surface, nullptr) == OBC_OK;
  obc_gltf_surface_destroy(surface);
  return read;
}

double tinygltf_seconds([[maybe_unused]] const std::string& path) {
#ifdef ORBICUBE_BENCH_TINYGLTF
  return best_seconds([&] {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error, warning;
    return path.ends_with(".glb") ? loader.LoadBinaryFromFile(&model, &error, &warning, path)
                                  : loader.LoadASCIIFromFile(&model, &error, &warning, path);
  });
#else
  return NAN;
#endif
}

}  // namespace

int main(int count, char** arguments) {
  const double triangles = count > 1 ? std::atof(arguments[1]) : 1e6;
  const auto n = static_cast<std::uint32_t>(std::max(8.0, std::sqrt(triangles)));
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "orbicube-bench-gltf";
  std::filesystem::create_directories(folder);
  std::printf("processor time, best of five, seconds (MB/s)\n%-34s %7s %15s %15s %15s %15s\n", "", "MB", "write",
              "read", "read, no weld", "tinygltf, load");
  struct Row {
    const char *name, *file;
    bool seams, more;
  };
  for (const Row& row :
       {Row{"GLB, positions", "surface.glb", false, false},
        Row{"GLB, morph target, normals, UV", "more.glb", false, true},
        Row{"GLB, seams (welded)", "seams.glb", true, false}, Row{"glTF, base64", "surface.gltf", false, false}}) {
    const Surface surface = torus(n, row.seams);
    const std::string path = (folder / row.file).string();
    const obc_gltf_morph_target target = {"moved", surface.moved.data()};
    obc_gltf_scene scene;
    obc_gltf_scene_init(&scene, sizeof scene);
    scene.positions = surface.positions.data();
    scene.vertex_count = surface.positions.size() / 3;
    scene.triangles = surface.triangles.data();
    scene.triangle_count = surface.triangles.size() / 3;
    if (row.more) {
      scene.smooth_normals = 1;
      scene.texture_coordinates = surface.texture_coordinates.data();
      scene.morph_targets = &target;
      scene.morph_target_count = 1;
    }
    const double write = best_seconds([&] { return obc_gltf_write(path.c_str(), &scene, nullptr, nullptr) == OBC_OK; });
    const double megabytes = static_cast<double>(std::filesystem::file_size(path)) / 1e6;
    std::printf("%-34s %7.1f", row.name, megabytes);
    for (const double seconds : {write, best_seconds([&] { return read_ours(path, 1); }),
                                 best_seconds([&] { return read_ours(path, 0); }), tinygltf_seconds(path)}) {
      std::printf("   %.3f (%4.0f)", seconds, megabytes / seconds);
    }
    std::printf("\n");
  }
  std::filesystem::remove_all(folder);
  return 0;
}
