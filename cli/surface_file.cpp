#include "surface_file.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "base/error.h"
#include "gltf/read.h"
#include "gltf/write.h"
#include "mesh/write.h"

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
  // Far from the origin, float32 would lose more than a millionth of the size: the node moves it there instead.
  const bool far = low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff() > 16 * (high - low).maxCoeff();
  const mesh::Vector3 origin = far ? mesh::Vector3(0.5 * low + 0.5 * high) : mesh::Vector3(mesh::Vector3::Zero());
  base::Array<float> positions(host.memory);
  positions.reserve(3 * mesh.positions.size());
  for (const mesh::Vector3& p : mesh.positions) {
    for (const double coordinate : mesh::Vector3(p - origin))
      positions.push_back(static_cast<float>(coordinate));
  }
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = mesh.triangles;
  scene.smooth_normals = true;
  scene.translation = origin;
  scene.name = path.stem().string();
  gltf::write(path, scene, host);
}

// In small letters.
std::string ending_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

}  // namespace

bool is_gltf(const std::filesystem::path& path) {
  const std::string ending = ending_of(path);
  return ending == ".glb" || ending == ".gltf";
}

bool is_json(const std::filesystem::path& path) {
  return ending_of(path) == ".json";
}

InputMesh read_input(const std::filesystem::path& path, bool weld, Session& session) {
  InputMesh input;
  const double start = session.seconds();
  input.mesh = about(path, Role::input, [&] {
    if (is_gltf(path)) return gltf::read(path, {}, session.host(), &input.report);
    return mesh::read_mesh(path, {.weld_identical = weld}, session.host(), &input.report);
  });
  input.seconds = session.seconds() - start;
  if (input.report.polygons > 0)
    session.note(std::to_string(input.report.polygons) + " polygons were cut into triangles");
  if (input.report.welded_vertices > 0)
    session.note(std::to_string(input.report.welded_vertices) + " vertices were joined to others at the same position");
  for (const std::string& note : input.report.notes)
    session.note(note);
  return input;
}

void require_writable(const std::filesystem::path& path) {
  if (!is_gltf(path) && !mesh::format_of_path(path)) {
    throw Failure(Exit::wrong_input, path.string(), "unsupported-format",
                  std::string("the ending must be one of ") + surface_endings);
  }
  require_folder(path);
}

void require_folder(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code problem;
  if (!std::filesystem::is_directory(folder, problem)) {
    throw Failure(Exit::wrong_input, path.string(), "io", "there is no folder " + folder.string());
  }
}

void write_output(const std::filesystem::path& path, const mesh::Mesh& mesh, bool binary, const base::Host& host) {
  about(path, Role::output, [&] {
    if (is_gltf(path)) {
      write_gltf(path, mesh, host);
    } else {
      mesh::write_mesh(path, mesh, {.binary = binary}, host);
    }
  });
}

}  // namespace orbicube::cli
