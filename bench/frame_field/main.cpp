// Energy, structure, time and memory of frame fields beside the best known ones, and the dissertation's procedure.
//
//   bench-frame-field targets FOLDER   the meshes of the table below that FOLDER has: default options against the best
//                                      energy known, and the harmonic start alone for its time
//   bench-frame-field seed FOLDER      against method seed: E, curves and nodes, angles with symmetry and without
//   bench-frame-field scaling          iterations and time by size, on a ball made here
//
// Times are CPU seconds of this thread where one is used, which other programs on the machine hardly change.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "base/error.h"
#include "bench/measuring.h"
#include "frame_field/boundary_indices.h"
#include "frame_field/constraints.h"
#include "frame_field/diffusion.h"
#include "frame_field/frame_field.h"
#include "frame_field/hierarchy.h"
#include "frame_field/measurement.h"
#include "frame_field/singularities.h"
#include "frame_field/smoothing.h"
#include "mesh/predicates.h"
#include "mesh/read.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using bench::cpu_seconds;

namespace {

// The least energies known before, of any method, on these very files (harmonic start, diffusion and Gauss-Seidel; the
// peer, AlgoHex, ends between 1.01 and 2.9 times that, with boundary frames off by up to 8 degrees).
struct Known {
  const char* file;
  double energy;
};
constexpr Known known[] = {{"ball.mesh", 50.8},  {"rod.mesh", 171.7},       {"hanger.mesh", 90.1},
                           {"joint.mesh", 80.6}, {"rockerarm.mesh", 781.5}, {"fertility.mesh", 794.7}};

base::Host one_thread() {
  base::Host host;
  host.thread_count = 1;
  return host;
}

struct Result {
  Measurement figures;
  std::size_t edges = 0, curves = 0, nodes = 0, dead_ends = 0;
  bool indices_fit = false;
};

Result analysed(const mesh::Mesh& solid, const Field& field, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  Result r;
  r.figures = measure(solid.positions, connectivity, field, host);
  const SingularGraph graph =
      singular_graph(solid.positions, connectivity, field, matchings(connectivity, field, host), host);
  r.edges = graph.edges.size();
  r.curves = graph.curves();
  r.nodes = graph.nodes.size();
  r.dead_ends = graph.dead_ends.size();
  const BoundaryIndices indices = boundary_indices(solid.positions, connectivity, field, host);
  r.indices_fit = indices.sum_of_quarters == 4 * indices.euler_characteristic;
  return r;
}

// body(mesh, row) for the meshes that are there.
template <class Body>
void for_each_mesh(const std::filesystem::path& folder, const Body& body) {
  for (const Known& row : known) {
    const std::filesystem::path path = folder / row.file;
    if (!std::filesystem::exists(path)) continue;
    body(mesh::read_mesh(path, {}, base::Host()), row);
    std::fflush(stdout);
  }
}

void targets(const std::filesystem::path& folder) {
  std::printf(
      "| mesh | tets | E | best known | quotient | mean / p99 / max | singular edges | curves + nodes | off the normal "
      "|"
      " CPU s | harmonic start s | + smoothing s | bytes a tet |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  const base::Host host = one_thread();
  for_each_mesh(folder, [&](const mesh::Mesh& solid, const Known& row) {
    double begin = cpu_seconds();
    const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
    const DualGraph graph = make_dual_graph(solid.positions, connectivity, Weighting::uniform, host);
    Constraints constraints = make_constraints(graph, solid.positions, connectivity, true, {}, {}, host);
    const auto hierarchy = make_hierarchy(graph, 60, host);
    double start = 0, smoothing = 0;
    {
      Field field(host.memory);
      {
        Diffusion diffusion(graph, hierarchy, constraints, host);
        field = diffusion.harmonic_start();
      }
      start = cpu_seconds() - begin;
      smooth(graph, hierarchy, constraints, {.relative_gain = 1e-5}, host, field);
      smoothing = cpu_seconds() - begin;
    }
    begin = cpu_seconds();
    bench::CountingMemory memory;
    base::Host counting = one_thread();
    counting.memory = &memory;
    const Outcome outcome = compute(solid.positions, solid.tetrahedra, {}, {}, counting);
    const double seconds = cpu_seconds() - begin;
    const double bytes = static_cast<double>(memory.peak()) / static_cast<double>(solid.tetrahedra.size());
    const Result r = analysed(solid, outcome.field, host);
    std::printf(
        "| %s | %zu | %.1f | %.1f | %.3f | %.2f / %.1f / %.1f | %zu | %zu + %zu | %.0e | %.1f | %.2f | %.2f | %.0f "
        "|%s\n",
        row.file, solid.tetrahedra.size(), r.figures.energy, row.energy, r.figures.energy / row.energy,
        r.figures.symmetric.mean, r.figures.symmetric.p99, r.figures.symmetric.largest, r.edges, r.curves, r.nodes,
        std::max(r.figures.one_face_largest, r.figures.several_best_largest), seconds, start, smoothing, bytes,
        r.dead_ends == 0 && r.indices_fit ? "" : " INVALID");
  });
}

void against_seed(const std::filesystem::path& folder) {
  std::printf(
      "| mesh | | E | angles with symmetry: mean / sd / max | without: mean / sd / max | curves + nodes | CPU s |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  const base::Host host = one_thread();
  for_each_mesh(folder, [&](const mesh::Mesh& solid, const Known& row) {
    double energies[2];
    std::size_t structure[2];
    for (int k = 0; k < 2; ++k) {
      const double begin = cpu_seconds();
      const Outcome outcome =
          compute(solid.positions, solid.tetrahedra, {.method = k == 0 ? Method::seed : Method::smooth}, {}, host);
      const double seconds = cpu_seconds() - begin;
      const Result r = analysed(solid, outcome.field, host);
      energies[k] = r.figures.energy;
      structure[k] = r.curves + r.nodes;
      const AngleStatistics &s = r.figures.symmetric, &p = r.figures.plain;
      std::printf("| %s | %s | %.1f | %.2f / %.2f / %.1f | %.2f / %.2f / %.1f | %zu + %zu | %.1f |\n", row.file,
                  k == 0 ? "seed" : "smooth", r.figures.energy, s.mean, s.deviation, s.largest, p.mean, p.deviation,
                  p.largest, r.curves, r.nodes, seconds);
    }
    std::printf("| | quotient | %.2f | | | 1 / %.1f | |\n", energies[1] / energies[0],
                static_cast<double>(structure[0]) / static_cast<double>(structure[1]));
  });
}

// A ball of cubes cut in six.
mesh::Mesh made_ball(mesh::Index n) {
  mesh::Mesh solid;
  const auto at = [&](const std::array<mesh::Index, 3>& p) { return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2]; };
  for (mesh::Index v = 0; v < (n + 1) * (n + 1) * (n + 1); ++v) {
    mesh::Vector3 p(v / ((n + 1) * (n + 1)), v / (n + 1) % (n + 1), v % (n + 1));
    p = p * (2.0 / n) - mesh::Vector3::Ones();
    const double longest = p.cwiseAbs().maxCoeff();
    solid.positions.emplace_back(longest > 0 ? p * (0.2 + 0.8 * longest / p.norm()) : p);
  }
  for (mesh::Index cube = 0; cube < n * n * n; ++cube) {
    std::array<std::size_t, 3> order{0, 1, 2};
    do {
      std::array<mesh::Index, 3> p{cube / (n * n), cube / n % n, cube % n};
      mesh::Tetrahedron t{};
      t[0] = at(p);
      for (std::size_t k = 0; k < 3; ++k) {
        ++p[order[k]];
        t[k + 1] = at(p);
      }
      const auto& x = solid.positions;
      if (mesh::orientation_3d(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) < 0) std::swap(t[2], t[3]);
      solid.tetrahedra.push_back(t);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  return solid;
}

void scaling() {
  std::printf("| tets | iterations of the harmonic start | CPU s | smoothing steps | iterations | CPU s |\n");
  std::printf("|---|---|---|---|---|---|\n");
  const base::Host host = one_thread();
  for (const mesh::Index n : {12U, 19U, 26U, 36U}) {
    const mesh::Mesh solid = made_ball(n);
    double begin = cpu_seconds();
    const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
    const DualGraph graph = make_dual_graph(solid.positions, connectivity, Weighting::uniform, host);
    Constraints constraints = make_constraints(graph, solid.positions, connectivity, true, {}, {}, host);
    const auto hierarchy = make_hierarchy(graph, 60, host);
    Diffusion diffusion(graph, hierarchy, constraints, host);
    Field field = diffusion.harmonic_start();
    const double start = cpu_seconds() - begin;
    begin = cpu_seconds();
    const SmoothingResult r = smooth(graph, hierarchy, constraints, {.relative_gain = 1e-5}, host, field);
    std::printf("| %zu | %u | %.2f | %u | %u | %.2f |\n", solid.tetrahedra.size(), diffusion.iterations(), start,
                r.steps, r.solver_iterations, cpu_seconds() - begin);
    std::fflush(stdout);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    if (what == "targets" && argc == 3) {
      targets(argv[2]);
    } else if (what == "seed" && argc == 3) {
      against_seed(argv[2]);
    } else if (what == "scaling" && argc == 2) {
      scaling();
    } else {
      std::fprintf(stderr, "usage: bench-frame-field targets FOLDER | seed FOLDER | scaling\n");
      return 2;
    }
  } catch (const base::Error& e) {
    std::fprintf(stderr, "bench-frame-field: %s: %s\n", e.kind(), e.what());
    return 1;
  }
  return 0;
}
