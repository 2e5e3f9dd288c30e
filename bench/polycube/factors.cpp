#include "factors.h"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "bench/measuring.h"
#include "linear/direct/direct_factor.h"
#include "map_files.h"
#include "polycube/surface/editable_surface.h"
#ifdef ORBICUBE_WITH_CHOLMOD
#include "linear/direct/cholmod_factor.h"
#endif

namespace orbicube::bench {
namespace {

using namespace orbicube::polycube;
using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, int>;

// The inside of a face: vertices that are on no edge of the polycube, with those beside each of its edges.
struct Face {
  std::vector<Index> vertices;
  std::vector<std::vector<int>> beside;  // of each edge: rows that become known when the edge moves onto them
};

class Faces {
 public:
  Faces(const SurfaceMap& map, const base::Host& host)
      : map_(map), surface_(map.positions, map.triangles, host), row_(map.positions.size(), -1) {}

  std::vector<Face> find() {
    std::vector<Face> faces;
    std::vector<Index> of(map_.positions.size(), no_index);
    for (Index v = 0; v < of.size(); ++v) {
      if (surface_.outgoing(v) == no_index) continue;
      const Index chart = map_.patches[surface_.outgoing(v) / 3];
      bool inside = true;
      surface_.for_each_outgoing(v, [&](Index h) { inside = inside && map_.patches[h / 3] == chart; });
      if (!inside) continue;
      of[v] = chart;
      if (chart >= faces.size()) faces.resize(chart + 1);
      row_[v] = static_cast<int>(faces[chart].vertices.size());
      faces[chart].vertices.push_back(v);
    }
    // Edges by the patch beyond them.
    for (Index chart = 0; chart < faces.size(); ++chart) {
      std::vector<std::pair<Index, int>> found;
      for (const Index v : faces[chart].vertices) {
        surface_.for_each_outgoing(v, [&](Index h) {
          const Index end = surface_.end(h);
          if (of[end] != no_index) return;
          surface_.for_each_outgoing(end, [&](Index x) {
            if (map_.patches[x / 3] != chart) found.emplace_back(map_.patches[x / 3], row_[v]);
          });
        });
      }
      std::sort(found.begin(), found.end());
      found.erase(std::unique(found.begin(), found.end()), found.end());
      Index last = no_index;
      for (const auto& [other, row] : found) {
        if (other != last) faces[chart].beside.emplace_back();
        faces[chart].beside.back().push_back(row);
        last = other;
      }
    }
    return faces;
  }

  // Of the harmonic map with equal weights; rows of what is known are those of the identity.
  Matrix matrix_of(const Face& face, const std::vector<int>& known) const {
    std::vector<bool> is_known(face.vertices.size(), false);
    for (const int row : known)
      is_known[static_cast<std::size_t>(row)] = true;
    std::vector<Eigen::Triplet<double>> triplets;
    for (const Index v : face.vertices) {
      const auto i = static_cast<std::size_t>(row_[v]);
      double valence = 0;
      surface_.for_each_outgoing(v, [&](Index h) {
        ++valence;
        const Index end = surface_.end(h);
        const int j = row_[end];
        const bool same = j >= 0 && map_.patches[surface_.outgoing(end) / 3] == map_.patches[surface_.outgoing(v) / 3];
        if (same && j < row_[v] && !is_known[i] && !is_known[static_cast<std::size_t>(j)])
          triplets.emplace_back(row_[v], j, -1.0);
      });
      triplets.emplace_back(row_[v], row_[v], is_known[i] ? 1.0 : valence);
    }
    const auto size = static_cast<Eigen::Index>(face.vertices.size());
    Matrix result(size, size);
    result.setFromTriplets(triplets.begin(), triplets.end());
    // Each entry below the diagonal, in its column.
    return result;
  }

 private:
  const SurfaceMap& map_;
  EditableSurface surface_;
  std::vector<int> row_;
};

struct Engine {
  linear::DirectMethod method;
  double fresh = 0, updated = 0;  // seconds
};

void row(const std::string& name, const SurfaceMap& map, const base::Host& host) {
  Faces finder(map, host);
  const std::vector<Face> faces = finder.find();
  double removed = 0, farthest = 0, start = 0;
  std::vector<Engine> engines = {{linear::DirectMethod::eigen}};
  if (linear::has_cholmod()) engines.push_back({linear::DirectMethod::cholmod_simplicial});
  std::size_t moves = 0, most = 0;
  for (const Face& face : faces) {
    most = std::max(most, face.vertices.size());
    const Matrix before = finder.matrix_of(face, {});
    for (const std::vector<int>& known : face.beside) {
      if (known.size() == face.vertices.size()) continue;
      const Matrix after = finder.matrix_of(face, known);
      const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(after.rows(), -1, 1);
      const auto solution_of = [&](const linear::DirectFactor& factor) {
        Eigen::VectorXd solution(right.size());
        const auto size = static_cast<std::size_t>(right.size());
        factor.solve({right.data(), size}, 1, {solution.data(), size});
        return solution;
      };
      ++moves;
      removed += static_cast<double>(known.size());
      Eigen::VectorXd first;
      for (Engine& engine : engines) {
        start = cpu_seconds();
        const auto factor = linear::make_direct_factor(engine.method);
        factor->analyze(after);
        factor->factorize(after);
        const Eigen::VectorXd fresh = solution_of(*factor);
        engine.fresh += cpu_seconds() - start;
        const auto kept = linear::make_direct_factor(engine.method);
        kept->analyze(before);
        kept->factorize(before);
        start = cpu_seconds();
        for (const int r : known)
          kept->remove_row(static_cast<Index>(r));
        const Eigen::VectorXd updated = solution_of(*kept);
        engine.updated += cpu_seconds() - start;
        if (first.size() == 0) first = fresh;
        farthest = std::max({farthest, (fresh - first).cwiseAbs().maxCoeff(), (updated - first).cwiseAbs().maxCoeff()});
      }
    }
  }
  const double each = moves > 0 ? 1e3 / static_cast<double>(moves) : 0;
  std::printf("%-16s %6zu %7zu %6zu %7.1f", name.c_str(), faces.size(), most, moves,
              moves > 0 ? removed / static_cast<double>(moves) : 0);
  for (const Engine& engine : engines)
    std::printf(" %9.3f %9.3f", each * engine.fresh, each * engine.updated);
  std::printf("  %.1e\n", farthest);
  std::fflush(stdout);
}

}  // namespace

void measure_factors(std::span<const std::string> files, std::size_t corners, const base::Host& host) {
#ifdef ORBICUBE_WITH_CHOLMOD
  linear::provide_cholmod(&linear::make_cholmod_factor);
#endif
  std::printf(
      "vertices: inside the largest face; known: vertices that an edge moves onto; ms of the processor a move\n");
  std::printf("%-16s %6s %7s %6s %7s %9s %9s%s  differ by\n", "shape", "faces", "vertices", "moves", "known", "Eigen",
              "updated", linear::has_cholmod() ? "   CHOLMOD   updated" : "");
  for (const std::string& file : files) {
    try {
      row(stem_of(file),
          file.ends_with(map_ending) ? read_map(file, host) : make_map(file, Method::automatic, corners, host), host);
    } catch (const base::Error& error) {
      std::printf("%-16s %s: %s\n", stem_of(file).c_str(), error.kind(), error.what());
    }
  }
}

}  // namespace orbicube::bench
