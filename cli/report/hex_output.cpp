#include "report/hex_output.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/counted.h"
#include "files/surface_file.h"
#include "mesh/files/write.h"
#include "mesh/regions/nearest_regions.h"
#include "mesh/regions/region_numbers.h"
#include "mesh/search/unit_scale.h"
#include "mesh/topology/place_text.h"
#include "report/text.h"
#include "solids/solid_input.h"

namespace orbicube::cli {

namespace {

// Beyond this multiple of --distance there is no result.
constexpr double far = 2;

Json json_of(const hexmesh::HexPiece& piece, const Json& method) {
  return {{"place", {piece.place[0], piece.place[1], piece.place[2]}},
          {"hexahedra", piece.hexahedra},
          {"hausdorff_percent", piece.distance},
          {"volume_error_percent", piece.volume_error},
          {"method", piece.grid_based   ? Json("grid")
                     : method == "grid" ? Json("polycube")
                                        : method}};
}

Json json_of(std::span<const hexmesh::HexPiece> pieces, const Json& method) {
  Json all = Json::array();
  for (const hexmesh::HexPiece& piece : pieces)
    all.push_back(json_of(piece, method));
  return all;
}

// How they were made.
Json figures_of(const hexmesh::Hexahedra& made) {
  if (!made.along_frames) {
    return {{"method", made.method == hexmesh::Method::grid ? "grid" : "polycube"},
            {"padded", made.result.padded},
            {"follows_sharp_edges", made.result.follows_sharp_edges},
            {"seconds_compute", made.compute_seconds}};
  }
  const hexmesh::FrameFigures& frames = *made.along_frames;
  return {{"inner_irregular_edges", frames.inner_irregular_edges},
          {"tetrahedra", frames.tetrahedra},
          {"singular_edges", frames.singular_edges},
          {"cut_faces", frames.cut_faces},
          {"integers", frames.integers},
          {"layer_bounds", frames.layer_bounds},
          {"integers_optimal", frames.integers_optimal},
          {"inverted_at_start", frames.inverted_at_start},
          {"steps", frames.steps},
          {"fields", frames.fields},
          {"seconds_fill", frames.fill_seconds},
          {"seconds_frames", frames.field_seconds},
          {"seconds_compute", made.compute_seconds},
          {"method", "frames"}};
}

// What people may want to know besides scaled Jacobians.
std::string besides(const hexmesh::Hexahedra& made) {
  if (made.along_frames)
    return base::counted(made.along_frames->inner_irregular_edges, "inner edge") + " with other than four hexahedra";
  if (made.features && made.features->replaced) return "cells of a grid in space around the features";
  if (made.method == hexmesh::Method::grid) return "cells of a grid in space";
  return base::counted(made.polycube_corners, "corner") + " of the polycube";
}

Json place(const mesh::Vector3& p) {
  return {p[0], p[1], p[2]};
}

Json json_of(const hexmesh::FeatureFigures& features) {
  Json missing = Json::array();
  for (const hexmesh::MissingFeature& m : features.missing) {
    if (m.corner)
      missing.push_back({{"corner", m.number}, {"place", place(m.from)}, {"why", m.why}});
    else
      missing.push_back({{"curve", m.number},
                         {"from", place(m.from)},
                         {"to", place(m.to)},
                         {"captured", m.captured},
                         {"why", m.why}});
  }
  return {{"curves", features.curves},     {"corners", features.corners},
          {"captured", features.captured}, {"scaled_jacobian_bound", features.bound},
          {"replaced", features.replaced}, {"missing", missing}};
}

std::string features_text(const hexmesh::FeatureFigures& features) {
  if (features.curves + features.corners == 0) return "no features";
  return std::to_string(features.curves - features.missing_curves()) + " of " + std::to_string(features.curves) +
         " feature curves and " + std::to_string(features.corners - features.missing_corners()) + " of " +
         std::to_string(features.corners) + " corners kept, " + number(100 * features.captured) + " % of the length" +
         (features.replaced ? "; they bound scaled Jacobians by " + number(features.bound) : "");
}

std::string regions_text(const hexmesh::RegionFigures& regions) {
  return base::counted(regions.interface_quads, "quadrilateral") + " between regions, at most " +
         number(regions.distance) + " % of the diagonal from where these meet";
}

// Null where the unit of the input takes it out of the range of double.
Json in_range(double volume) {
  return std::isfinite(volume) && volume != 0 ? Json(volume) : Json();
}

std::string figures_text(const hexmesh::HexResult& result) {
  return "at most " + number(result.distance) + " % of the diagonal from the surface, volume off by " +
         number(result.volume_error) + " %";
}

// The piece that is worst by itself.
std::string worst_piece_text(const hexmesh::HexResult& result) {
  const auto off = [](const hexmesh::HexPiece& piece) { return std::max(piece.distance, piece.volume_error); };
  const auto worst = std::max_element(result.pieces.begin(), result.pieces.end(),
                                      [&](const auto& a, const auto& b) { return off(a) < off(b); });
  return "of " + base::counted(result.pieces.size(), "piece") + " the worst is that at " +
         mesh::place_text(worst->place) + ": " + number(worst->distance) +
         " % of its own diagonal from its surface, volume off by " + number(worst->volume_error) + " %, " +
         base::counted(worst->hexahedra, "hexahedron", "hexahedra");
}

// Gives the hexahedra their regions and returns those of the quads.
base::Array<std::int32_t> take_regions(const mesh::Mesh& input, std::span<const mesh::Quad> quads,
                                       const std::optional<hexmesh::RegionFigures>& regions, mesh::Mesh& cells,
                                       const base::Host& host) {
  base::Array<std::int32_t> of_quads(host.memory);
  if (input.regions.empty()) return of_quads;
  mesh::Mesh from(host.memory);
  from = input;
  const int exponent = mesh::bring_to_unit_size(from);
  base::Array<mesh::Vector3> positions(cells.positions, host.memory);
  mesh::scale_by_power(positions, exponent);
  base::Array<mesh::FacePlace> faces(host.memory);
  for (const mesh::Quad& quad : quads)
    faces.push_back(mesh::face_place(positions, quad));
  base::Array<mesh::Vector3> centers(host.memory);
  for (const mesh::Hexahedron& h : cells.hexahedra) {
    mesh::Vector3 center = mesh::Vector3::Zero();
    for (const mesh::Index v : h)
      center += positions[v] / 8;
    centers.push_back(center);
  }
  if (regions)
    cells.regions.hexahedra = regions->of_hexahedra;
  else
    cells.regions.hexahedra = mesh::nearest_cell_regions(from, centers, host);
  return mesh::nearest_face_regions(from, faces, host);
}

void report_regions(std::span<const std::int32_t> of_quads, std::span<const std::int32_t> of_hexahedra,
                    const std::optional<hexmesh::RegionFigures>& regions, Session& session) {
  const auto count = [&](std::span<const std::int32_t> regions) {
    return mesh::distinct_regions(regions, session.host().memory).size();
  };
  session.figures()["regions"] = {{"quadrilaterals", count(of_quads)}, {"hexahedra", count(of_hexahedra)}};
  if (!regions) return;
  if (regions->lost > 0)
    session.note("no hexahedron is in " + base::counted(regions->lost, "region") +
                 ", thinner than cells; raise --cells");
  else if (!regions->conforming && count(of_hexahedra) > 1)
    session.note("regions meet in steps along cells, since hexahedra would fold; more --cells may help");
  session.figures()["regions"].update(Json{{"conforming", regions->conforming},
                                           {"lost", regions->lost},
                                           {"quadrilaterals_between", regions->interface_quads},
                                           {"hausdorff_percent", regions->distance}});
}

// Why a mesh is no result; empty if it is one.
std::string shortfall(const HexOutput& output, const hexmesh::Hexahedra& made, double asked) {
  if (asked > 0 && !(std::max(made.result.distance, made.result.volume_error) <= far * asked))
    return figures_text(made.result) + ": more than twice --distance " + number(asked) +
           "; raise --cells and --max-cells, or --distance";
  if (output.strict && made.features && !made.features->missing.empty())
    return hexmesh::missing_text(*made.features, 3) + "; raise --cells and --max-cells, or --features auto";
  return {};
}

}  // namespace

void require_hex_output(const HexOutput& output) {
  require_cells_writable(output.path);
  if (output.glb.empty()) return;
  require_writable(output.glb);
  if (!is_gltf(output.glb))
    throw Failure(Exit::wrong_input, output.glb, "unsupported-format", "--glb needs one of " + gltf_endings);
}

void write_hexahedra(const HexOutput& output, const mesh::Mesh& input, hexmesh::Hexahedra made, double asked,
                     Session& session) {
  const base::Host& host = session.host();
  hexmesh::HexResult& result = made.result;
  const hexmesh::HexQuality& quality = result.quality;
  session.figures().update(figures_of(made));
  if (made.features) {
    session.figures()["features"] = json_of(*made.features);
    if (!made.features->missing.empty()) session.note(hexmesh::missing_text(*made.features, 3));
  }
  if (made.along_frames && made.along_frames->fields > 1)
    session.note("no map follows the smoothest field; that of the hexahedra is number " +
                 std::to_string(made.along_frames->fields));
  session.figures().update(Json{{"output", output.path},
                                {"vertices", result.mesh.positions.size()},
                                {"hexahedra", result.mesh.hexahedra.size()},
                                {"boundary_quads", result.mesh.quads.size()},
                                {"min_scaled_jacobian", quality.min_scaled_jacobian},
                                {"mean_scaled_jacobian", quality.mean_scaled_jacobian},
                                {"volume", in_range(quality.volume)},
                                {"off_surface", result.off_surface},
                                {"intersecting_quads", quality.intersections},
                                {"hausdorff_percent", result.distance},
                                {"volume_error_percent", result.volume_error}});
  session.figures()["by_piece"] = json_of(result.pieces, session.figures()["method"]);
  const std::string why = shortfall(output, made, asked);
  if (!why.empty() && !output.keep_partial)
    throw Failure(Exit::no_result, output.path, "no-valid-result", why + "; --keep-partial writes the mesh");
  if (!output.glb.empty()) {
    about(output.glb, Role::output, [&] {
      session.figures()["scene"] = write_hex_scene(session.stage(output.glb), result.mesh, output.cut,
                                                   std::filesystem::path(output.path).stem().string(), host);
      session.figures()["scene"]["output"] = output.glb;
    });
  }
  mesh::Mesh cells(host.memory);
  cells.positions = std::move(result.mesh.positions);
  cells.hexahedra = std::move(result.mesh.hexahedra);
  const base::Array<std::int32_t> of_quads = take_regions(input, result.mesh.quads, made.regions, cells, host);
  const std::span<const mesh::Quad> quads = of_quads.empty() ? std::span<const mesh::Quad>() : result.mesh.quads;
  report_regions(of_quads, cells.regions.hexahedra, made.regions, session);
  write_cells_exactly(output.path, cells, {.binary = !output.text, .quads = quads, .quad_regions = of_quads}, session);
  for (const std::string& note : session.notes())
    session.say("note: " + note);
  session.say("wrote " + output.path + ": " + base::counted(cells.hexahedra.size(), "hexahedron", "hexahedra") +
              ", certified: each is positive, and the boundary does not meet itself");
  session.say("  scaled Jacobians at least " + number(quality.min_scaled_jacobian) + ", " +
              number(quality.mean_scaled_jacobian) + " on average; " + besides(made));
  session.say("  " + figures_text(result));
  if (made.features) session.say("  " + features_text(*made.features));
  if (made.regions && made.regions->interface_quads > 0) session.say("  " + regions_text(*made.regions));
  if (result.pieces.size() > 1) session.say("  " + worst_piece_text(result));
  if (!why.empty()) {
    session.keep();
    throw Failure(Exit::no_result, output.path, "no-valid-result", why + "; the mesh is kept");
  }
  if (asked > 0 && std::max(result.distance, result.volume_error) > asked)
    session.say("  that is more than --distance " + number(asked) + "; more --cells may bring it closer");
}

}  // namespace orbicube::cli
