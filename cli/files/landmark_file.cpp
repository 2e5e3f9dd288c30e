#include "files/landmark_file.h"

#include <Eigen/Geometry>
#include <charconv>
#include <cmath>
#include <deque>
#include <string>
#include <string_view>

#include "base/counted.h"
#include "base/error.h"
#include "mesh/files/file.h"

namespace orbicube::cli {
namespace {

using mesh::Vector3;

std::vector<double> numbers_of(std::string_view line, std::size_t line_number) {
  std::vector<double> numbers;
  line = line.substr(0, line.find('#'));
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; };
  const char* at = line.data();
  const char* end = at + line.size();
  while (true) {
    while (at != end && is_space(*at))
      ++at;
    if (at == end) return numbers;
    double value = 0;
    const auto [next, problem] = std::from_chars(at, end, value);
    if (problem != std::errc() || !std::isfinite(value) || (next != end && !is_space(*next)))
      throw base::Error("parse", "line " + std::to_string(line_number) + ": '" +
                                     std::string(at, std::find_if(at, end, is_space)) + "' is no number");
    numbers.push_back(value);
    at = next;
  }
}

}  // namespace

std::vector<std::vector<LandmarkPoint>> read_landmark_points(const std::filesystem::path& path,
                                                             std::span<const mesh::Mesh* const> shapes,
                                                             const base::Host& host) {
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<std::vector<LandmarkPoint>> points(shapes.size());
  std::deque<mesh::SurfaceSearch> searches;  // made when a line has coordinates
  std::size_t line_number = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::vector<double> numbers = numbers_of(text.substr(begin, end - begin), ++line_number);
    begin = end + 1;
    if (numbers.empty()) continue;
    const std::string where = "line " + std::to_string(line_number);
    if (numbers.size() != shapes.size() && numbers.size() != 3 * shapes.size()) {
      throw base::Error("parse", where + " has " + base::counted(numbers.size(), "number") + "; for " +
                                     base::counted(shapes.size(), "shape") + " it needs one vertex each or three " +
                                     "coordinates each");
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const mesh::Mesh& shape = *shapes[i];
      if (numbers.size() == shapes.size()) {
        const double vertex = numbers[i];
        if (!(vertex >= 0 && vertex == std::floor(vertex) && vertex < static_cast<double>(shape.positions.size()))) {
          throw base::Error("index-range", where + ": shape " + std::to_string(i + 1) + " has no such vertex; it has " +
                                               std::to_string(shape.positions.size()));
        }
        LandmarkPoint point;
        point.vertex = static_cast<mesh::Index>(vertex);
        point.on_surface.position = shape.positions[point.vertex];
        points[i].push_back(point);
        continue;
      }
      if (searches.empty()) {
        for (const mesh::Mesh* each : shapes)
          searches.emplace_back(each->positions, each->triangles, host);
      }
      points[i].push_back(
          {mesh::no_index, searches[i].nearest({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]})});
    }
  }
  if (points[0].empty()) throw base::Error("parse", "there is no landmark in it");
  return points;
}

std::vector<std::vector<Vector3>> read_landmarks(const std::filesystem::path& path,
                                                 std::span<const MappedSurface> shapes, const base::Host& host) {
  std::vector<const mesh::Mesh*> meshes;
  for (const MappedSurface& shape : shapes)
    meshes.push_back(&shape.mesh);
  const auto points = read_landmark_points(path, meshes, host);
  std::vector<std::vector<Vector3>> directions(shapes.size());
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const LandmarkPoint& point : points[i]) {
      Vector3 direction = Vector3::Zero();
      if (point.vertex != mesh::no_index) {
        direction = shapes[i].directions[point.vertex];
      } else {
        for (std::size_t k = 0; k < 3; ++k)
          direction += point.on_surface.weights[static_cast<Eigen::Index>(k)] *
                       shapes[i].directions[meshes[i]->triangles[point.on_surface.triangle][k]];
      }
      directions[i].push_back(direction.normalized());
    }
  }
  return directions;
}

}  // namespace orbicube::cli
