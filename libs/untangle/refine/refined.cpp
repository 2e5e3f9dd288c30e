#include "untangle/refine/refined.h"

#include <algorithm>
#include <optional>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "untangle/refine/star_disk.h"

namespace orbicube::untangle {
namespace {

// The first round splits what joins fixed vertices, others what stays inverted, which can be a part that no splits
// help: an end of the rounds, and of the growth of the mesh, and rounds without fewer inverted elements.
constexpr std::size_t max_rounds = 9, max_growth = 8, patience = 2;
// Fixed vertices on one line, or in one plane, are so but for rounding, by which elements may be positive that are
// flat.
constexpr double min_determinant = 1e-9;

UntangledTriangles solve(const TriangleProblem& mesh, const UntangleOptions& options, const base::Host& host) {
  return untangle_triangles(mesh, options, host);
}
Untangled solve(const UntangleProblem& mesh, const UntangleOptions& options, const base::Host& host) {
  return untangle_tetrahedra(mesh, options, host);
}

// The same of a split mesh; nothing where parts of nearly flat target shapes are flat, by rounding.
template <class Problem>
auto solve_split(const Problem& mesh, const UntangleOptions& options, const base::Host& host) {
  std::optional<decltype(solve(mesh, options, host))> solved;
  try {
    solved.emplace(solve(mesh, options, host));
  } catch (const base::Error& error) {
    if (error.status() != base::Status::degenerate) throw;
  }
  return solved;
}

std::span<const Triangle> elements_of(const TriangleProblem& mesh) {
  return mesh.triangles;
}
std::span<const Tetrahedron> elements_of(const UntangleProblem& mesh) {
  return mesh.tetrahedra;
}

bool is_positive(const Triangle& t, std::span<const Vector2d> p) {
  return mesh::orientation_2d(p[t[0]], p[t[1]], p[t[2]]) > 0;
}
bool is_positive(const Tetrahedron& t, std::span<const Vector3> p) {
  return mesh::orientation_3d(p[t[0]], p[t[1]], p[t[2]], p[t[3]]) > 0;
}

// An entry a vertex, 1 where all coordinates are fixed.
Array<std::uint8_t> fixed_vertices(std::span<const std::uint8_t> fixed, std::size_t vertices, std::size_t axes,
                                   std::pmr::memory_resource* memory) {
  // Of another length they are refused by what follows.
  if (fixed.size() != axes * vertices) return Array<std::uint8_t>(vertices, 0, memory);
  Array<std::uint8_t> result(vertices, 1, memory);
  for (std::size_t i = 0; i < fixed.size(); ++i)
    result[i / axes] = result[i / axes] != 0 && fixed[i] != 0;
  return result;
}

// The problem of a split mesh, with new vertices where they lie in the mesh before.
template <std::size_t corners, class Problem, class Vector>
struct SplitProblem {
  static constexpr std::size_t axes = corners - 1;

  SplitProblem(const Problem& whole, const SplitMesh<corners>& split, std::span<const Vector> start,
               std::pmr::memory_resource* memory)
      : start_(memory), rest_(memory), fixed_(memory), ties_(memory), elements_(split.elements()) {
    for (const Origin<corners>& o : split.origins()) {
      start_.push_back(o.mean(start));
      if (!whole.rest.empty()) rest_.push_back(o.mean(whole.rest));
    }
    // A mean of one vertex has its bits, but for the sign of zero.
    std::copy(start.begin(), start.end(), start_.begin());
    if (!whole.fixed.empty()) {
      fixed_.assign(whole.fixed.begin(), whole.fixed.end());
      fixed_.resize(axes * start_.size(), 0);
    }
    if (!whole.ties.empty()) {
      ties_.assign(whole.ties.begin(), whole.ties.end());
      ties_.resize(axes * start_.size(), no_index);
    }
  }
  Problem view() const { return {elements_, start_, rest_, fixed_, ties_}; }

 private:
  Array<Vector> start_;
  Array<Vector3> rest_;
  Array<std::uint8_t> fixed_;
  Array<Index> ties_;
  std::span<const std::array<Index, corners>> elements_;
};

template <std::size_t corners, class Vector, class Problem>
class Refinement {
 public:
  using Result = Refined<corners, Vector>;

  Refinement(const Problem& problem, const UntangleOptions& options, const base::Host& host)
      : problem_(problem), options_(options), host_(host), result_(host.memory) {}

  Result run() {
    require_valid(options_);
    const Array<std::uint8_t> fixed = fixed_vertices(problem_.fixed, problem_.start.size(), corners - 1, host_.memory);
    UntangleOptions first = options_;
    if (any_hopeless(fixed)) first.steps = first.polish_steps = 0;
    const auto plain = solve(problem_, first, host_);
    SplitMesh<corners> split(elements_of(problem_), problem_.start.size(), host_.memory);
    take(plain, split);
    result_.inverted_before = plain.inverted_before;
    const bool flat = plain.min_determinant <= min_determinant && plain.inverted_before > 0;
    if (plain.inverted == 0 && !flat) return std::move(result_);
    const Array<Vector> start(plain.positions, host_.memory);
    split_marked(split, fixed, host_);
    std::size_t stalled = 0;
    for (std::size_t round = 1;; ++round) {
      const SplitProblem<corners, Problem, Vector> next(problem_, split, start, host_.memory);
      const auto solved = solve_split(next.view(), options_, host_);
      stalled = solved && solved->inverted < result_.inverted ? 0 : stalled + 1;
      if (solved) take_if_better(*solved, split, round);
      if (result_.inverted == 0 || (round == 1 && construct())) break;
      const bool large = split.elements().size() > max_growth * elements_of(problem_).size();
      if (!solved || round == max_rounds || large || stalled > patience) break;
      split_inverted(split, solved->positions);
    }
    return std::move(result_);
  }

 private:
  // Whether an element that cannot change is not positive, or not finite, which is refused by what follows.
  bool any_hopeless(std::span<const std::uint8_t> fixed) const {
    for (const auto& e : elements_of(problem_)) {
      if (std::any_of(e.begin(), e.end(), [&](Index v) { return v >= fixed.size() || fixed[v] == 0; })) continue;
      const bool finite = std::all_of(e.begin(), e.end(), [&](Index v) { return problem_.start[v].allFinite(); });
      if (!finite || !is_positive(e, problem_.start)) return true;
    }
    return false;
  }

  bool is_better(const UntanglingFigures& next) const {
    if (next.inverted != result_.inverted) return next.inverted < result_.inverted;
    return next.inverted == 0 && next.min_determinant > result_.min_determinant;
  }

  template <class Figures>
  void take_if_better(const Figures& next, const SplitMesh<corners>& split, std::size_t round) {
    if (is_better(next)) {
      take(next, split);
      result_.rounds = round;
    } else {
      result_.steps += next.steps;
      result_.polish_steps += next.polish_steps;
    }
  }

  template <class Figures>
  void take(const Figures& of, const SplitMesh<corners>& split) {
    const std::size_t before = result_.inverted_before, steps = result_.steps, polish_steps = result_.polish_steps;
    static_cast<UntanglingFigures&>(result_) = of;
    result_.inverted_before = before;
    result_.steps += steps;
    result_.polish_steps += polish_steps;
    result_.elements.assign(split.elements().begin(), split.elements().end());
    result_.parents.assign(split.parents().begin(), split.parents().end());
    result_.origins.assign(split.origins().begin(), split.origins().end());
    result_.positions.assign(of.positions.begin(), of.positions.end());
  }

  // Untangles by construction where that is known to work.
  bool construct() {
    if constexpr (corners == 3) {
      StarDisk disk(host_.memory);
      if (!map_star_disk(problem_, disk, host_)) return false;
      SplitProblem<corners, Problem, Vector> placed(problem_, disk.mesh, problem_.start, host_.memory);
      Problem view = placed.view();
      view.start = disk.positions;
      const auto solved = solve_split(view, options_, host_);
      if (!solved || solved->inverted > 0) return false;
      take(*solved, disk.mesh);
      result_.rounds = 1;
      result_.constructed = true;
      return true;
    }
    return false;
  }

  void split_inverted(SplitMesh<corners>& split, std::span<const Vector> positions) {
    Array<Index> inverted(host_.memory);
    for (Index i = 0; i < split.elements().size(); ++i) {
      if (!is_positive(split.elements()[i], positions)) inverted.push_back(i);
    }
    split_edges_of<corners>(split, inverted, host_);
  }

  const Problem& problem_;
  const UntangleOptions& options_;
  const base::Host& host_;
  Result result_;
};

}  // namespace

RefinedTriangles untangle_refined(const TriangleProblem& mesh, const UntangleOptions& options, const base::Host& host) {
  return Refinement<3, Vector2d, TriangleProblem>(mesh, options, host).run();
}

RefinedTetrahedra untangle_refined(const UntangleProblem& mesh, const UntangleOptions& options,
                                   const base::Host& host) {
  return Refinement<4, Vector3, UntangleProblem>(mesh, options, host).run();
}

}  // namespace orbicube::untangle
