#include "files/surface_file.h"

#include <string>
#include <vector>

#include "base/counted.h"
#include "base/error.h"
#include "gltf/reading/read.h"
#include "gltf/writing/float_frame.h"
#include "gltf/writing/write.h"
#include "mesh/files/text_scanner.h"
#include "mesh/files/write.h"

namespace orbicube::cli {
namespace {

void write_gltf(const std::filesystem::path& path, const mesh::Mesh& mesh, const base::Host& host) {
  if (!mesh.tetrahedra.empty() || !mesh.hexahedra.empty()) {
    throw base::Error("unsupported", "glTF holds no tetrahedra or hexahedra, only surfaces");
  }
  if (mesh.triangles.empty()) throw base::Error("empty-mesh", "there are no triangles to write");
  mesh::Vector3 low = mesh.positions[0];
  mesh::Vector3 high = low;
  for (const mesh::Vector3& p : mesh.positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const gltf::FloatFrame frame = gltf::float_frame(low, high);
  const base::Array<float> positions = gltf::stored_positions(mesh.positions, frame, host.memory);
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = mesh.triangles;
  scene.smooth_normals = true;
  scene.translation = frame.translation;
  scene.scale = frame.scale;
  scene.name = path.stem().string();
  gltf::write(path, scene, host);
}

void require_known_ending(const std::filesystem::path& path) {
  if (is_gltf(path) || mesh::format_of_path(path)) return;
  throw Failure(Exit::wrong_input, path.string(), "unsupported-format",
                "the ending " + mesh::in_quotes(path.extension().string()) + " is none of " + surface_endings);
}

}  // namespace

bool is_gltf(const std::filesystem::path& path) {
  return gltf::form_of_path(path).has_value();
}

bool is_json(const std::filesystem::path& path) {
  return mesh::ending_of(path) == ".json";
}

Keep keep_for(const std::filesystem::path& output, Keep wanted) {
  return is_gltf(output) ? wanted : Keep::surface;
}

InputMesh read_input(const std::filesystem::path& path, bool weld, Session& session, Keep keep, bool tags) {
  require_known_ending(path);
  InputMesh input;
  const double start = session.seconds();
  input.mesh = about(path, Role::input, [&] {
    if (is_gltf(path)) {
      std::unique_ptr<gltf::Kept> kept;
      mesh::Mesh surface = gltf::read(path, {}, session.host(), &input.report, keep == Keep::surface ? nullptr : &kept);
      input.kept = std::move(kept);
      return surface;
    }
    return mesh::read_mesh(path, {.weld_identical = weld, .feature_tags = tags}, session.host(), &input.report);
  });
  input.seconds = session.seconds() - start;
  if (input.kept && keep == Keep::file) return input;  // nothing is changed
  if (input.kept && !input.kept->replaced.empty()) session.note(input.kept->replaced);
  if (input.report.polygons > 0)
    session.note(base::counted(input.report.polygons, "polygon was", "polygons were") + " cut into triangles");
  // The reader of glTF says why as well.
  if (input.report.welded_vertices > 0 && !is_gltf(path))
    session.note(base::counted(input.report.welded_vertices, "vertex was", "vertices were") +
                 " welded to others at the same position");
  for (const std::string& note : input.report.notes)
    session.note(note);
  return input;
}

void require_writable(const std::filesystem::path& path) {
  require_known_ending(path);
  require_folder(path);
}

void require_cells_writable(const std::filesystem::path& path) {
  if (!mesh::holds(path, mesh::Holds::cells)) {
    throw Failure(Exit::wrong_input, path.string(), "unsupported-format",
                  "tetrahedra and hexahedra are written to " + cell_endings);
  }
  require_folder(path);
}

void require_float_range(const std::filesystem::path& path, std::span<const mesh::Vector3> positions,
                         std::span<const mesh::Triangle> triangles) {
  if (!is_gltf(path) || triangles.empty()) return;
  mesh::Vector3 low = positions[triangles[0][0]];
  mesh::Vector3 high = low;
  for (const mesh::Triangle& t : triangles) {
    for (const mesh::Index v : t) {
      low = low.cwiseMin(positions[v]);
      high = high.cwiseMax(positions[v]);
    }
  }
  about(path, Role::output, [&] { gltf::float_frame(low, high); });
}

void require_folder(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code problem;
  if (!std::filesystem::is_directory(folder, problem)) {
    throw Failure(Exit::wrong_input, path.string(), "io", "there is no folder " + folder.string());
  }
  static_cast<void>(std::filesystem::symlink_status(path, problem));
  if (problem == std::errc::filename_too_long)
    throw Failure(Exit::wrong_input, path.string(), "io", "cannot write: " + problem.message());
}

void write_output(const std::filesystem::path& path, const gltf::Kept& kept, Session& session) {
  about(path, Role::output, [&] { gltf::write(session.stage(path), kept, session.host()); });
}

void write_output(const std::filesystem::path& path, const mesh::Mesh& mesh, bool binary, Session& session) {
  if (!mesh.regions.empty() && !mesh::holds(path, mesh::Holds::regions)) {
    session.note("region numbers were left out: " + mesh::format_endings(mesh::Holds::regions) + " hold them");
  }
  about(path, Role::output, [&] {
    const std::filesystem::path file = session.stage(path);
    if (is_gltf(path)) {
      write_gltf(file, mesh, session.host());
    } else {
      mesh::write_mesh(file, mesh, {.binary = binary}, session.host());
    }
  });
}

}  // namespace orbicube::cli
