// orbicube map: where the points of one surface are on another, through spheres or through one polycube.
#include <cmath>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/counted.h"
#include "correspondence/shape_maps.h"
#include "files/surface_file.h"
#include "files/vertex_values.h"
#include "mesh/files/file.h"
#include "mesh/files/text_writer.h"
#include "morphs/sphere_shapes.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "session/unused_options.h"
#include "verbs/verbs.h"
#ifdef ORBICUBE_WITH_POLYCUBE
#include "solids/shared_polycube.h"
#endif

namespace orbicube::cli {
namespace {

using correspondence::TrianglePoint;
using mesh::Triangle;

struct MapOptions {
  std::string from, to;
  std::string output;
  std::string via = "sphere";
  std::string align = "shape";
  std::string landmarks;
  std::string points;
  std::string table;
  std::string attributes;
  std::string values;
  std::size_t corners = 0;
  bool weld = false;
};

// The two surfaces, triangles as in their files, and the maps between them.
struct MappedPair {
  std::vector<mesh::Mesh> meshes;
  std::optional<correspondence::ShapeMaps> maps;
};

std::vector<std::span<const Triangle>> views_of(const std::vector<mesh::Mesh>& meshes) {
  std::vector<std::span<const Triangle>> result;
  for (const mesh::Mesh& m : meshes)
    result.emplace_back(m.triangles);
  return result;
}

MappedPair map_by_spheres(const MapOptions& options, Session& session) {
  const SphereShapesOptions of_spheres{
      {options.from, options.to}, options.landmarks, options.align, {.weld = options.weld}};
  std::deque<MorphShape> shapes = map_shapes(of_spheres, session);
  MappedPair result;
  for (const MorphShape& shape : shapes) {
    mesh::Mesh& m = result.meshes.emplace_back(session.host().memory);
    m.positions = shape.mesh.positions;
    m.triangles = shape.given;
  }
  align_shapes(shapes, of_spheres, session);
  session.figures()["shapes"] = {shapes[0].figures, shapes[1].figures};
  std::deque<correspondence::SphereShape> spheres;
  for (MorphShape& shape : shapes)
    spheres.push_back(std::move(static_cast<correspondence::SphereShape&>(shape)));
  result.maps.emplace(std::move(spheres), views_of(result.meshes), session.host());
  return result;
}

#ifdef ORBICUBE_WITH_POLYCUBE
MappedPair map_by_polycube(const MapOptions& options, Session& session) {
  SharedPolycube shared =
      share_polycube({.inputs = {options.from, options.to},
                      .landmarks = options.landmarks,
                      .common = {.construction = {.corners = options.corners, .seed = session.seed()}},
                      .mending = {.weld = options.weld}},
                     session);
  MappedPair result;
  result.meshes = std::move(shared.meshes);
  for (std::size_t i = 0; i < 2; ++i)
    result.meshes[i].triangles = std::move(shared.given[i]);
  session.figures()["shapes"] = shared.figures;
  result.maps.emplace(std::move(shared.common.maps), views_of(result.meshes), session.host());
  return result;
}
#endif

// Lines of a triangle and three weights.
base::Array<TrianglePoint> read_points(const std::string& path, const base::Host& host) {
  const VertexValues table = read_value_table(path, host);
  if (table.channels() != 4)
    throw base::Error("parse",
                      "a point is a triangle and three weights, not " + std::to_string(table.channels()) + " numbers");
  base::Array<TrianglePoint> result(host.memory);
  for (std::size_t i = 0; i < table.values.size(); i += 4) {
    const double* const row = table.values.data() + i;
    if (!(row[0] >= 0 && row[0] < 4294967295.0 && row[0] == std::floor(row[0])))
      throw base::Error("index-range", "point " + std::to_string(i / 4) + " names no triangle");
    result.push_back({static_cast<mesh::Index>(row[0]), {row[1], row[2], row[3]}});
  }
  return result;
}

// One line a point: its triangle, -1 for none, and weights.
void write_table(const std::string& path, const base::Array<TrianglePoint>& points, const base::Host& host) {
  const char separator = std::filesystem::path(path).extension() == ".csv" ? ',' : ' ';
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, points.size(), host);
  out << "triangle" << separator << "weight0" << separator << "weight1" << separator << "weight2\n";
  for (const TrianglePoint& point : points) {
    if (point.triangle == mesh::no_index)
      out << "-1";
    else
      out << point.triangle;
    for (const double weight : point.weights)
      out << separator << weight;
    out << '\n';
    out.end_item();
  }
  out.flush();
  file.commit();
}

// The values of B at the points; 0 at a point of no triangle.
VertexValues values_at(const VertexValues& values, std::span<const Triangle> triangles,
                       const base::Array<TrianglePoint>& points, const base::Host& host) {
  VertexValues result(host.memory);
  result.names = values.names;
  result.bytes = values.bytes;
  const std::size_t channels = values.channels();
  for (const TrianglePoint& point : points) {
    for (std::size_t c = 0; c < channels; ++c) {
      double sum = 0;
      for (std::size_t k = 0; k < 3 && point.triangle != mesh::no_index; ++k) {
        const std::size_t row =
            values.corners.empty() ? triangles[point.triangle][k] : values.corners[point.triangle][k];
        sum += point.weights[static_cast<Eigen::Index>(k)] * values.values[row * channels + c];
      }
      result.values.push_back(sum);
    }
  }
  return result;
}

VertexValues read_values(const MapOptions& options, const mesh::Mesh& to, const base::Host& host) {
  if (options.values.empty())
    return about(options.to, Role::input, [&] { return read_mesh_values(options.to, to, host); });
  return about(options.values, Role::input, [&] {
    VertexValues result = read_value_table(options.values, host);
    if (result.values.size() != result.channels() * to.positions.size())
      throw base::Error("parse", base::counted(result.values.size() / result.channels(), "line") + " of values for " +
                                     base::counted(to.positions.size(), "vertex", "vertices"));
    return result;
  });
}

void write_outputs(const MapOptions& options, const MappedPair& pair, Session& session) {
  const base::Host& host = session.host();
  const mesh::Mesh &from = pair.meshes[0], &to = pair.meshes[1];
  const base::Array<TrianglePoint> vertices = about(options.from, Role::input, [&] {
    return correspondence::carry_vertices(*pair.maps, 0, 1, from.positions.size(), host);
  });
  mesh::Mesh on_target(host.memory);
  on_target.triangles = from.triangles;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    on_target.positions.push_back(vertices[v].triangle == mesh::no_index
                                      ? from.positions[v]
                                      : correspondence::position_of(vertices[v], to.triangles, to.positions));
  write_output(options.output, on_target, true, session);
  session.figures()["output"] = options.output;
  session.figures()["vertices"] = vertices.size();
  session.figures()["distance"] = json_of_distance(to, on_target, host);
  session.figures()["flipped"] = pair.maps->flipped();
  session.say("wrote " + options.output + ": " + std::to_string(vertices.size()) + " vertices of " + options.from +
              " on " + options.to);
  if (!options.table.empty()) {
    const base::Array<TrianglePoint> table =
        options.points.empty() ? vertices : about(options.points, Role::input, [&] {
          return pair.maps->carry(0, 1, read_points(options.points, host), host);
        });
    about(options.table, Role::output, [&] { write_table(session.stage(options.table), table, host); });
    session.figures()["points"] = table.size();
    session.say("wrote " + options.table + ": " + base::counted(table.size(), "point"));
  }
  if (!options.attributes.empty()) {
    const VertexValues values = values_at(read_values(options, to, host), to.triangles, vertices, host);
    about(options.attributes, Role::output,
          [&] { write_values(session.stage(options.attributes), from, values, host); });
    session.figures()["attributes"] = values.names;
    session.say("wrote " + options.attributes + ": " + base::counted(values.channels(), "value") + " a vertex");
  }
}

void map(const MapOptions& options, Session& session) {
  session.options() = {{"from", options.from},     {"to", options.to},
                       {"output", options.output}, {"via", options.via},
                       {"align", options.align},   {"landmarks", options.landmarks},
                       {"points", options.points}, {"table", options.table},
                       {"weld", options.weld},     {"attributes", options.attributes},
                       {"values", options.values}, {"corners", options.corners}};
  require_writable(options.output);
  for (const std::string& path : {options.table, options.attributes})
    if (!path.empty()) require_folder(path);
#ifdef ORBICUBE_WITH_POLYCUBE
  const MappedPair pair =
      options.via == "polycube" ? map_by_polycube(options, session) : map_by_spheres(options, session);
#else
  const MappedPair pair = map_by_spheres(options, session);
#endif
  write_outputs(options, pair, session);
  for (const std::string& note : session.notes())
    session.say("  note: " + note);
}

void add_map_options(CLI::App& verb, MapOptions& options) {
  verb.add_option("A", options.from, std::string("closed surface whose vertices are mapped: ") + surface_endings)
      ->required()
      ->type_name("");
  verb.add_option("B", options.to, "closed surface of the same genus that they are mapped to")
      ->required()
      ->type_name("");
  verb.add_option("-o,--output", options.output, "the vertices of A on B, with the faces of A: " + surface_endings)
      ->required()
      ->type_name("OUT");
#ifdef ORBICUBE_WITH_POLYCUBE
  verb.add_option("--via", options.via,
                  "common domain: sphere, for surfaces of genus 0; polycube, for surfaces of any one genus [default: "
                  "sphere]")
      ->check(unnamed(CLI::IsMember({"sphere", "polycube"})))
      ->type_name("DOMAIN");
  verb.add_option("--corners", options.corners, "maximum number of polycube corners; 0: no limit [default: 0]")
      ->check(unnamed(CLI::Range(0, 1'000'000)))
      ->type_name("N");
#endif
  verb.add_option("--align", options.align, align_help)
      ->check(unnamed(CLI::IsMember({"shape", "rotation", "none"})))
      ->type_name("HOW");
  verb.add_option("--landmarks", options.landmarks,
                  "corresponding points: one line each, with a vertex number (from 0) or x y z for each surface")
      ->type_name("FILE");
  CLI::Option* table = verb.add_option("--table", options.table,
                                       "write for each vertex of A the triangle of B, counted from 0, and its weights "
                                       "at the three corners, as text "
                                       "or .csv")
                           ->type_name("FILE");
  verb.add_option("--points", options.points,
                  "points of A for --table in place of its vertices: a triangle and three weights a line")
      ->needs(table)
      ->type_name("FILE");
  CLI::Option* attributes = verb.add_option("--attributes", options.attributes,
                                            "write values of B at the vertices of A: as text, .csv, or in A itself, "
                                            ".ply. B is PLY (all properties of its "
                                            "vertices) or OBJ (colors, texture coordinates)")
                                ->type_name("FILE");
  verb.add_option(
          "--values", options.values,
          "values of the vertices of B for --attributes in place of those in its file: numbers, a line a vertex; "
          "names in the first line")
      ->needs(attributes)
      ->type_name("FILE");
  add_weld_option(verb, options.weld);
}

}  // namespace

void add_map(CLI::App& app, CommonOptions& common) {
  CLI::App* verb = app.add_subcommand("map", "map the points of one surface to another");
  const auto options = std::make_shared<MapOptions>();
  add_map_options(*verb, *options);
  add_common_options(*verb, common);
  verb->footer(
      "Both surfaces are mapped to the sphere or to one polycube; points at one place correspond. The map is "
      "bijective.\nFor example:\n  orbicube map horse.ply cow.obj --via polycube -o horse-on-cow.ply --table "
      "points.csv");
  verb->callback([options, verb, &common] {
    Session session(common, "map", options->from);
    session.run([&] {
      refuse_unused_map_options(*verb);
      map(*options, session);
    });
  });
}

}  // namespace orbicube::cli
