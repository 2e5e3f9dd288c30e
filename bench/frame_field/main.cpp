// Energy, structure, time and memory of frame fields beside the best known ones, and the dissertation's procedure.
//
//   bench-frame-field targets FOLDER   the meshes of the table below that FOLDER has: default options against the best
//                                      energy known, and the harmonic start alone for its time
//   bench-frame-field fields FILE...   the default and the method of the dissertation on each mesh, the latter also
//   with the default's frames
//                                      at the boundary: all figures, tab-separated, for tables.py
//   bench-frame-field scaling [FILE...]  iterations and time by size, on a ball made here and on meshes cut into eight
//   bench-frame-field repairs FOLDER   on the meshes of the table: what is not meshable and E, before repairs and after
//
// Times are CPU seconds of this thread where one is used, which other programs on the machine hardly change.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "bench/measuring.h"
#include "frame_field/frame_field.h"
#include "frame_field/graph/boundary_indices.h"
#include "frame_field/graph/constraints.h"
#include "frame_field/graph/hierarchy.h"
#include "frame_field/singularities/measurement.h"
#include "frame_field/singularities/singularities.h"
#include "frame_field/smoothing/diffusion.h"
#include "frame_field/smoothing/smoothing.h"
#include "mesh/files/read.h"
#include "mesh/search/predicates.h"

using namespace orbicube;
using namespace orbicube::frame_field;
using bench::cpu_seconds;

namespace {

// The lowest energies of other methods on these files (harmonic start, diffusion and Gauss-Seidel; the
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
  std::size_t edges = 0, quarter_turns = 0, curves = 0, nodes = 0;
  double length_share = 0;  // of the length of all inner edges
  bool valid = false;
  double off_normals() const { return figures.one_face_max; }
};

Result analysed(const mesh::Mesh& solid, const Field& field, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  Result r;
  r.figures = measure(solid.positions, connectivity, field, host);
  const SingularGraph graph =
      singular_graph(solid.positions, connectivity, field, matchings(connectivity, field, host), host);
  r.edges = graph.edges.size();
  r.quarter_turns = graph.by_class[static_cast<std::size_t>(quaternion::CubeClass::face_quarter)];
  r.curves = graph.curves();
  r.nodes = graph.nodes.size();
  r.length_share = graph.inner_length > 0 ? graph.singular_length / graph.inner_length : 0;
  const BoundaryIndices indices = boundary_indices(solid.positions, connectivity, field, host);
  r.valid = graph.dead_ends.empty() && indices.sum_of_quarters == 4 * indices.euler_characteristic &&
            r.figures.symmetric.largest <= 62.80 && r.off_normals() < 1e-6;
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
        r.off_normals(), seconds, start, smoothing, bytes, r.valid ? "" : " INVALID");
  });
}

// A line of figures for each mesh and method, and one of the parts of inner faces with an angle of at most 1, 2, ...
// degrees. Columns: see FIELDS in tables.py.
// The frames of a field at the boundary, to be fixed.
std::vector<GivenFrame> boundary_frames(const mesh::Mesh& solid, const Field& field, const base::Host& host) {
  const mesh::TetrahedralConnectivity connectivity(solid.positions.size(), solid.tetrahedra, host);
  std::vector<GivenFrame> frames;
  for (Index t = 0; t < field.size(); ++t) {
    bool outer = false;
    for (Index k = 0; k < 4; ++k)
      outer = outer || connectivity.on_boundary(4 * t + k);
    if (outer) frames.push_back({t, field[t]});
  }
  return frames;
}

void fields(std::span<char* const> files) {
  const base::Host host = one_thread();
  for (const std::filesystem::path path : files) {
    const mesh::Mesh solid = mesh::read_mesh(path, {}, base::Host());
    std::vector<GivenFrame> boundary;
    for (const std::string_view what : {"default", "dissertation", "seed, boundary of default"}) {
      const double begin = cpu_seconds();
      const Outcome outcome = compute(
          solid.positions, solid.tetrahedra, {.method = what == "default" ? Method::smooth : Method::dissertation},
          {.frames = what.ends_with("default") ? std::span<const GivenFrame>(boundary) : std::span<const GivenFrame>(),
           .axes = {}},
          host);
      const double seconds = cpu_seconds() - begin;
      if (what == "default") boundary = boundary_frames(solid, outcome.field, host);
      const Result r = analysed(solid, outcome.field, host);
      const std::string name = path.stem().string() + "\t" + std::string(what);
      std::printf("field\t%s\t%zu\t%zu\t%.6g", name.c_str(), solid.tetrahedra.size(), r.figures.inner_faces,
                  r.figures.energy);
      for (const AngleStatistics& a : {r.figures.symmetric, r.figures.plain})
        std::printf("\t%.4g\t%.4g\t%.4g\t%.4g\t%.4g", a.mean, a.deviation, a.median, a.p99, a.largest);
      std::printf("\t%zu\t%zu\t%zu\t%zu\t%zu\t%.4g\t%.1e\t%.4g\t%s\n", r.figures.above_30, r.edges, r.quarter_turns,
                  r.curves, r.nodes, r.length_share, r.off_normals(), seconds, r.valid ? "valid" : "invalid");
      std::printf("angles\t%s", name.c_str());
      std::size_t below = 0;
      for (const std::size_t n : r.figures.histogram)
        std::printf("\t%.5f", static_cast<double>(below += n) / static_cast<double>(r.figures.inner_faces));
      std::printf("\n");
      std::fflush(stdout);
    }
  }
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

// Each tetrahedron cut into eight: one at each corner, four about a diagonal of what is left.
mesh::Mesh refined(const mesh::Mesh& solid) {
  mesh::Mesh result;
  result.positions = solid.positions;
  std::map<std::pair<mesh::Index, mesh::Index>, mesh::Index> middles;
  const auto middle = [&](mesh::Index a, mesh::Index b) {
    const auto [place, added] =
        middles.try_emplace(std::minmax(a, b), static_cast<mesh::Index>(result.positions.size()));
    if (added) result.positions.push_back(0.5 * (solid.positions[a] + solid.positions[b]));
    return place->second;
  };
  const auto add = [&](mesh::Tetrahedron t) {
    const auto& x = result.positions;
    if (mesh::orientation_3d(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) < 0) std::swap(t[2], t[3]);
    result.tetrahedra.push_back(t);
  };
  for (const mesh::Tetrahedron& t : solid.tetrahedra) {
    for (std::size_t k = 0; k < 4; ++k) {
      const mesh::Index v = t[k];
      add({v, middle(v, t[(k + 1) % 4]), middle(v, t[(k + 2) % 4]), middle(v, t[(k + 3) % 4])});
    }
    const mesh::Index ring[] = {middle(t[0], t[1]), middle(t[0], t[3]), middle(t[2], t[3]), middle(t[1], t[2])};
    for (std::size_t k = 0; k < 4; ++k)
      add({middle(t[0], t[2]), middle(t[1], t[3]), ring[k], ring[(k + 1) % 4]});
  }
  return result;
}

void scaling_row(const char* name, const mesh::Mesh& solid) {
  const base::Host host = one_thread();
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
  std::printf("%s\t%zu\t%u\t%.2f\t%u\t%u\t%.2f\n", name, solid.tetrahedra.size(), diffusion.iterations(), start,
              r.steps, r.solver_iterations, cpu_seconds() - begin);
  std::fflush(stdout);
}

void scaling(std::span<char* const> files) {
  std::printf("solid\ttets\tharmonic iterations\tCPU s\tsmoothing steps\titerations\tCPU s\n");
  for (const mesh::Index n : {12U, 19U, 26U, 36U})
    scaling_row("ball of cubes", made_ball(n));
  for (const std::filesystem::path path : files) {
    const mesh::Mesh solid = mesh::read_mesh(path, {}, base::Host());
    scaling_row(path.stem().c_str(), solid);
    scaling_row((path.stem().string() + ", refined").c_str(), refined(solid));
  }
}

// The default field, repaired, and that of the search about single axes.
void repairs(const std::filesystem::path& folder) {
  std::printf("mesh\trepairs\tedges\tvertices\tfragments\tE\tedges\tvertices\tfragments\tE\trounds\tCPU s in all\n");
  const base::Host host = one_thread();
  for_each_mesh(folder, [&](const mesh::Mesh& solid, const Known& row) {
    for (const Repairs mode : {Repairs::places, Repairs::single_axis}) {
      const double begin = cpu_seconds();
      const RepairOutcome r = compute(solid.positions, solid.tetrahedra, {.repairs = mode}, {}, host).repair;
      std::printf("%s\t%s\t%zu\t%zu\t%zu\t%.2f\t%zu\t%zu\t%zu\t%.2f\t%u\t%.1f\n", row.file,
                  mode == Repairs::places ? "places" : "single axis", r.before.edges, r.before.vertices,
                  r.before.fragments, r.energy_before, r.after.edges, r.after.vertices, r.after.fragments,
                  r.energy_after, r.rounds, cpu_seconds() - begin);
    }
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  try {
    if (what == "targets" && argc == 3) {
      targets(argv[2]);
    } else if (what == "fields" && argc > 2) {
      fields({argv + 2, argv + argc});
    } else if (what == "repairs" && argc == 3) {
      repairs(argv[2]);
    } else if (what == "scaling") {
      scaling({argv + 2, argv + argc});
    } else {
      std::fprintf(stderr,
                   "usage: bench-frame-field targets FOLDER | fields FILE... | scaling [FILE...] | repairs FOLDER\n");
      return 2;
    }
  } catch (const base::Error& e) {
    std::fprintf(stderr, "bench-frame-field: %s: %s\n", e.kind(), e.what());
    return 1;
  }
  return 0;
}
