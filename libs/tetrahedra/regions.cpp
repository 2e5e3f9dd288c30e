#include "tetrahedra/regions.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/error.h"
#include "base/grouping.h"

namespace orbicube::tetrahedra {
namespace {

constexpr const char* phase = "finding inside and outside";
constexpr std::size_t items_between_reports = 8192;

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

}  // namespace

Regions find_regions(const TetgenMesh& made, const base::Host& host) {
  constexpr std::uint8_t unknown = 2;
  const std::size_t count = made.tetrahedra.size();
  Regions result(host.memory);
  result.solid.assign(count, unknown);
  // Bit k: the face opposite to corner k is in the surface.
  base::Array<std::uint8_t> walls(count, 0, host.memory);
  const FaceSearch search(made, host.memory);
  for (std::size_t t = 0; t < count; ++t) {
    if (t % items_between_reports == 0) host.report(phase, t, 0);
    for (std::size_t k = 0; k < 4; ++k) {
      if (search.find(face_of(made.tetrahedra[t], k))) walls[t] = static_cast<std::uint8_t>(walls[t] | 1U << k);
    }
  }
  // Regions in the order of their depth: those next to the outside first, then those behind their walls.
  base::Array<std::size_t> here(host.memory), behind(host.memory), region(host.memory);
  for (std::size_t t = 0; t < count; ++t) {
    if (std::ranges::min(made.neighbors[t]) < 0) here.push_back(t);
  }
  std::size_t visited = 0;
  for (std::uint8_t solid = 1; !here.empty(); solid = solid == 1 ? 0 : 1) {
    for (const std::size_t seed : here) {
      if (result.solid[seed] != unknown) continue;
      ++(solid == 1 ? result.parts : result.cavities);
      result.solid[seed] = solid;
      region.assign(1, seed);
      while (!region.empty()) {
        const std::size_t t = region.back();
        region.pop_back();
        if (++visited % items_between_reports == 0) host.report(phase, visited, count);
        for (std::size_t k = 0; k < 4; ++k) {
          const bool wall = (walls[t] >> k & 1U) != 0;
          if (made.neighbors[t][k] < 0) {
            if (!wall || solid == 0) throw base::Error("no-valid-result", "TetGen's mesh is open");
            continue;
          }
          const auto neighbor = static_cast<std::size_t>(made.neighbors[t][k]);
          if (result.solid[neighbor] != unknown) {
            if ((result.solid[neighbor] == solid) == wall)
              throw base::Error("no-valid-result", "the surface in TetGen's mesh is not closed");
          } else if (wall) {
            behind.push_back(neighbor);
          } else {
            result.solid[neighbor] = solid;
            region.push_back(neighbor);
          }
        }
      }
    }
    std::swap(here, behind);
    behind.clear();
  }
  if (visited != count) throw base::Error("no-valid-result", "TetGen's mesh has parts that nothing leads to");
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
