#include "tetrahedra/regions.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::tetrahedra {
namespace {

constexpr const char* regions_phase = "finding inside and outside";

Triple sorted(Triple face) {
  std::sort(face.begin(), face.end());
  return face;
}

// Finds the faces of the surface by their vertices: they are listed by their lowest vertex, which few others have.
class FaceSearch {
 public:
  FaceSearch(const TetgenMesh& made, std::pmr::memory_resource* memory) : faces_(memory) {
    faces_.assign(made.positions.size(), [&](const auto& visit) {
      for (std::size_t f = 0; f < made.faces.size(); ++f) {
        const Triple face = sorted(made.faces[f]);
        visit(face[0], std::pair(face, f));
      }
    });
  }

  // Nothing when the face is not in the surface.
  std::optional<std::size_t> find(const Triple& face) const {
    const Triple key = sorted(face);
    for (const auto& [corners, number] : faces_[static_cast<std::size_t>(key[0])]) {
      if (corners == key) return number;
    }
    return {};
  }

 private:
  base::Groups<std::pair<Triple, std::size_t>> faces_;
};

// The face opposite to corner k.
Triple face_of(const Quadruple& t, std::size_t k) {
  return {t[(k + 1) % 4], t[(k + 2) % 4], t[(k + 3) % 4]};
}

constexpr std::uint8_t unknown = 2;

// For each tetrahedron, bit k: the face opposite to corner k is in the surface.
base::Array<std::uint8_t> walls_of(const TetgenMesh& made, const FaceSearch& search, const base::Host& host) {
  base::Array<std::uint8_t> walls(made.tetrahedra.size(), 0, host.memory);
  for (std::size_t t = 0; t < walls.size(); ++t) {
    if (t % base::items_between_reports == 0) host.report(regions_phase, t, 0);
    for (std::size_t k = 0; k < 4; ++k) {
      if (search.find(face_of(made.tetrahedra[t], k))) walls[t] = static_cast<std::uint8_t>(walls[t] | 1U << k);
    }
  }
  return walls;
}

// Sets which tetrahedra are solid, region by region.
class RegionFill {
 public:
  RegionFill(const TetgenMesh& made, std::span<const std::uint8_t> walls, Regions& result, const base::Host& host)
      : made_(made), walls_(walls), result_(result), host_(host), behind_(host.memory), region_(host.memory) {}

  // Regions in the order of their depth: those next to the outside first, then those behind their walls.
  void fill_all() {
    base::Array<std::size_t> here(host_.memory);
    for (std::size_t t = 0; t < walls_.size(); ++t) {
      if (std::ranges::min(made_.neighbors[t]) < 0) here.push_back(t);
    }
    for (std::uint8_t solid = 1; !here.empty(); solid = solid == 1 ? 0 : 1) {
      for (const std::size_t seed : here) {
        if (result_.solid[seed] == unknown) fill(seed, solid);
      }
      std::swap(here, behind_);
      behind_.clear();
    }
    if (visited_ != walls_.size())
      throw base::Error("no-valid-result", "TetGen's mesh has parts that nothing leads to");
  }

 private:
  // The region of one tetrahedron, up to its walls.
  void fill(std::size_t seed, std::uint8_t solid) {
    ++(solid == 1 ? result_.parts : result_.cavities);
    result_.solid[seed] = solid;
    region_.assign(1, seed);
    while (!region_.empty()) {
      const std::size_t t = region_.back();
      region_.pop_back();
      if (++visited_ % base::items_between_reports == 0) host_.report(regions_phase, visited_, walls_.size());
      for (std::size_t k = 0; k < 4; ++k)
        cross(t, k, solid);
    }
  }

  // Goes on through the face opposite to corner k.
  void cross(std::size_t t, std::size_t k, std::uint8_t solid) {
    const bool wall = (walls_[t] >> k & 1U) != 0;
    if (made_.neighbors[t][k] < 0) {
      if (!wall || solid == 0) throw base::Error("no-valid-result", "TetGen's mesh is open");
      return;
    }
    const auto neighbor = static_cast<std::size_t>(made_.neighbors[t][k]);
    if (result_.solid[neighbor] != unknown) {
      if ((result_.solid[neighbor] == solid) == wall)
        throw base::Error("no-valid-result", "the surface in TetGen's mesh is not closed");
    } else if (wall) {
      behind_.push_back(neighbor);
    } else {
      result_.solid[neighbor] = solid;
      region_.push_back(neighbor);
    }
  }

  const TetgenMesh& made_;
  std::span<const std::uint8_t> walls_;
  Regions& result_;
  const base::Host& host_;
  base::Array<std::size_t> behind_, region_;  // tetrahedra behind walls, and of the region that have not been left
  std::size_t visited_ = 0;
};

}  // namespace

Regions find_regions(const TetgenMesh& made, const base::Host& host) {
  const std::size_t count = made.tetrahedra.size();
  Regions result(host.memory);
  result.solid.assign(count, unknown);
  const FaceSearch search(made, host.memory);
  const base::Array<std::uint8_t> walls = walls_of(made, search, host);
  RegionFill(made, walls, result, host).fill_all();
  result.inside.assign(made.faces.size(), -1);
  for (std::size_t t = 0; t < count; ++t) {
    if (walls[t] == 0 || result.solid[t] == 0) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      if (const auto face = search.find(face_of(made.tetrahedra[t], k)))
        result.inside[*face] = static_cast<std::int32_t>(t);
    }
  }
  if (std::ranges::find(result.inside, -1) != result.inside.end())
    throw base::Error("no-valid-result", "a face of the surface has no tetrahedron inside it");
  return result;
}

}  // namespace orbicube::tetrahedra
