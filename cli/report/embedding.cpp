#include "report/embedding.h"

#include "base/counted.h"
#include "mesh/search/intersections.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/place_text.h"

namespace orbicube::cli {
namespace {

// At a size near 1, where the products of the predicates neither overflow nor vanish.
template <class Faces, class Find>
std::string report_pairs(const std::string& path, std::span<const mesh::Vector3> positions, Faces faces,
                         const std::string& advice, Json& figures, Session& session, const Find& find) {
  base::Array<mesh::Vector3> unit(positions.begin(), positions.end(), session.host().memory);
  base::Array<mesh::Triangle> corners(session.host().memory);
  for (const auto& face : faces)
    corners.push_back({face[0], face[1], face[2]});
  mesh::scale_by_power(unit, mesh::unit_scale_exponent(unit, corners));
  const auto pairs = find(unit);
  figures["self_intersections"] = pairs.size();
  if (pairs.empty()) return "";
  const std::string note = path +
                           " intersects itself: " + base::counted(pairs.size(), "pair of faces", "pairs of faces") +
                           ", the first at " + mesh::place_text(positions[faces[pairs[0][0]][0]]) + "; " + advice;
  session.note(note);
  return note;
}

}  // namespace

std::string report_intersections(const std::string& path, std::span<const mesh::Vector3> positions,
                                 std::span<const mesh::Triangle> triangles, const std::string& advice, Json& figures,
                                 Session& session) {
  return report_pairs(path, positions, triangles, advice, figures, session,
                      [&](const auto& unit) { return mesh::intersecting_triangles(unit, triangles, session.host()); });
}

std::string report_intersections(const std::string& path, std::span<const mesh::Vector3> positions,
                                 std::span<const std::array<mesh::Index, 4>> quads, const std::string& advice,
                                 Json& figures, Session& session) {
  return report_pairs(path, positions, quads, advice, figures, session,
                      [&](const auto& unit) { return mesh::intersecting_quads(unit, quads, session.host()); });
}

}  // namespace orbicube::cli
