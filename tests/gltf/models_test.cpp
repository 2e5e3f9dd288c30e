// The files of the folder bad/ of ORBICUBE_MODELS: each ends as bad.tsv says.
#include <doctest/doctest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "made_files.h"

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
  const char* const models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(models) / "bad";
  std::ifstream table(folder / "bad.tsv");
  REQUIRE(table.good());
  int rows = 0;
  for (std::string line; std::getline(table, line);) {
    std::istringstream cells(line);
    std::string name, expected, kinds;
    std::getline(cells, name, '\t');
    std::getline(cells, expected, '\t');
    std::getline(cells, kinds, '\t');
    if (!name.ends_with(".glb") && !name.ends_with(".gltf")) continue;
    ++rows;
    std::set<std::string> allowed;
    if (expected != "reject") allowed.insert("accept");
    std::istringstream words(kinds);
    for (std::string word; words >> word;) {
      if (word != "or" && word.front() != '(') allowed.insert(word);
    }
    const std::clock_t start = std::clock();  // of the processor: the machine may have other things to do
    const std::string outcome = outcome_of(folder / name);
    const std::clock_t taken = std::clock() - start;
    CAPTURE(name);
    CAPTURE(kinds);
    CAPTURE(outcome);
    CHECK(allowed.contains(outcome));
    CHECK(taken < 2 * CLOCKS_PER_SEC);
  }
  CHECK(rows > 80);
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
