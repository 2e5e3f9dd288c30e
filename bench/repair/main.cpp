// Repairs surfaces that it damages first, and prints what came out beside what they were.
//
//   bench-repair [--seeds N] [--max-triangles N] [--damaged FOLDER] FILE...
//
// --damaged also writes what is repaired, NAME-SEED.off, and what it was before the damage, NAME-SEED.clean.off, for
// peers.py, which compares other programs.
//
// Damage of one surface: 20 holes of one ring, 200 faces flipped, 100 corners torn off (half of them by 1e-8 of the
// diagonal), 20 T-junctions, 50 slivers, 5 specks. Models with more than one part are passed over.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/files/read.h"
#include "mesh/files/write.h"
#include "repair/repair.h"
#include "tests/repair/damage.h"

using namespace orbicube;

namespace {

void damage(mesh::Mesh& m, double diagonal, std::uint64_t seed) {
  base::Random random(seed);
  test::add_slivers(m, 50, 1e-9, random);
  test::add_holes(m, 20, random);
  test::flip_some(m, 200, random);
  test::add_t_junctions(m, 20, random);
  test::tear(m, 50, 0, random);
  test::tear(m, 50, 1e-8 * diagonal, random);
  for (int i = 0; i < 5; ++i) {
    const mesh::Vector3 place = m.positions[0] + diagonal * mesh::Vector3(2 + random.unit(), random.unit(), i);
    m = test::together(m, test::cube(place, 0.001 * diagonal));
  }
}

std::string name_of(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

// Returns whether all is as it was. `folder`: for the damaged surface, or empty.
bool run(const std::string& path, const mesh::Mesh& clean, const repair::Certificate& before, std::uint64_t seed,
         const std::string& folder) {
  mesh::Mesh m = clean;
  mesh::Vector3 low = m.positions[0], high = low;
  for (const mesh::Vector3& p : m.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double diagonal = (high - low).norm();
  damage(m, diagonal, seed);
  if (!folder.empty()) {
    const std::string name = name_of(path), stem = folder + "/" + name.substr(0, name.find_last_of('.')) + "-";
    mesh::write_mesh(stem + std::to_string(seed) + ".off", m, {}, base::Host());
    mesh::write_mesh(stem + std::to_string(seed) + ".clean.off", clean, {}, base::Host());
  }
  const auto start = std::chrono::steady_clock::now();
  const repair::Repaired r = repair::repair(m.positions, m.triangles, {}, base::Host());
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  const repair::Certificate& c = r.report.certificate;
  const bool same = c.is_solid() && c.parts == 1 && c.genus == before.genus;
  std::printf("| %s | %zu | %s | %lld | %lld | %zu | %zu | %zu | %.1e | %.3f | %.2f |\n", name_of(path).c_str(),
              m.triangles.size(), c.is_solid() ? "yes" : repair::shortcomings(c).c_str(),
              static_cast<long long>(before.genus), static_cast<long long>(c.genus), before.self_intersections,
              c.self_intersections, r.report.holes.filled,
              std::max(r.report.move.from_input, r.report.move.from_result) / diagonal,
              100 * (c.volume / before.volume - 1), seconds.count());
  std::fflush(stdout);
  return same;
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t seeds = 1;
  std::size_t max_triangles = 100'000, runs = 0, same = 0;
  std::vector<std::string> paths;
  std::string folder;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--seeds") == 0 && i + 1 < argc) {
      seeds = std::strtoull(argv[++i], nullptr, 10);
    } else if (std::strcmp(argv[i], "--max-triangles") == 0 && i + 1 < argc) {
      max_triangles = std::strtoull(argv[++i], nullptr, 10);
    } else if (std::strcmp(argv[i], "--damaged") == 0 && i + 1 < argc) {
      folder = argv[++i];
    } else {
      paths.emplace_back(argv[i]);
    }
  }
  std::printf(
      "| model | triangles | solid | genus before | after | intersecting pairs before | after | holes | moved / "
      "diagonal | "
      "volume, %% | s |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const std::string& path : paths) {
    try {
      const mesh::Mesh m = mesh::read_mesh(path, {}, base::Host());
      if (!m.tetrahedra.empty() || !m.hexahedra.empty() || m.triangles.size() > max_triangles) continue;
      const repair::Repaired clean = repair::repair(m.positions, m.triangles, {}, base::Host());
      if (!clean.report.certificate.is_solid() || clean.report.parts.found > 1) continue;
      mesh::Mesh start;
      start.positions = clean.surface.positions;
      start.triangles = clean.surface.triangles;
      for (std::uint64_t seed = 0; seed < seeds; ++seed) {
        ++runs;
        same += run(path, start, clean.report.certificate, seed, folder);
      }
    } catch (const base::Error& e) {
      std::printf("| %s | %s: %s |\n", name_of(path).c_str(), e.kind(), e.what());
    }
  }
  std::printf("\n%zu of %zu closed, oriented, manifold, in one part and of the genus that they had\n", same, runs);
  return 0;
}
