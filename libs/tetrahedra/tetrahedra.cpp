#include "tetrahedra/tetrahedra.h"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <string>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "tetrahedra/assemble.h"
#include "tetrahedra/input_check.h"
#include "tetrahedra/scaled_surface.h"
#include "tetrahedra/sizing.h"
#include "tetrahedra/tetgen_call.h"

namespace orbicube::tetrahedra {
namespace {

void require_valid(const Options& o) {
  const auto require = [](bool condition, const char* what) {
    if (!condition) throw base::Error("invalid-argument", what);
  };
  require(o.quality == 0 || (o.quality >= 1 && std::isfinite(o.quality)), "quality must be 0 or at least 1");
  require(o.max_volume >= 0 && std::isfinite(o.max_volume), "max_volume must be 0 or positive");
  require(o.edge_length >= 0 && std::isfinite(o.edge_length), "edge_length must be 0 or positive");
  require(o.size_growth >= 0 && std::isfinite(o.size_growth), "size_growth must be 0 or positive");
  require(o.sizes.size() < mesh::no_index, "there are more sizes than 32 bits can count");
  for (const SizePoint& size : o.sizes) {
    require(size.position.allFinite(), "a place with a size is not finite");
    require(size.length > 0 && std::isfinite(size.length), "sizes must be positive");
  }
}

std::string text(const TetgenOutcome& outcome) {
  using Kind = TetgenOutcome::Kind;
  if (outcome.kind == Kind::out_of_memory) {
    return outcome.number == SIGKILL ? "the process that TetGen ran in was killed, as happens for lack of memory"
                                     : "TetGen ran out of memory";
  }
  if (outcome.kind == Kind::crashed) return "TetGen crashed with signal " + std::to_string(outcome.number);
  switch (outcome.number) {
    case 3:
      return "TetGen could not keep faces apart that come too close to each other";
    case 4:
      return "TetGen met an edge or a gap that is too small for it";
    case 5:
      return "TetGen met two faces that are too close to each other for it";
    default:
      return "TetGen gave up with its error " + std::to_string(outcome.number);
  }
}

double volume_of_regular(double edge) {
  return edge * edge * edge / (6 * std::sqrt(2.0));
}

double enclosed_volume(const ScaledSurface& surface) {
  double sum = 0;
  const std::span<const Vector3> p = surface.positions();
  for (const Triangle& t : surface.triangles())
    sum += p[t[0]].dot(p[t[1]].cross(p[t[2]]));
  return std::abs(sum) / 6;
}

// Of a regular tetrahedron with such edges, or what was requested if that is less; 0 for none; in the coordinates of
// TetGen, where a limit may be so small that it is 0.
double volume_limit(const Options& options, const ScaledSurface& surface) {
  constexpr double none = std::numeric_limits<double>::infinity(), most = 2147483647;  // TetGen's numbers
  double limit = none;
  if (options.edge_length > 0) limit = volume_of_regular(surface.scaled_length(options.edge_length));
  if (options.max_volume > 0) limit = std::min(limit, surface.scaled_volume(options.max_volume));
  if (limit == none) return 0;
  if (!(enclosed_volume(surface) < most * limit))
    throw base::Error("invalid-argument",
                      "max_volume or edge_length is so small that there would be more than 2^31 tetrahedra");
  return limit;
}

// In the coordinates of TetGen. Points so far off that squares of them are infinite have no say.
Sizing scaled_sizing(const Options& options, const ScaledSurface& surface, std::pmr::memory_resource* memory) {
  constexpr double far_off = 1e100;
  base::Array<SizePoint> points(memory);
  points.reserve(options.sizes.size());
  for (const SizePoint& size : options.sizes) {
    const SizePoint point{surface.scaled(size.position), surface.scaled_length(size.length)};
    if (point.position.cwiseAbs().maxCoeff() < far_off) points.push_back(point);
  }
  return {points, options.size_growth, memory};
}

// The most vertices that TetGen may add, negative for any number. Where the surface may be cut, good tetrahedra of a
// plate 1000 times as wide as thick are millions whatever its triangles are. Sizes that the caller gives hold whatever
// their number is.
int addition_limit(const Options& options, std::size_t vertices) {
  if (options.keep_surface || options.max_volume > 0 || options.edge_length > 0 || !options.sizes.empty()) return -1;
  constexpr std::size_t at_least = 50'000, a_vertex = 20, at_most = 1'000'000'000;
  return static_cast<int>(std::min(at_least + a_vertex * vertices, at_most));
}

// TetGen's mesh, with its tolerance lowered for as long as it takes features for flaws.
TetgenMesh run_tetgen(const ScaledSurface& surface, TetgenOptions options, const base::Host& host) {
  TetgenOutcome outcome;
  for (const double tolerance : {1e-8, 1e-12, 1e-16}) {
    options.tolerance = tolerance;
    TetgenMesh made(host.memory);
    outcome = call_tetgen(surface.positions(), surface.triangles(), options, host, made);
    if (outcome.kind == TetgenOutcome::Kind::done) return made;
    host.log(text(outcome) + " (tolerance " + base::counted(std::lround(-std::log10(tolerance)), "digit") + ")");
    if (outcome.kind == TetgenOutcome::Kind::out_of_memory) throw base::Error("out-of-memory", text(outcome));
  }
  throw base::Error("no-valid-result", text(outcome));
}

}  // namespace

Solid fill(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Options& options,
           const base::Host& host) {
  require_valid(options);
  require_fillable(positions, triangles, host);
  const ScaledSurface surface(positions, triangles, host.memory);
  const Sizing sizing = scaled_sizing(options, surface, host.memory);
  TetgenOptions target{.radius_edge_ratio = options.quality,
                       .max_volume = volume_limit(options, surface),
                       .max_volume_at = {},
                       .keep_surface = options.keep_surface};
  if (!sizing.empty())
    target.max_volume_at = [&](const Vector3& center) { return volume_of_regular(sizing.length_at(center)); };
  target.max_added = addition_limit(options, positions.size());
  const TetgenMesh made = run_tetgen(surface, target, host);
  return assemble(positions, triangles, surface, made, options.keep_surface, host);
}

mesh::Mesh filled_mesh(std::span<const Vector3> positions, std::span<const Triangle> triangles, double max_volume,
                       const base::Host& host) {
  Solid filled = fill(positions, triangles, {.max_volume = max_volume}, host);
  mesh::Mesh solid(host.memory);
  solid.positions = std::move(filled.positions);
  solid.tetrahedra = std::move(filled.tetrahedra);
  return solid;
}

}  // namespace orbicube::tetrahedra
