#include "scenes/view_page.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>

#include "base/error.h"
#include "report_page/base64_text.h"
#include "report_page/filled_page.h"
#include "report_page/template.h"

namespace orbicube::cli {
namespace {

using Json = nlohmann::ordered_json;
using mesh::Index;
using mesh::Vector3;

constexpr double steps = 16777215;  // of a position along the longest side of the box

// Bytes of a number of a vertex.
unsigned width_of(std::size_t vertices) {
  unsigned width = 1;
  for (; width < 4 && vertices > std::size_t{1} << 8 * width; ++width) {
  }
  return width;
}

void append(std::uint32_t value, unsigned width, std::vector<std::uint8_t>& bytes) {
  for (unsigned k = 0; k < width; ++k)
    bytes.push_back(static_cast<std::uint8_t>(value >> 8 * k));
}

template <class Lists>
std::string numbers(const Lists& lists, unsigned width) {
  std::vector<std::uint8_t> bytes;
  for (const auto& list : lists) {
    for (const Index v : list)
      append(v, width, bytes);
  }
  return base64(bytes);
}

// The box of the vertices in use; others may lie anywhere.
struct Box {
  Vector3 low, high;
};

template <class Cells>
void add(const Cells& cells, std::span<const Vector3> positions, Box& box) {
  for (const auto& cell : cells) {
    for (const Index v : cell) {
      box.low = box.low.cwiseMin(positions[v]);
      box.high = box.high.cwiseMax(positions[v]);
    }
  }
}

Json positions_json(std::span<const Vector3> positions, const mesh::Mesh& mesh) {
  constexpr double most = std::numeric_limits<double>::max();
  Box box{Vector3::Constant(most), Vector3::Constant(-most)};
  add(mesh.triangles, positions, box);
  add(mesh.tetrahedra, positions, box);
  add(mesh.hexahedra, positions, box);
  // Halves, since the sides of a box may be longer than the largest double.
  const double half = (0.5 * box.high - 0.5 * box.low).maxCoeff(), step = half > 0 ? half / steps * 2 : 1;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(9 * positions.size());
  for (const Vector3& p : positions) {
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double number = std::round(2 * ((0.5 * p[k] - 0.5 * box.low[k]) / step));
      append(number > 0 ? static_cast<std::uint32_t>(std::min(number, steps)) : 0, 3, bytes);
    }
  }
  return {{"low", {box.low.x(), box.low.y(), box.low.z()}}, {"step", step}, {"positions", base64(bytes)}};
}

Json json_of(const ViewItem& item) {
  const mesh::Mesh& mesh = *item.mesh;
  const bool cells = !mesh.tetrahedra.empty() || !mesh.hexahedra.empty();
  if (!cells && mesh.triangles.empty()) throw base::Error("empty-mesh", "there are no triangles or cells to show");
  const unsigned width = width_of(mesh.positions.size());
  Json result = {{"name", item.name}, {"width", width}};
  result.update(positions_json(mesh.positions, mesh));
  if (!cells) result["triangles"] = numbers(mesh.triangles, width);
  if (!mesh.tetrahedra.empty()) result["tetrahedra"] = numbers(mesh.tetrahedra, width);
  if (!mesh.hexahedra.empty()) result["hexahedra"] = numbers(mesh.hexahedra, width);
  result["targets"] = Json::array();
  for (const auto& [name, positions] : item.targets) {
    if (positions.size() != mesh.positions.size())
      throw base::Error("invalid-argument", "a map has another number of vertices than its shape");
    Json target = positions_json(positions, mesh);
    target["name"] = name;
    result["targets"].push_back(std::move(target));
  }
  result["curves"] = Json::array();
  for (const ViewCurves& curves : item.curves)
    result["curves"].push_back({{"name", curves.name}, {"edges", numbers(curves.edges, width)}});
  result["figures"] = Json::array();
  for (const auto& [name, value] : item.figures)
    result["figures"].push_back({name, value});
  return result;
}

}  // namespace

std::string view_page(std::span<const ViewItem> items, const std::string& title, const ViewStart& start) {
  if (items.empty()) throw base::Error("invalid-argument", "no mesh for the page");
  Json data = {{"up", start.z_up ? "z" : "y"}, {"preset", start.preset}, {"items", Json::array()}};
  for (const ViewItem& item : items)
    data["items"].push_back(json_of(item));
  return filled_page(view_template(), title, data);
}

}  // namespace orbicube::cli
