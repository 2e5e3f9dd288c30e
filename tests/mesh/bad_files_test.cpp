// The files of the folder bad/ of ORBICUBE_MODELS, but for glTF: each ends as its row of bad.tsv says; and the real
// models are read.
#include <doctest/doctest.h>

#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "bad_files.h"
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

}  // namespace

TEST_CASE("Each file of bad.tsv ends as its row says, within two seconds") {
  std::size_t checked = 0;
  const std::vector<test::BadFile> files = test::bad_files();
  for (const test::BadFile& file : files) {
    if (!format_of_path(file.name)) continue;
    CAPTURE(file.name);
    CAPTURE(file.kinds);
    const std::string ended = test::outcome_in_time(file, outcome_of);
    CAPTURE(ended);
    const std::string first_kind = file.kinds.substr(0, file.kinds.find(' '));
    const bool shape = !file.name.ends_with(".mesh") && kinds_of_shape.contains(first_kind) &&
                       !degenerate_as_files.contains(file.name);
    if (file.expected == "accept" || shape) {
      CHECK(ended == "accept");
    } else if (file.expected == "reject") {
      CHECK(file.has_kind(ended));
    } else {
      CHECK((ended == "accept" || file.has_kind(ended)));
    }
    ++checked;
  }
  CHECK((files.empty() || checked > 100));
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
