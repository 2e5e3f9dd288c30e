#include "volume_map/solid/solid_polycube.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/error.h"
#include "mesh/search/measures.h"
#include "mesh/topology/place_text.h"
#include "polycube/domain/shape_copies.h"
#include "volume_map/input/solid_pieces.h"
#include "volume_map/solid/cavity_placement.h"
#include "volume_map/solid/gap_widening.h"

namespace orbicube::volume_map {
namespace {

using mesh::Triangle;

// A connected part of the boundary by itself, outward-oriented, with its polycube.
struct PlacedPart {
  explicit PlacedPart(std::pmr::memory_resource* memory)
      : vertices(memory), numbers(memory), positions(memory), triangles(memory), made(memory) {}

  Array<Index> vertices, numbers;  // of the boundary: the part's vertices and triangles
  Array<Vector3> positions;
  Array<Triangle> triangles;
  bool cavity = false;
  polycube::Construction made;
};

PlacedPart part_of(std::span<const Vector3> positions, std::span<const Triangle> triangles, const Pieces& parts,
                   std::size_t which, const base::Host& host) {
  PlacedPart part(host.memory);
  Array<Index> number(positions.size(), no_index, host.memory);
  for (Index i = 0; i < triangles.size(); ++i) {
    if (parts.of[i] != which) continue;
    for (const Index v : triangles[i])
      number[v] = 0;
    part.numbers.push_back(i);
  }
  for (Index v = 0; v < positions.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(part.vertices.size());
    part.vertices.push_back(v);
    part.positions.push_back(positions[v]);
  }
  for (const Index i : part.numbers) {
    const Triangle& t = triangles[i];
    part.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  }
  part.cavity = mesh::measures(part.positions, part.triangles, host).volume < 0;
  if (part.cavity) {
    for (Triangle& t : part.triangles)
      std::swap(t[1], t[2]);
  }
  return part;
}

// The maps of all parts as one, those of cavities put in their positions and reversed to inward orientation again.
// Vertices of the boundary come first.
polycube::SurfaceMap joined(std::span<const Vector3> positions, std::span<const PlacedPart> parts,
                            std::span<const CavityPlacement> placements, const base::Host& host) {
  polycube::SurfaceMap all(host.memory);
  all.positions.assign(positions.begin(), positions.end());
  all.polycube.assign(positions.size(), Vector3::Zero());
  polycube::set_unrefined(all);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PlacedPart& part = parts[i];
    const polycube::SurfaceMap& map = part.made.map;
    Array<Index> number(part.vertices, host.memory);
    for (std::size_t v = part.vertices.size(); v < map.positions.size(); ++v) {
      number.push_back(static_cast<Index>(all.positions.size()));
      all.positions.push_back(map.positions[v]);
      all.polycube.push_back(Vector3::Zero());
      polycube::VertexSource source = map.vertex_sources[v];
      for (Index& corner : source.corner) {
        if (corner != no_index) corner = part.vertices[corner];
      }
      all.vertex_sources.push_back(source);
    }
    for (std::size_t v = 0; v < number.size(); ++v)
      all.polycube[number[v]] = placements[i](map.polycube[v]);
    for (std::size_t t = 0; t < map.triangles.size(); ++t) {
      Triangle triangle = {number[map.triangles[t][0]], number[map.triangles[t][1]], number[map.triangles[t][2]]};
      if (part.cavity) std::swap(triangle[1], triangle[2]);
      all.triangles.push_back(triangle);
      all.triangle_sources.push_back(part.numbers[map.triangle_sources[t]]);
    }
  }
  return all;
}

// About the middle of where it lies.
CavityPlacement smaller(const CavityPlacement& placement, double by, const polycube::SurfaceMap& map) {
  Vector3 low = placement(map.polycube[0]), high = low;
  for (const Vector3& p : map.polycube) {
    low = low.cwiseMin(placement(p));
    high = high.cwiseMax(placement(p));
  }
  CavityPlacement result = placement;
  result.scale *= by;
  result.shift = by * placement.shift + (1 - by) * 0.5 * (low + high);
  return result;
}

// Where a gap is so narrow that there is no polycube, that of the surface with a wider one.
polycube::Construction construct_in_one(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                        const polycube::ConstructionOptions& options, const base::Host& host) {
  constexpr std::array widths = {0.02, 0.04};  // of the diagonal
  std::string reason;
  try {
    return polycube::construct(positions, triangles, options, host).made;
  } catch (const base::Error& error) {
    if (error.status() != base::Status::no_valid_result) throw;
    reason = error.what();
  }
  const mesh::Measures measures = mesh::measures(positions, triangles, host);
  const double diagonal = (measures.high - measures.low).norm();
  polycube::ConstructionOptions grid_based = options;
  grid_based.method = polycube::Method::voxels;
  for (const double width : widths) {
    const Array<Vector3> wider = widened_gaps(positions, triangles, width * diagonal, host);
    if (wider.empty()) continue;
    try {
      polycube::Construction made = polycube::construct(wider, triangles, grid_based, host).made;
      polycube::put_onto(made.map, positions);
      made.certificate = polycube::certify(made.map, host);
      if (!made.certificate.valid()) continue;
      made.distortion = polycube::measure_distortion(made.map, host);
      return made;
    } catch (const base::Error& error) {
      if (error.status() != base::Status::no_valid_result) throw;
    }
  }
  throw base::Error("no-valid-result", reason);
}

}  // namespace

polycube::Construction construct_polycube(std::span<const Vector3> positions, std::span<const Triangle> triangles,
                                          const polycube::ConstructionOptions& options, const base::Host& host) {
  const Pieces connected = surface_parts(triangles, positions.size(), host);
  if (connected.count < 2) return construct_in_one(positions, triangles, options, host);
  Array<PlacedPart> parts(host.memory);
  for (std::size_t i = 0; i < connected.count; ++i)
    parts.push_back(part_of(positions, triangles, connected, i, host));
  // The outer surface first.
  std::stable_partition(parts.begin(), parts.end(), [](const PlacedPart& part) { return !part.cavity; });
  polycube::Construction all(host.memory);
  for (PlacedPart& part : parts) {
    part.made = construct_in_one(part.positions, part.triangles, options, host);
    all.tried += part.made.tried;
    all.valid += part.made.valid;
  }
  Array<CavityPlacement> placements(1, CavityPlacement{}, host.memory);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const CavityPlacement target = place_cavity(parts[0].made.map, parts[i].made.map, host);
    constexpr double step = 0.85;
    constexpr int most = 12;
    placements.push_back(target);
    double by = 1;
    for (int k = 0;; ++k, by *= step) {
      placements[i] = smaller(target, by, parts[i].made.map);
      all.map = joined(positions, std::span(parts).first(i + 1), placements, host);
      all.certificate = polycube::certify(all.map, host);
      if (all.certificate.valid()) break;
      if (k < most) continue;
      const Index first = parts[i].vertices[0];
      throw base::Error("no-valid-result", "the polycube of the cavity at " + mesh::place_text(positions[first]) +
                                               ", does not fit into that of the surface: " + all.certificate.reason);
    }
  }
  all.distortion = polycube::measure_distortion(all.map, host);
  return all;
}

}  // namespace orbicube::volume_map
