// The files of the folder bad/ of ORBICUBE_MODELS, but for glTF: each ends as its row of bad.tsv says; and the real
// models are read.
#include <doctest/doctest.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <set>
#include <sstream>

#include "mesh/topology/topology.h"
#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

// Kinds of shape, which a reader of surfaces has no part in: the file is read.
const std::set<std::string> kinds_of_shape = {"not-closed",          "non-manifold-edge", "non-manifold-vertex",
                                              "not-connected",       "duplicate-face",    "inconsistent-orientation",
                                              "non-orientable",      "wrong-genus",       "degenerate-face",
                                              "degenerate-geometry", "degenerate"};
// Where a degenerate face is one that a mesh of triangles cannot hold.
const std::set<std::string> degenerate_as_files = {"polygon-repeated-vertex.off"};

std::string outcome_of(const std::filesystem::path& path) {
  try {
    const Mesh mesh = read_mesh(path, {}, base::Host());
    return mesh.positions.empty() ? "no positions" : "accept";
  } catch (const base::Error& error) {
    return error.kind();
  }
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream text(line);
  for (std::string field; std::getline(text, field, '\t');)
    fields.push_back(field);
  return fields;
}

bool mentions(const std::string& text, const std::string& word) {
  std::istringstream words(text);
  for (std::string w; words >> w;) {
    if (w == word) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("Each file of bad.tsv ends as its row says, within two seconds") {
  const char* const models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return;
  }
  const std::filesystem::path folder = std::filesystem::path(models) / "bad";
  std::ifstream table(folder / "bad.tsv");
  std::string line;
  std::getline(table, line);
  std::size_t checked = 0;
  while (std::getline(table, line)) {
    const auto row = fields_of(line);
    REQUIRE(row.size() >= 3);
    const std::string &file = row[0], &expected = row[1], &kind = row[2];
    if (!format_of_path(file)) continue;
    CAPTURE(line);
    const std::clock_t start = std::clock();  // of the processor: the machine may have other things to do
    const std::string ended = outcome_of(folder / file);
    CHECK(std::clock() - start < 2 * CLOCKS_PER_SEC);
    CAPTURE(ended);
    const std::string first_kind = kind.substr(0, kind.find(' '));
    const bool shape =
        !file.ends_with(".mesh") && kinds_of_shape.contains(first_kind) && !degenerate_as_files.contains(file);
    if (expected == "accept" || shape) {
      CHECK(ended == "accept");
    } else if (expected == "reject") {
      CHECK(mentions(kind, ended));
    } else {
      CHECK((ended == "accept" || mentions(kind, ended)));
    }
    ++checked;
  }
  CHECK(checked > 100);
}

TEST_CASE("The real models are read, and what is written of them is read again") {
  const char* const models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return;
  }
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(models)) {
    const std::string folder = entry.path().parent_path().filename().string();
    if (folder == "bad" || folder == "cases" || !format_of_path(entry.path())) continue;  // these are made to be odd
    CAPTURE(entry.path());
    const Mesh mesh = read_mesh(entry.path(), {}, base::Host());
    CHECK(mesh.positions.size() > 3);
    CHECK(mesh.triangles.size() + mesh.tetrahedra.size() + mesh.hexahedra.size() > 3);
    ++read;
  }
  CHECK(read >= 26);
}
