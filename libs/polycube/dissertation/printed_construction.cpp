#include "polycube/dissertation/printed_construction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/topology/topology.h"
#include "polycube/dissertation/corner_mapping.h"
#include "polycube/dissertation/domain_shape.h"
#include "polycube/dissertation/octree.h"
#include "polycube/layout/given_polycube.h"

namespace orbicube::polycube::dissertation {
namespace {

constexpr int max_depth = 5;
// How much of a smallest box has to be inside, which the dissertation leaves open.
constexpr std::array inside_fractions = {0.5, 0.4, 0.6, 0.3, 0.2, 0.1, 0.0};
constexpr std::size_t max_octrees = 10;  // that are mapped
// Algorithm 3 ends where no plane of the polycube moves by more than this part of its size.
constexpr double min_plane_change = 1e-3;
constexpr double min_gain = 1e-4;      // of the energy in a round, relative
constexpr int max_invalid_rounds = 3;  // that a map which folds over is optimized, in which it may unfold

struct Candidate {
  Layout layout;
  int depth;
};

// Number by number: the arrays may be of different memory.
void exchange(std::array<Array<double>, 3>& a, std::array<Array<double>, 3>& b) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::swap_ranges(a[axis].begin(), a[axis].end(), b[axis].begin());
}

double area_of(const Layout& layout) {
  double sum = 0;
  for (const LayoutRectangle& r : layout.rectangles) {
    const Vector3 size = layout.position(r.high) - layout.position(r.low);
    const int axis = axis_of(r.label);
    sum += size[(axis + 1) % 3] * size[(axis + 2) % 3];
  }
  return sum;
}

// Algorithm 3 on one polycube. Once a map has a certificate, only such replace it.
class Algorithm3 {
 public:
  Algorithm3(Layout& layout, PrintedMapper& mapper, const PrintedOptions& options, const base::Host& host)
      : printed(host.memory), layout_(layout), mapper_(mapper), options_(options), host_(host), points_(host.memory) {}

  // The result. Throws Error "no-valid-result".
  void run(Projection projection) {
    const Array<Index> points = project_corners(layout_, mapper_.surface(), projection, host_);
    if (!attempt(points)) throw base::Error("no-valid-result", reason_);
    printed.report.before = initial_distortion();
    optimize();
    if (!valid_) throw base::Error("no-valid-result", reason_);
  }

  Printed printed;

 private:
  // Zeros where the initial map is not valid.
  Distortion initial_distortion() const { return valid_ ? measure_distortion(printed.made.map, host_) : Distortion(); }

  void optimize() {
    PrintedReport& report = printed.report;
    while (report.rounds < options_.max_rounds && !report.converged && (valid_ || report.rounds < max_invalid_rounds)) {
      ++report.rounds;
      const double before = energy_;
      const double change = improve_domain();
      improve_corners();
      report.converged = change < min_plane_change && energy_ > (1 - min_gain) * before;
    }
  }

  // Maps with these corner points, and takes the map where it has less energy and is valid, or the one before is not.
  bool attempt(std::span<const Index> points) {
    const Drawn drawn = mapper_.draw(layout_, points);
    if (!drawn.valid()) {
      reason_ = drawn.first;
      if (drawn.defects > 1) reason_ += ", and at " + base::counted(drawn.defects - 1, "other place");
      return false;
    }
    PatchMap map = mapper_.map(layout_, drawn);
    const double energy = map.total(options_.area_weight) / area_of(layout_);
    if (!(energy < energy_)) return false;
    if (!certified(drawn) && valid_) return false;
    points_.assign(points.begin(), points.end());
    patches_ = std::move(map.energy);
    energy_ = energy;
    printed.report.energies.push_back(energy);
    return true;
  }

  bool certified(const Drawn& drawn) {
    try {
      Certificate certificate(host_.memory);
      FinishedMap finished = mapper_.finish(layout_, drawn, certificate);
      printed.made.map = std::move(finished.map);
      printed.made.certificate = std::move(certificate);
      valid_ = true;
      return true;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      reason_ = error.what();
      host_.log("a map is not valid: " + reason_);
      return false;
    }
  }

  // Returns how far a plane moved, relative to the polycube's size.
  double improve_domain() {
    DomainShape shape = optimize_domain_shape(layout_, patches_, options_.area_weight, host_);
    printed.report.domain_evaluations += shape.evaluations;
    double change = 0, size = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t i = 1; i + 1 < shape.planes[a].size(); ++i)
        change = std::max(change, std::abs(shape.planes[a][i] - layout_.planes[a][i]));
      size = std::max(size, shape.planes[a].back() - shape.planes[a].front());
    }
    exchange(layout_.planes, shape.planes);
    const Array<Index> points(points_.begin(), points_.end(), host_.memory);
    if (attempt(points)) return change / size;
    exchange(layout_.planes, shape.planes);
    return 0;
  }

  void improve_corners() {
    const CornerMapping found =
        optimize_corner_mapping(layout_, points_, mapper_, {.area_weight = options_.area_weight}, host_);
    printed.report.corner_evaluations += found.evaluations;
    printed.report.failed_evaluations += found.failed;
    if (found.energy < found.energy_before) attempt(found.corner_points);
  }

  Layout& layout_;
  PrintedMapper& mapper_;
  const PrintedOptions& options_;
  const base::Host& host_;
  Array<Index> points_;
  Array<PatchEnergy> patches_{host_.memory};
  double energy_ = std::numeric_limits<double>::infinity();
  bool valid_ = false;
  std::string reason_;  // what is wrong with the last map that is not valid
};

class PrintedConstruction {
 public:
  PrintedConstruction(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                      const PrintedOptions& options, const base::Host& host)
      : options_(options), host_(host), surface_(positions, triangles, host), printed_(host.memory) {
    const auto topology = mesh::topology(positions, triangles, host);
    mesh::require_closed_manifold(topology);
    if (!topology.genus) throw base::Error("not-connected", "a polycube map needs one closed, oriented surface");
    find_octrees(Occupancy(positions, triangles, occupancy_resolution, host), *topology.genus);
  }

  Printed run() {
    if (candidates_.empty())
      throw base::Error("no-valid-result",
                        "no octree has the genus of the surface within " + base::counted(max_points(), "corner point"));
    PrintedMapper mapper(surface_, host_);
    for (Candidate& candidate : candidates_) {
      for (const Projection projection : {Projection::nearest, Projection::along_normal}) {
        if (attempt(candidate, projection, mapper)) return std::move(printed_);
      }
    }
    throw base::Error("no-valid-result", reasons_);
  }

 private:
  static constexpr int occupancy_resolution = 128;

  std::size_t max_points() const { return options_.corner_points > 0 ? options_.corner_points : default_corner_points; }

  bool attempt(const Candidate& candidate, Projection projection, PrintedMapper& mapper) {
    const std::string name = "octree of depth " + std::to_string(candidate.depth) + ", " +
                             base::counted(candidate.layout.nodes.size(), "corner point") +
                             (projection == Projection::nearest ? ": " : " projected along normals: ");
    ++tried_;
    try {
      Layout layout(host_.memory);
      layout = candidate.layout;
      Algorithm3 algorithm(layout, mapper, options_, host_);
      algorithm.run(projection);
      printed_ = std::move(algorithm.printed);
      finish(candidate, mapper);
      return true;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
      reasons_ += (reasons_.empty() ? "" : "; ") + name + error.what();
      host_.log(name + error.what());
      return false;
    }
  }

  // Those with the topology of the surface within the number of corner points, the most corner points first.
  void find_octrees(const Occupancy& occupancy, std::int64_t genus) {
    for (const double fraction : inside_fractions) {
      for (int depth = 0; depth <= std::min(max_depth, max_octree_depth(occupancy)); ++depth) {
        const VoxelSolid solid = octree_solid(occupancy, {.depth = depth, .inside = fraction}, host_);
        const VoxelTopology topology = solid.topology(host_);
        if (topology.bad_vertices > 0 || topology.genus != genus || topology.inside_components != 1 ||
            topology.outside_components != 1)
          continue;
        Layout layout = make_layout(solid, host_);
        if (layout.nodes.size() <= max_points() && is_new(layout)) candidates_.push_back({std::move(layout), depth});
      }
    }
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.layout.nodes.size() > b.layout.nodes.size();
    });
    if (candidates_.size() > max_octrees) {
      // The one of fewest corner points is the likeliest to have a map.
      std::swap(candidates_[max_octrees - 1], candidates_.back());
      candidates_.erase(candidates_.begin() + max_octrees, candidates_.end());
    }
  }

  bool is_new(const Layout& layout) const {
    return std::none_of(candidates_.begin(), candidates_.end(), [&](const Candidate& other) {
      if (other.layout.nodes.size() != layout.nodes.size()) return false;
      for (Index n = 0; n < layout.nodes.size(); ++n)
        if (layout.node_position(n) != other.layout.node_position(n)) return false;
      return true;
    });
  }

  void finish(const Candidate& candidate, const PrintedMapper& mapper) {
    printed_.made.valid = 1;
    printed_.made.tried = tried_;
    printed_.made.distortion = measure_distortion(printed_.made.map, host_);
    PrintedReport& report = printed_.report;
    report.corner_points = candidate.layout.nodes.size();
    report.rectangles = candidate.layout.rectangles.size();
    report.octree_depth = candidate.depth;
    report.factorizations = mapper.counts().factorizations;
    report.rows_removed = mapper.counts().rows_removed;
    report.rows_added = mapper.counts().rows_added;
  }

  const PrintedOptions& options_;
  const base::Host& host_;
  EditableSurface surface_;
  std::vector<Candidate> candidates_;
  Printed printed_;
  std::size_t tried_ = 0;
  std::string reasons_;
};

}  // namespace

Printed construct_as_printed(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                             const PrintedOptions& options, const base::Host& host) {
  return PrintedConstruction(positions, triangles, options, host).run();
}

}  // namespace orbicube::polycube::dissertation
