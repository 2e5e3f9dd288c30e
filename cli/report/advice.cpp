#include "report/advice.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "base/catch_all.h"
#include "base/counted.h"
#include "files/surface_file.h"
#include "gltf/reading/read.h"
#include "mesh/features/handle_place.h"
#include "mesh/files/read.h"
#include "mesh/topology/disjoint_sets.h"
#include "mesh/topology/edge_table.h"
#include "mesh/topology/place_text.h"
#include "mesh/topology/topology.h"
#include "mesh/topology/weld.h"

namespace orbicube::cli {
namespace {

using mesh::Edge;
using mesh::Index;
using mesh::Vector3;

mesh::Mesh read_again(const std::string& path, bool welded, const base::Host& host) {
  if (is_gltf(path)) return gltf::read(path, {}, host);
  return mesh::read_mesh(path, {.weld_identical = welded}, host);
}

std::vector<Edge> boundary_of(const mesh::Mesh& m, const base::Host& host) {
  const mesh::EdgeTable edges(m.positions.size(), m.triangles, host);
  std::vector<Edge> boundary;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto h = edges.half_edges(e);
    if (h.size() == 1) boundary.push_back({mesh::start_of(m.triangles, h[0]), mesh::end_of(m.triangles, h[0])});
  }
  return boundary;
}

std::vector<Index> vertices_of(const std::vector<Edge>& edges) {
  std::vector<Index> vertices;
  for (const Edge& e : edges)
    vertices.insert(vertices.end(), e.begin(), e.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// Boundary vertices at the place of another vertex of a triangle.
std::size_t doubled(const mesh::Mesh& m, const std::vector<Index>& boundary, const base::Host& host) {
  const base::Array<Index> first = mesh::first_at_same_position(m.positions, host);
  std::vector<std::uint8_t> used(m.positions.size(), 0);
  for (const mesh::Triangle& t : m.triangles)
    for (const Index v : t)
      used[v] = 1;
  std::vector<Index> lowest(m.positions.size(), mesh::no_index);
  std::vector<std::uint8_t> several(m.positions.size(), 0);
  for (Index v = 0; v < m.positions.size(); ++v) {
    if (used[v] == 0) continue;
    Index& earlier = lowest[first[v]];
    if (earlier == mesh::no_index) {
      earlier = v;
    } else {
      several[first[v]] = 1;
    }
  }
  return static_cast<std::size_t>(std::count_if(
      boundary.begin(), boundary.end(), [&](Index v) { return several[first[v]] != 0 && lowest[first[v]] != v; }));
}

// A vertex of the boundary that lies within a boundary edge, to a millionth of its length.
std::optional<std::pair<Index, Edge>> vertex_on_edge(const mesh::Mesh& m, const std::vector<Edge>& boundary,
                                                     std::vector<Index> vertices) {
  const auto x = [&](Index v) { return m.positions[v].x(); };
  std::sort(vertices.begin(), vertices.end(), [&](Index a, Index b) { return x(a) < x(b); });
  constexpr double share = 1e-6;
  std::size_t looked_at = 0;
  constexpr std::size_t most = 20'000'000;  // a second; beyond that, the message does without
  for (const Edge& e : boundary) {
    const Vector3 &a = m.positions[e[0]], &b = m.positions[e[1]];
    const Vector3 along = b - a;
    const double length = along.norm(), near = share * length;
    if (!(length > 0)) continue;
    const double low = std::min(a.x(), b.x()) - near, high = std::max(a.x(), b.x()) + near;
    auto v =
        std::lower_bound(vertices.begin(), vertices.end(), low, [&](Index i, double value) { return x(i) < value; });
    for (; v != vertices.end() && x(*v) <= high; ++v) {
      if (++looked_at > most) return std::nullopt;
      const Vector3 from = m.positions[*v] - a;
      const double at = from.dot(along) / length;
      if (at > near && at < length - near && from.cross(along).norm() <= near * length) return std::pair(*v, e);
    }
  }
  return std::nullopt;
}

// "SUBJECT (x, y, z); ", unless the refusal itself has a place.
std::string place_unless_told(const Failure& failure, const std::string& subject, const Vector3& place) {
  return std::string_view(failure.what()).find("at (") != std::string_view::npos
             ? ""
             : subject + mesh::place_text(place) + "; ";
}

std::string of_holes(const Failure& failure, const mesh::Mesh& m, const std::string& repair, const base::Host& host) {
  const std::vector<Edge> boundary = boundary_of(m, host);
  const std::vector<Index> vertices = vertices_of(boundary);
  if (const std::size_t n = doubled(m, vertices, host); n > 0) {
    return base::counted(n, "vertex stands", "vertices stand") + " at the place of others: try --weld";
  }
  if (const auto found = vertex_on_edge(m, boundary, vertices)) {
    const auto& [v, e] = *found;
    return "vertex " + std::to_string(v) + " at " + mesh::place_text(m.positions[v]) + " lies on the edge " +
           std::to_string(e[0]) + "-" + std::to_string(e[1]) + ": " + repair + " splits it there";
  }
  return place_unless_told(failure, "the edge is at ", m.positions[boundary.front()[0]]) + repair + " fills holes";
}

std::string of_parts(const mesh::Mesh& m, const std::string& verb, const std::string& repair, const base::Host& host) {
  mesh::DisjointSets sets(m.positions.size(), host.memory);
  for (const mesh::Triangle& t : m.triangles) {
    sets.unite(t[0], t[1]);
    sets.unite(t[0], t[2]);
  }
  std::vector<std::size_t> sizes(m.positions.size(), 0);
  for (const mesh::Triangle& t : m.triangles)
    ++sizes[sets.find(t[0])];
  std::sort(sizes.begin(), sizes.end(), std::greater<>());
  const auto parts = static_cast<std::size_t>(std::find(sizes.begin(), sizes.end(), 0U) - sizes.begin());
  if (parts < 2) return "";
  constexpr std::size_t most_told = 5;
  std::string text = "they have ";
  for (std::size_t i = 0; i < std::min(parts, most_told); ++i)
    text += (i > 0 ? ", " : "") + std::to_string(sizes[i]);
  if (parts > most_told) text += ", ...";
  text += " triangles; " + repair + " keeps the largest";
  return verb == "hex" || verb == "volume" ? text : text + " (hex and tetrahedralize take several parts)";
}

std::string of_first_edge_or_vertex(const Failure& failure, const mesh::Mesh& m, const std::string& repair,
                                    const base::Host& host) {
  const mesh::Topology facts = mesh::topology(m.positions, m.triangles, host);
  const bool edge = failure.kind() == "non-manifold-edge";
  const Index v = edge ? facts.first_non_manifold_edge[0] : facts.first_non_manifold_vertex;
  if (v >= m.positions.size()) return "";
  return place_unless_told(failure, "it is at ", m.positions[v]) + repair + " separates the sheets that meet there";
}

// Surfaces with handles have polycubes, but no spheres; those of several surfaces have as many.
std::string of_handles(const Failure& failure, const std::string& verb, bool welded, const base::Host& host) {
  const bool by_polycube = std::string(failure.what()).find("polycube") != std::string::npos;
  std::string text = by_polycube        ? "orbicube repair --genus N cuts handles"
                     : verb == "sphere" ? "surfaces with handles have polycubes: orbicube polycube, or hex"
                     : verb == "morph"  ? "surfaces with as many handles have polycubes: try --polycube"
                                        : "surfaces with as many handles have polycubes: try --via polycube";
  if (!by_polycube) text += "; orbicube repair --genus 0 cuts handles";
  const mesh::Mesh m = read_again(failure.file(), welded, host);
  const mesh::Topology facts = mesh::topology(m.positions, m.triangles, host);
  // What was repaired is not in the file.
  if (!facts.closed() || !facts.manifold() || facts.components != 1) return text;
  const std::optional<Index> v = mesh::handle_place(m.positions, m.triangles, host);
  if (!v) return text;
  return "a handle is at " + mesh::place_text(m.positions[*v]) + " (vertex " + std::to_string(*v) + "); " + text;
}

std::string of_kind(const Failure& failure, const std::string& verb, bool welded, const base::Host& host) {
  const std::string& kind = failure.kind();
  // The option of the verb, or the verb that writes a file.
  static constexpr std::array mends = {"sphere", "polycube", "tetrahedralize", "hex", "volume", "morph"};
  const bool has_option = std::find(mends.begin(), mends.end(), verb) != mends.end();
  const std::string repair = has_option ? "--repair" : "orbicube repair";
  if (kind == "wrong-genus" && failure.exit_code() == Exit::wrong_input &&
      (verb == "sphere" || verb == "morph" || verb == "map" || verb == "polycube"))
    return of_handles(failure, verb, welded, host);
  if (kind == "degenerate-face" && (verb == "tetrahedralize" || verb == "hex" || verb == "volume"))
    return "--repair collapses or flips them; sphere and polycube take such faces";
  if (kind == "duplicate-face") return repair + " keeps one of each";
  if (kind == "inverted-cell" && verb != "untangle") return "orbicube untangle can repair it";
  if (kind == "self-intersection" && verb == "tetrahedralize")
    return "--report lists the pairs; orbicube repair --wrap DISTANCE makes a surface around it";
  if (kind == "self-intersection" && verb == "hex")
    return "orbicube tetrahedralize --report lists the pairs; orbicube repair --wrap DISTANCE makes a surface around "
           "it";
  if (kind == "time-limit") return verb == "sphere" ? "--keep-partial writes what there is" : "";
  const bool about_places =
      kind == "not-closed" || kind == "not-connected" || kind == "non-manifold-edge" || kind == "non-manifold-vertex";
  if (!about_places || failure.exit_code() != Exit::wrong_input) return "";
  const mesh::Mesh m = read_again(failure.file(), welded, host);
  if (m.triangles.empty()) return "";
  if (kind == "not-closed") return of_holes(failure, m, repair, host);
  if (kind == "not-connected") return of_parts(m, verb, repair, host);
  return of_first_edge_or_vertex(failure, m, repair, host);
}

}  // namespace

std::string advice(const Failure& failure, const std::string& verb, bool welded, const base::Host& host) {
  return base::catch_all([&] { return of_kind(failure, verb, welded, host); },
                         [] { return std::string(); });  // the refusal stands without
}

}  // namespace orbicube::cli
