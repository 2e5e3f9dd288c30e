#include "mesh/files/polyhedral_cells.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/cells.h"

namespace orbicube::mesh {
namespace {

constexpr const char* polyhedral_cells_phase = "cutting cells";

struct KindRow {
  std::size_t corners;
  std::size_t base;  // corners of the face that the others are above
  const char* one;
  const char* many;
};
// In the order of Polyhedron.
constexpr std::array<KindRow, 5> kind_rows = {{{5, 4, "pyramid", "pyramids"},
                                               {6, 3, "prism", "prisms"},
                                               {10, 5, "pentagonal prism", "pentagonal prisms"},
                                               {12, 6, "hexagonal prism", "hexagonal prisms"},
                                               {8, 4, "hexahedron", "hexahedra"}}};

const KindRow& row_of(Polyhedron kind) {
  return kind_rows[static_cast<std::size_t>(kind)];
}

// The faces of one cell as triangles that look out of it.
class CellCutter {
 public:
  void set(Polyhedron kind, std::span<const Index> corners) {
    corners_ = corners;
    count_ = 0;
    const std::size_t n = row_of(kind).base;
    std::array<Index, 6> face{};
    for (std::size_t i = 0; i < n; ++i)
      face[i] = corners[(n - i) % n];
    add_face({face.data(), n});
    const bool pyramid = kind == Polyhedron::pyramid;
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t next = (i + 1) % n;
      if (pyramid) {
        add_face(std::array{corners[i], corners[next], corners[n]});
      } else {
        add_face(std::array{corners[i], corners[next], corners[n + next], corners[n + i]});
      }
    }
    if (!pyramid) add_face(corners.subspan(n));
  }

  // The cell's tetrahedra around its lowest vertex.
  void around_lowest(Array<Tetrahedron>& into) const {
    const Index lowest = *std::ranges::min_element(corners_);
    for (std::size_t i = 0; i < count_; ++i) {
      const Triangle& t = triangles_[i];
      if (std::ranges::find(t, lowest) == t.end()) into.push_back({t[0], t[2], t[1], lowest});
    }
  }
  void around(Index center, Array<Tetrahedron>& into) const {
    for (std::size_t i = 0; i < count_; ++i)
      into.push_back({triangles_[i][0], triangles_[i][2], triangles_[i][1], center});
  }

 private:
  void add_face(std::span<const Index> face) {
    const std::size_t n = face.size();
    const auto lowest = static_cast<std::size_t>(std::ranges::min_element(face) - face.begin());
    for (std::size_t i = 1; i + 1 < n; ++i)
      triangles_[count_++] = {face[lowest], face[(lowest + i) % n], face[(lowest + i + 1) % n]};
  }

  std::span<const Index> corners_;
  std::array<Triangle, 20> triangles_;  // of a hexagonal prism, the kind with most
  std::size_t count_ = 0;
};

// Positive tetrahedra, and inverted ones.
std::pair<std::size_t, std::size_t> signs_of(std::span<const Vector3> x, std::span<const Tetrahedron> tetrahedra) {
  std::pair<std::size_t, std::size_t> result;
  for (const Tetrahedron& t : tetrahedra) {
    const int sign = orientation_3d(x[t[0]], x[t[1]], x[t[2]], x[t[3]]);
    result.first += sign > 0;
    result.second += sign < 0;
  }
  return result;
}

void turn(std::span<Tetrahedron> tetrahedra) {
  for (Tetrahedron& t : tetrahedra)
    std::swap(t[1], t[2]);
}

// Replaces a cell's tetrahedra by those around its center, a new vertex, and returns true, if these are positive.
bool cut_around_center(const CellCutter& cutter, std::span<const Index> corners, bool turned, Mesh& mesh,
                       Array<Tetrahedron>& made, const base::Host& host) {
  if (mesh.positions.size() + 1 >= no_index) throw base::Error("unsupported", "more vertices than 32 bits can count");
  Vector3 center = Vector3::Zero();
  for (const Index v : corners)
    center += mesh.positions[v] / static_cast<double>(corners.size());
  mesh.positions.push_back(center);
  Array<Tetrahedron> around(host.memory);
  cutter.around(static_cast<Index>(mesh.positions.size() - 1), around);
  if (turned) turn(around);
  if (signs_of(mesh.positions, around).first < around.size()) {
    mesh.positions.pop_back();
    return false;
  }
  made = std::move(around);
  return true;
}

// "2 pyramids, 1 prism".
std::string text_of_counts(std::span<const std::size_t, kind_rows.size()> cells) {
  std::string text;
  for (std::size_t k = 0; k < kind_rows.size(); ++k) {
    if (cells[k] == 0) continue;
    text.append(text.empty() ? "" : ", ").append(base::counted(cells[k], kind_rows[k].one, kind_rows[k].many));
  }
  return text;
}

}  // namespace

std::size_t corner_count(Polyhedron kind) {
  return row_of(kind).corners;
}

void PolyhedralCells::add(Polyhedron kind, std::span<const Index> corners) {
  kinds_.push_back(kind);
  corners_.insert(corners_.end(), corners.begin(), corners.end());
}

void PolyhedralCells::cut_into_tetrahedra(Mesh& mesh, std::vector<std::string>& notes, const base::Host& host) {
  if (empty()) return;
  for (const Hexahedron& h : mesh.hexahedra)
    add(Polyhedron::hexahedron, h);
  mesh.hexahedra.clear();
  CellCutter cutter;
  Array<Tetrahedron> made(host.memory);
  const auto for_each_cell = [&](const auto& visit) {
    std::size_t begin = 0;
    for (std::size_t i = 0; i < kinds_.size(); ++i) {
      if (i % base::items_between_reports == 0) host.report(polyhedral_cells_phase, i, kinds_.size());
      const std::size_t corners = corner_count(kinds_[i]);
      cutter.set(kinds_[i], {corners_.data() + begin, corners});
      made.clear();
      cutter.around_lowest(made);
      visit(kinds_[i], std::span<const Index>(corners_.data() + begin, corners));
      begin += corners;
    }
  };
  std::array<std::size_t, kind_rows.size()> cells{}, right{}, inverted{};
  for_each_cell([&](Polyhedron kind, std::span<const Index>) {
    const auto k = static_cast<std::size_t>(kind);
    const auto [positive, negative] = signs_of(mesh.positions, made);
    ++cells[k];
    right[k] += positive > negative;
    inverted[k] += negative > positive;
  });
  std::size_t tetrahedra = 0, centers = 0;
  made_.reserve(kinds_.size());
  for_each_cell([&](Polyhedron kind, std::span<const Index> corners) {
    const auto k = static_cast<std::size_t>(kind);
    const bool turned = right[k] == 0 && inverted[k] > 0;
    if (turned) turn(made);
    if (signs_of(mesh.positions, made).first < made.size())
      centers += cut_around_center(cutter, corners, turned, mesh, made, host);
    tetrahedra += made.size();
    made_.push_back(static_cast<std::uint8_t>(made.size()));
    mesh.tetrahedra.insert(mesh.tetrahedra.end(), made.begin(), made.end());
  });
  std::string text = text_of_counts(cells);
  text += (kinds_.size() == 1 ? " was cut into " : " were cut into ") +
          base::counted(tetrahedra, "tetrahedron", "tetrahedra");
  if (centers > 0) text += ", " + std::to_string(centers) + " of the cells around a vertex of their own";
  notes.push_back(text);
}

}  // namespace orbicube::mesh
