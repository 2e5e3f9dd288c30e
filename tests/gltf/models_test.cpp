// The files of the folder bad/ of ORBICUBE_MODELS: each ends as bad.tsv says.
#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "made_files.h"
#include "tests/mesh/bad_files.h"

using namespace orbicube;

namespace {

std::string outcome_of(const std::filesystem::path& path) {
  try {
    const mesh::Mesh surface = gltf::read(path, {}, base::Host());
    return surface.triangles.empty() ? "no triangles" : "accept";
  } catch (const base::Error& error) {
    return error.kind();
  }
}

}  // namespace

TEST_CASE("Each glTF file of bad.tsv ends as its row says, within two seconds") {
  int rows = 0;
  const std::vector<test::BadFile> files = test::bad_files();
  for (const test::BadFile& file : files) {
    if (!file.name.ends_with(".glb") && !file.name.ends_with(".gltf")) continue;
    ++rows;
    CAPTURE(file.name);
    CAPTURE(file.kinds);
    const std::string outcome = test::outcome_in_time(file, outcome_of);
    CAPTURE(outcome);
    CHECK((file.has_kind(outcome) || (file.expected != "reject" && outcome == "accept")));
  }
  CHECK((files.empty() || rows > 80));
}

TEST_CASE("The same surface in every encoding of the models folder is read alike") {
  const char* const models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(models) / "bad";
  const mesh::Mesh expected = gltf::read(folder / "ok-u16.glb", {}, base::Host());
  for (const char* name : {"ok-u8.glb", "ok-u32.glb", "ok-sparse.glb", "ok-interleaved.glb", "ok-base64.gltf",
                           "ok-base64-gltf-buffer.gltf", "ok-external.gltf"}) {
    CAPTURE(name);
    const mesh::Mesh surface = gltf::read(folder / name, {}, base::Host());
    CHECK(surface.positions == expected.positions);
    CHECK(surface.triangles == expected.triangles);
  }
}
