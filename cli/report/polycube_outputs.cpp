#include "report/polycube_outputs.h"

#include <filesystem>
#include <utility>

#include "base/counted.h"
#include "files/polycube_json.h"
#include "files/quad_file.h"
#include "files/surface_file.h"
#include "mesh/files/file.h"
#include "mesh/files/write.h"
#include "polycube/outputs/quad_mesh.h"
#include "report/embedding.h"
#include "report/sphere_uses.h"
#include "report/text.h"
#include "scenes/page_figures.h"
#include "scenes/polycube_page.h"
#include "scenes/polycube_scene.h"
#include "textures/atlas_scene.h"

namespace orbicube::cli {
namespace {

void require_quad_format(const std::string& path) {
  require_writable(path);
  if (!mesh::holds(path, mesh::Holds::polygons))
    throw Failure(Exit::wrong_input, path, "unsupported-format", "quads are written to " + polygon_endings);
}

void write_text(const std::string& path, const std::string& text, Session& session) {
  about(path, Role::output, [&] {
    mesh::OutputFile file(session.stage(path));
    file.write(text);
    file.commit();
  });
}

void write_domain(const std::string& path, const PolycubeResult& result, const polycube::PatchGraph& graph,
                  Json& figures, Session& session) {
  if (is_json(path)) {
    write_text(path, json_of(graph, result.genus, result.map.positions).dump(1) + "\n", session);
  } else {
    about(path, Role::output, [&] {
      // Rectangles between the planes of all patches, so that neighbors fit.
      polycube::PolycubeGrid coarse = polycube::make_grid(graph, {.quads = 1}, session.host());
      const polycube::QuadMesh mesh = polycube::mesh_grid(graph, coarse, session.host());
      write_quads(session.stage(path), mesh.polycube, mesh.quads, session.host());
    });
  }
  figures["domain_file"] = {
      {"output", path}, {"corners", graph.corners.size()}, {"edges", graph.edges()}, {"patches", graph.patches()}};
  session.say("wrote " + path + ": the polycube by itself, " + base::counted(graph.edges(), "edge"));
}

void write_quad_mesh(const PolycubeOutputs& outputs, const PolycubeResult& result, const polycube::PatchGraph& graph,
                     Json& figures, Session& session) {
  const base::Host& host = session.host();
  const double start = session.seconds();
  mesh::Mesh surface(host.memory), remeshed(host.memory);
  polycube::QuadMesh mesh(host.memory);
  about(outputs.quads, Role::output, [&] {
    const polycube::PolycubeGrid grid =
        polycube::make_grid(graph, {.edge_length = outputs.cell_size, .quads = outputs.cells}, host);
    mesh = polycube::mesh_grid(graph, grid, host);
    polycube::sample_grid(result.map, mesh, host);
    write_quads(session.stage(outputs.quads), mesh.positions, mesh.quads, host);
  });
  const double written = session.seconds() - start;
  const polycube::QuadQuality quality = polycube::measure_quads(mesh.positions, mesh.quads, host);
  surface.positions = result.map.positions;
  surface.triangles = result.map.triangles;
  remeshed.positions = mesh.positions;
  for (const auto& [a, b, c, d] : mesh.quads) {
    remeshed.triangles.push_back({a, b, c});
    remeshed.triangles.push_back({a, c, d});
  }
  figures["quads"] = {{"output", outputs.quads},
                      {"vertices", mesh.positions.size()},
                      {"quads", mesh.quads.size()},
                      {"irregular_vertices", quality.irregular},
                      {"min_scaled_jacobian", quality.min_scaled_jacobian},
                      {"mean_scaled_jacobian", quality.mean_scaled_jacobian},
                      {"quads_not_convex", quality.not_convex},
                      {"max_over_mean_area", quality.area_ratio},
                      {"distance", json_of_distance(surface, remeshed, host)},
                      {"seconds", written}};
  const std::string note =
      report_intersections(outputs.quads, mesh.positions, mesh.quads, "more --cells follow the surface more closely",
                           figures["quads"], session);
  session.say("wrote " + outputs.quads + ": " + base::counted(mesh.quads.size(), "quad") + ", " +
              base::counted(quality.irregular, "irregular vertex", "irregular vertices") + ", scaled Jacobian " +
              number(quality.mean_scaled_jacobian) + " on average, " + base::counted(quality.not_convex, "quad") +
              " not convex");
  if (!note.empty()) session.say("  note: " + note);
}

void write_atlas(const PolycubeOutputs& outputs, const PolycubeResult& result, const polycube::PatchGraph& graph,
                 Json& figures, Session& session) {
  const double start = session.seconds();
  about(outputs.atlas, Role::output, [&] {
    const std::string name = std::filesystem::path(result.input).stem().string();
    figures["atlas"] = Json{{"output", outputs.atlas}};
    figures["atlas"].update(
        write_atlas_scene({session.stage(outputs.atlas), outputs.atlas_options, outputs.texture ? result.input : ""},
                          result.map, graph, name, session.host()));
  });
  Json& own = figures["atlas"];
  own["seconds"] = session.seconds() - start;
  session.say("wrote " + outputs.atlas + ": an atlas of " + base::counted(graph.patches(), "patch", "patches") +
              " on " + number(100 * own["coverage"].get<double>()) + " percent of a texture of " +
              std::to_string(outputs.atlas_options.size) + " texels along a side");
  if (const auto lost = own["triangles_lost_in_texture"].get<std::size_t>(); lost > 0)
    session.say("  note: " + base::counted(lost, "triangle") + " of the atlas flat or mirrored in float32");
}

void write_page_of(const std::string& path, const PolycubeResult& result, Session& session) {
  const std::string name = std::filesystem::path(result.input).filename().string();
  const FaceDistortions faces = face_distortions(result.map, session.host());
  PageResult shown;
  shown.name = name;
  shown.positions = result.map.positions;
  shown.polycube = result.map.polycube;
  shown.triangles = result.map.triangles;
  shown.quasi_conformal = faces.quasi_conformal;
  shown.area_ratio = faces.area_ratio;
  shown.energies = result.energies;
  shown.figures = {
      {"Vertices", std::to_string(result.map.positions.size())},
      {"Triangles", std::to_string(result.map.triangles.size())},
      {"One to one, checked exactly", "yes"},
      {"Genus", std::to_string(result.genus)},
      {"Corners of the polycube", std::to_string(result.corners)},
      {"Patches of the polycube", std::to_string(result.patches)},
      {"Angle distortion, mean over triangles (at least 1)", number(result.distortion.angle_mean)},
      {"Area distortion, mean over triangles (at least 1)", number(result.distortion.area_mean)},
      {"Angle distortion, mean over the surface", number(result.distortion.angle_weighted_mean)},
      {"Area distortion, mean over the surface", number(result.distortion.area_weighted_mean)},
  };
  write_page(path, {&shown, 1}, "Polycube of " + name, session);
  session.say("wrote " + path);
}

}  // namespace

Json distortion_figures(const polycube::Distortion& d) {
  return {{"angle_mean", d.angle_mean},
          {"area_mean", d.area_mean},
          {"angle_weighted_mean", d.angle_weighted_mean},
          {"area_weighted_mean", d.area_weighted_mean},
          {"zero_area_faces", d.left_out}};
}

void add_polycube_outputs(CLI::App& verb, PolycubeOutputs& outputs) {
  verb.add_option(
          "--domain", outputs.domain,
          "write the polycube alone: .json with corners, edges, patches and dual graph, or a mesh of rectangles")
      ->type_name("FILE");
  verb.add_option("--quads", outputs.quads, "write a quad mesh of the surface, on a regular grid of the polycube")
      ->type_name("FILE");
  CLI::Option* cells = verb.add_option("--cells", outputs.cells, "approximate number of quads [default: 10000]")
                           ->check(unnamed(CLI::Range(1, 100'000'000)))
                           ->type_name("N");
  verb.add_option("--cell-size", outputs.cell_size,
                  "approximate edge length of quads on the polycube, in place of --cells")
      ->check(positive_number())
      ->excludes(cells)
      ->type_name("H");
  verb.add_option("--glb", outputs.glb,
                  "write the surface with a checker along the polycube axes and the polycube as a morph target")
      ->type_name("FILE.glb");
  verb.add_option("--atlas", outputs.atlas,
                  "write the surface with the patches of the polycube as a texture atlas, tangents and a texture")
      ->type_name("FILE.glb");
  verb.add_option("--atlas-size", outputs.atlas_options.size, "texels along a side of the atlas [default: 1024]")
      ->check(unnamed(CLI::Range(16, 16384)))
      ->type_name("N");
  verb.add_option("--atlas-padding", outputs.atlas_options.padding,
                  "minimum distance of two patches of the atlas, in texels [default: 4]")
      ->check(number_from_to(0, 1024))
      ->type_name("TEXELS");
  verb.add_flag("--texture", outputs.texture,
                "bake the colors of IN, a glTF file, into the texture of the atlas, in place of a checker");
  verb.add_option("--page", outputs.page, "write a page with shape and polycube side by side, and the figures")
      ->type_name("FILE.html");
}

void check_polycube_outputs(const PolycubeOutputs& outputs, Session& session) {
  session.options().update(Json{{"domain", outputs.domain},
                                {"quads", outputs.quads},
                                {"cells", outputs.cells},
                                {"cell_size", outputs.cell_size},
                                {"glb", outputs.glb},
                                {"atlas", outputs.atlas},
                                {"atlas_size", outputs.atlas_options.size},
                                {"atlas_padding", outputs.atlas_options.padding},
                                {"texture", outputs.texture},
                                {"page", outputs.page}});
  if (is_json(outputs.domain)) {
    require_folder(outputs.domain);
  } else if (!outputs.domain.empty()) {
    require_quad_format(outputs.domain);
  }
  if (!outputs.quads.empty()) require_quad_format(outputs.quads);
  if (!outputs.page.empty()) require_folder(outputs.page);
  for (const auto& [option, path] : {std::pair("--glb", &outputs.glb), std::pair("--atlas", &outputs.atlas)}) {
    if (path->empty()) continue;
    require_folder(*path);
    if (!is_gltf(*path))
      throw Failure(Exit::wrong_input, *path, "unsupported-format",
                    std::string(option) + " needs one of " + gltf_endings);
  }
}

void write_polycube_outputs(const PolycubeOutputs& outputs, const PolycubeResult& result, Json& figures,
                            Session& session) {
  const base::Host& host = session.host();
  if (!outputs.domain.empty() || !outputs.quads.empty() || !outputs.atlas.empty()) {
    const polycube::PatchGraph graph = polycube::make_patch_graph(result.map, host);
    if (!outputs.domain.empty()) write_domain(outputs.domain, result, graph, figures, session);
    if (!outputs.quads.empty()) write_quad_mesh(outputs, result, graph, figures, session);
    if (!outputs.atlas.empty()) write_atlas(outputs, result, graph, figures, session);
  }
  if (!outputs.glb.empty()) {
    about(outputs.glb, Role::output, [&] {
      const std::string name = std::filesystem::path(result.input).stem().string();
      figures["glb"] = write_polycube_scene(session.stage(outputs.glb), result.map, name, host);
      figures["glb"]["output"] = outputs.glb;
    });
    session.say("wrote " + outputs.glb);
  }
  if (!outputs.page.empty()) write_page_of(outputs.page, result, session);
}

}  // namespace orbicube::cli
