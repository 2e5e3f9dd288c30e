#include "report/sphere_uses.h"

#include <Eigen/Geometry>
#include <cctype>
#include <filesystem>
#include <utility>

#include "base/counted.h"
#include "files/surface_file.h"
#include "mesh/search/distances.h"
#include "mesh/search/measures.h"
#include "report/embedding.h"
#include "report/grid_choice.h"
#include "report/text.h"
#include "report/unit_size.h"
#include "sphere_map/sampling/geometry_image.h"
#include "sphere_map/sampling/locator.h"
#include "sphere_map/sampling/sampling.h"

namespace orbicube::cli {
namespace {

sphere_map::ImageLayout layout_of(const GridChoice& choice) {
  if (choice.kind == sphere_map::GridKind::octahedron) return sphere_map::ImageLayout::octahedron;
  if (choice.kind == sphere_map::GridKind::cube) return sphere_map::ImageLayout::cube;
  throw Failure(Exit::wrong_input, "", "usage", "--image-grid: images are of an octahedron or a cube");
}

// Of lengths times 2^exponent.
Json json_of(const mesh::Distances& d, double diagonal, int exponent) {
  return {{"mean", unscaled(d.mean, -exponent)},
          {"rms", unscaled(d.root_mean_square, -exponent)},
          {"max", unscaled(d.largest, -exponent)},
          {"rms_of_diagonal", d.root_mean_square / diagonal},
          {"max_of_diagonal", d.largest / diagonal}};
}

std::string told(const Json& distance) {
  const auto part = [&](const char* way) {
    return number(100 * distance[way]["max_of_diagonal"].get<double>()) + " % (root mean square " +
           number(100 * distance[way]["rms_of_diagonal"].get<double>()) + " %)";
  };
  return "at most " + part("from_surface") + " of the diagonal from the surface to it, " + part("to_surface") + " back";
}

void write_remesh(const SphereUses& uses, const sphere_map::Locator& locator, const mesh::Mesh& surface,
                  Session& session) {
  const base::Host& host = session.host();
  const GridChoice choice = grid_choice(uses.grid, "--grid");
  const double start = session.seconds();
  sphere_map::Grid grid = sphere_map::make_grid(choice.kind, choice.resolution, host);
  mesh::Mesh remeshed(host.memory);
  remeshed.positions =
      sphere_map::sample_vectors(locator, grid.directions, surface.positions, sphere_map::Interpolation::linear, host);
  remeshed.triangles = std::move(grid.triangles);
  write_output(uses.remesh, remeshed, true, session);
  const double written = session.seconds() - start;
  const Json distance = json_of_distance(surface, remeshed, host);
  session.figures()["remesh"] = {{"output", uses.remesh},
                                 {"grid", name_of(choice)},
                                 {"vertices", remeshed.positions.size()},
                                 {"triangles", remeshed.triangles.size()},
                                 {"distance", distance},
                                 {"seconds", written}};
  const std::string note =
      report_intersections(uses.remesh, remeshed.positions, remeshed.triangles,
                           "a finer --grid follows the surface more closely", session.figures()["remesh"], session);
  session.say("wrote " + uses.remesh + ": the surface on " + name_of(choice) + ", " +
              base::counted(remeshed.triangles.size(), "triangle"));
  session.say("  " + told(distance));
  if (!note.empty()) session.say("  note: " + note);
}

void write_image(const SphereUses& uses, const sphere_map::Locator& locator, const mesh::Mesh& surface,
                 Session& session) {
  const base::Host& host = session.host();
  const GridChoice choice = grid_choice(uses.image_grid, "--image-grid");
  const sphere_map::GeometryImage image =
      sphere_map::make_geometry_image(locator, surface.positions, layout_of(choice), choice.resolution, host);
  // What is reported is about the file, as it is read again.
  const sphere_map::ImageSurface back = about(uses.image, Role::output, [&] {
    const std::filesystem::path file = session.stage(uses.image);
    sphere_map::write_geometry_image(file, image, host);
    return sphere_map::surface_of(sphere_map::read_geometry_image(file, host), host);
  });
  const Json distance = json_of_distance(surface, back.mesh, host);
  session.figures()["image"] = {{"output", uses.image},   {"grid", name_of(choice)},   {"width", image.width},
                                {"height", image.height}, {"seam_gap", back.seam_gap}, {"distance", distance}};
  const std::string note = report_intersections(uses.image, back.mesh.positions, back.mesh.triangles,
                                                "a finer --image-grid follows the surface more closely",
                                                session.figures()["image"], session);
  session.say("wrote " + uses.image + ": the surface as an image of " + std::to_string(image.width) + " x " +
              base::counted(image.height, "pixel"));
  session.say("  " + told(distance));
  if (!note.empty()) session.say("  note: " + note);
}

}  // namespace

Json json_of_distance(const mesh::Mesh& first, const mesh::Mesh& second, const base::Host& host) {
  // At a size near 1, where squares neither overflow nor vanish: powers of two change no digit.
  const int exponent = mesh::unit_scale_exponent(first.positions, first.triangles);
  base::Array<mesh::Vector3> one(first.positions, host.memory), other(second.positions, host.memory);
  mesh::scale_by_power(one, exponent);
  mesh::scale_by_power(other, exponent);
  const mesh::Measures box = mesh::measures(one, first.triangles, host);
  const double diagonal = (box.high - box.low).norm();
  const mesh::SurfaceDistance d = mesh::surface_distance(one, first.triangles, other, second.triangles, host);
  return {{"diagonal", unscaled(diagonal, -exponent)},
          {"from_surface", json_of(d.from_first, diagonal, exponent)},
          {"to_surface", json_of(d.from_second, diagonal, exponent)}};
}

void add_sphere_uses(CLI::App& verb, SphereUses& uses) {
  verb.add_option("--remesh", uses.remesh, "write the surface sampled on a regular grid of the sphere")
      ->type_name("FILE");
  verb.add_option("--grid", uses.grid, std::string("grid of --remesh [default: icosphere:6]: ") + grid_help)
      ->type_name("GRID");
  verb.add_option("--image", uses.image, "write the surface as a geometry image: .png (16 bits) or .pfm (float32)")
      ->type_name("FILE");
  verb.add_option("--image-grid", uses.image_grid, "grid of --image, octahedron:N or cube:N [default: octahedron:256]")
      ->type_name("GRID");
}

void check_sphere_uses(const SphereUses& uses) {
  grid_choice(uses.grid, "--grid");
  layout_of(grid_choice(uses.image_grid, "--image-grid"));
  if (!uses.remesh.empty()) require_writable(uses.remesh);
  if (uses.image.empty()) return;
  std::string ending = std::filesystem::path(uses.image).extension().string();
  for (char& c : ending)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending != ".png" && ending != ".pfm")
    throw Failure(Exit::wrong_input, uses.image, "unsupported-format", "geometry images end in .png or .pfm");
}

void write_sphere_uses(const SphereUses& uses, const mesh::Mesh& surface, std::span<const mesh::Vector3> directions,
                       Session& session) {
  if (uses.remesh.empty() && uses.image.empty()) return;
  const sphere_map::Locator locator(surface.triangles, directions, session.host());
  if (!uses.remesh.empty()) write_remesh(uses, locator, surface, session);
  if (!uses.image.empty()) write_image(uses, locator, surface, session);
}

}  // namespace orbicube::cli
