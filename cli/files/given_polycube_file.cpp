#include "files/given_polycube_file.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <string_view>

#include "files/json_file.h"
#include "files/polycube_json.h"
#include "files/surface_file.h"

namespace orbicube::cli {
namespace {

using mesh::Index;
using mesh::Vector3;

struct FacesInFile {
  std::vector<Vector3> corners;
  std::vector<std::vector<Index>> loop_begins, loops;  // of each patch
  std::vector<polycube::GivenPatch> patches;           // views of them
};

FacesInFile faces_of(const Json& file) {
  if (!file.is_object() || file.value("format", "") != polycube_format)
    refuse_file("this is no polycube: its \"format\" is not \"" + std::string(polycube_format) + "\"");
  if (file.value("version", 0) != 1)
    throw base::Error("unsupported-version", "only version 1 of polycubes can be read");
  FacesInFile result;
  const Json& corners = json_array(file, "corners", "the polycube");
  for (std::size_t c = 0; c < corners.size(); ++c)
    result.corners.push_back(json_point(corners[c], "corner " + std::to_string(c)));
  const Json& patches = json_array(file, "patches", "the polycube");
  std::vector<polycube::AxisLabel> labels;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const std::string where = "patch " + std::to_string(p);
    const Json& axis = json_member(patches[p], "axis", where);
    const std::size_t number = axis.is_string() ? std::string_view("xyz").find(axis.get<std::string>()) : 3;
    if (number > 2 || axis.get<std::string>().size() != 1) refuse_file("\"axis\" of " + where + " is not x, y or z");
    const Json& sign = json_member(patches[p], "sign", where);
    if (sign != 1 && sign != -1) refuse_file("\"sign\" of " + where + " is neither 1 nor -1");
    labels.push_back(polycube::label_of(static_cast<int>(number), sign.get<int>()));
    std::vector<Index> begins(1, 0), all;
    for (const Json& loop : json_array(patches[p], "loops", where)) {
      if (!loop.is_array()) refuse_file("a loop of " + where + " is no array");
      for (const Json& corner : loop)
        all.push_back(json_index(corner, "a corner in a loop of " + where));
      begins.push_back(static_cast<Index>(all.size()));
    }
    result.loop_begins.push_back(std::move(begins));
    result.loops.push_back(std::move(all));
  }
  for (std::size_t p = 0; p < labels.size(); ++p)
    result.patches.push_back({labels[p], result.loop_begins[p], result.loops[p]});
  return result;
}

// The corner of the graph at each of the positions, exactly or as near as `tolerance`.
base::Array<Index> corners_at(std::span<const Vector3> positions, const polycube::PatchGraph& graph, double tolerance,
                              std::pmr::memory_resource* memory) {
  base::Array<Index> result(positions.size(), mesh::no_index, memory);
  // By their x, which a few share.
  std::multimap<double, Index> along;
  for (Index c = 0; c < graph.corners.size(); ++c)
    along.emplace(graph.corners[c][0], c);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const auto end = along.upper_bound(positions[i][0] + tolerance);
    for (auto at = along.lower_bound(positions[i][0] - tolerance); at != end; ++at)
      if ((graph.corners[at->second] - positions[i]).cwiseAbs().maxCoeff() <= tolerance) result[i] = at->second;
  }
  return result;
}

}  // namespace

GivenPolycube read_given_polycube(const std::filesystem::path& path, Session& session) {
  const base::Host& host = session.host();
  GivenPolycube result(host.memory);
  if (is_json(path)) {
    about(path, Role::input, [&] {
      const Json file = json_file(path, host);
      const FacesInFile faces = faces_of(file);
      result.target = polycube::target_of_patches(faces.corners, faces.patches, host);
      result.numbered = corners_at(faces.corners, result.target.graph, 0, host.memory);
      if (!file.contains("corner_points")) return;
      const Json& points = json_array(file, "corner_points", "the polycube");
      if (points.size() != faces.corners.size()) refuse_file("there are not as many \"corner_points\" as corners");
      result.pose.assign(result.target.graph.corners.size(), Vector3::Zero());
      for (std::size_t c = 0; c < points.size(); ++c)
        if (result.numbered[c] != mesh::no_index)
          result.pose[result.numbered[c]] = json_point(points[c], "corner point " + std::to_string(c));
    });
    return result;
  }
  const mesh::Mesh m = read_input(path, true, session).mesh;
  about(path, Role::input, [&] {
    if (m.triangles.empty()) throw base::Error("empty-mesh", "no triangles");
    Vector3 low = m.positions[m.triangles[0][0]], high = low;
    for (const mesh::Triangle& t : m.triangles) {
      for (const Index v : t) {
        low = low.cwiseMin(m.positions[v]);
        high = high.cwiseMax(m.positions[v]);
      }
    }
    // What programs that write meshes round coordinates by, and far less than a patch of a polycube is wide.
    const double tolerance = 1e-6 * (high - low).norm();
    result.target = polycube::target_of_mesh(m.positions, m.triangles, tolerance, host);
    result.numbered = corners_at(m.positions, result.target.graph, tolerance, host.memory);
  });
  return result;
}

std::vector<polycube::CornerPlace> read_corner_places(const std::filesystem::path& path, const GivenPolycube& given,
                                                      const base::Host& host) {
  return about(path, Role::input, [&] {
    const Json file = json_file(path, host);
    if (!file.is_array()) refuse_file("this is no array of constraints");
    std::vector<polycube::CornerPlace> result;
    for (std::size_t i = 0; i < file.size(); ++i) {
      const std::string where = "constraint " + std::to_string(i);
      const Index number = json_index(json_member(file[i], "corner", where), "\"corner\" of " + where);
      if (number >= given.numbered.size() || given.numbered[number] == mesh::no_index)
        throw base::Error("index-range", where + ": the polycube has no corner " + std::to_string(number));
      polycube::CornerPlace place{given.numbered[number], Vector3::Zero()};
      if (file[i].contains("vertex"))
        place.vertex = json_index(file[i]["vertex"], "\"vertex\" of " + where);
      else
        place.point = json_point(json_member(file[i], "point", where), "\"point\" of " + where);
      result.push_back(place);
    }
    return result;
  });
}

}  // namespace orbicube::cli
