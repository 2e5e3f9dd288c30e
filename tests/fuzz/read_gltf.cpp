// The glTF reader on arbitrary bytes (libFuzzer), GLB and text by their content. It may answer with a surface or with
// an Error of a known kind; a surface must be one that the rest of the tree can trust, and what is written of it must
// be read again.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <vector>

#include "base/error.h"
#include "gltf/reading/read.h"
#include "gltf/writing/write.h"

using namespace orbicube;

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void require_sound(const mesh::Mesh& surface) {
  require(!surface.triangles.empty(), "a surface without triangles");
  for (const mesh::Vector3& p : surface.positions)
    require(p.allFinite(), "a position that is not finite");
  for (const mesh::Triangle& triangle : surface.triangles) {
    for (const mesh::Index v : triangle)
      require(v < surface.positions.size(), "a triangle with a vertex that does not exist");
  }
}

// Writes the surface, in floats, and reads it again.
void require_round_trip(const mesh::Mesh& surface, const base::Host& host) {
  std::vector<float> positions;
  for (const mesh::Vector3& p : surface.positions) {
    for (const double x : p) {
      if (!(std::abs(x) < 1e38)) return;  // no float
      positions.push_back(static_cast<float>(x));
    }
  }
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = surface.triangles;
  gltf::ReadOptions as_stored;
  as_stored.weld_identical = false;
  const mesh::Mesh again = gltf::read(gltf::to_bytes(scene, gltf::Form::glb, host), {}, as_stored, host);
  require(again.triangles == surface.triangles, "triangles changed on their way through a file");
  require(again.positions.size() == surface.positions.size(), "vertices were lost on their way through a file");
}

std::vector<float> to_floats(const mesh::Mesh& surface) {
  std::vector<float> positions;
  for (const mesh::Vector3& p : surface.positions) {
    for (const double x : p)
      positions.push_back(std::abs(x) < 1e38 ? static_cast<float>(x) : 0.0F);
  }
  return positions;
}

// Reads with everything else in the file, writes both ways, and reads again.
void require_kept(std::span<const std::byte> bytes, const base::Host& host) {
  std::unique_ptr<gltf::Kept> kept;
  mesh::ReadReport report;
  const mesh::Mesh surface = gltf::read(bytes, {}, {}, host, &report, &kept);
  if (!kept) return;
  const mesh::Mesh whole = gltf::read(gltf::to_bytes(*kept, gltf::Form::glb, host), {}, {}, host);
  require(whole.positions == surface.positions && whole.triangles == surface.triangles,
          "the surface is another in a file with everything");
  const std::vector<float> positions = to_floats(surface);
  gltf::Scene scene;
  scene.positions = positions;
  scene.triangles = surface.triangles;
  scene.smooth_normals = true;
  scene.kept = kept.get();
  gltf::ReadOptions as_stored;
  as_stored.weld_identical = false;
  const mesh::Mesh again = gltf::read(gltf::to_bytes(scene, gltf::Form::gltf, host), {}, as_stored, host);
  require(again.triangles.size() == surface.triangles.size(), "triangles were lost with what was kept");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes(reinterpret_cast<const std::byte*>(data), size);
  const base::Host host;
  try {
    require_kept(bytes, host);
  } catch (const base::Error& error) {
    require(error.status() != base::Status::internal, "an error of a kind that is in no table");
  }
  for (const char* morph_target : {"", "sphere"}) {
    gltf::ReadOptions options;
    options.weld_identical = *morph_target == '\0';
    options.morph_target = morph_target;
    try {
      mesh::ReadReport report;
      const mesh::Mesh surface = gltf::read(bytes, {}, options, host, &report);
      require_sound(surface);
      require(!report.format.empty(), "a report without a format");
      require_round_trip(surface, host);
    } catch (const base::Error& error) {
      require(error.status() != base::Status::internal, "an error of a kind that is in no table");
      require(error.what()[0] != '\0', "an error without a message");
    }
  }
  return 0;
}
