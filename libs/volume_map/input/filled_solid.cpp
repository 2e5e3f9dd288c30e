#include "volume_map/input/filled_solid.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "mesh/search/measures.h"

namespace orbicube::volume_map {
namespace {

// Tetrahedra inside no larger than this: about as those beside the surface, but not more than some ten thousand for
// their own sake. Where there are few, maps of the solid find no way.
double max_volume(const CoarseSurface& surface, const base::Host& host) {
  double length = 0;
  for (const mesh::Triangle& t : surface.triangles)
    length += (surface.positions[t[1]] - surface.positions[t[0]]).norm();
  length /= static_cast<double>(surface.triangles.size());
  const double volume = std::abs(mesh::measures(surface.positions, surface.triangles, host).volume);
  return std::max(0.3 * length * length * length, volume / 30000);
}

}  // namespace

FilledSolid filled_solid(const mesh::Mesh& surface, std::size_t triangles, const FillSurface& fill,
                         const base::Host& host) {
  if (!fill) throw base::Error("unsupported", "there is no TetGen to fill a surface; give a mesh of tetrahedra");
  constexpr std::size_t fewest = 500;
  const auto filled = [&](std::size_t target) -> FilledSolid {
    CoarseSurface coarse = coarse_surface(surface.positions, surface.triangles, target, host);
    FilledSolid result(host.memory);
    result.solid = fill(coarse.positions, coarse.triangles, max_volume(coarse, host), host);
    result.surface = std::move(coarse.triangles);
    return result;
  };
  const std::size_t all = surface.triangles.size();
  std::exception_ptr first;
  // With more triangles while there are more, then with fewer: places where the surface just meets itself may go.
  std::size_t target = coarse_target(triangles, all);
  for (bool finer = true;;) {
    try {
      return filled(target);
    } catch (const base::Error& error) {
      if (error.must_end()) throw;
      if (target == all || first == nullptr) first = std::current_exception();
      finer = finer && target < all;
      if (!finer && std::string_view(error.kind()) != "self-intersection") std::rethrow_exception(first);
    }
    target = finer ? std::min(std::max(2 * target, fewest), all) : target / 2;
    if (!finer && target < fewest) std::rethrow_exception(first);
    host.report("decimate", 0, 0);
  }
}

}  // namespace orbicube::volume_map
