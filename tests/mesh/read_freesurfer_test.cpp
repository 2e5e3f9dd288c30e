// The reader of FreeSurfer's surfaces: both forms, the offset to the scanner's space, and what is refused.
#include <doctest/doctest.h>

#include <bit>

#include "read_text.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

void put(std::string& bytes, std::uint32_t number) {
  for (unsigned shift = 32; shift > 0; shift -= 8)
    bytes += static_cast<char>(number >> (shift - 8) & 0xFFU);
}

std::string file_of(std::uint32_t vertices, std::uint32_t triangles, const std::vector<float>& positions,
                    const std::vector<std::uint32_t>& corners) {
  std::string bytes =
      "\xFF\xFF\xFE"
      "created by someone on Fri Nov 27\n\n";
  put(bytes, vertices);
  put(bytes, triangles);
  for (const float x : positions)
    put(bytes, std::bit_cast<std::uint32_t>(x));
  for (const std::uint32_t v : corners)
    put(bytes, v);
  return bytes;
}

const std::vector<float> corner = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1.5F};
const std::vector<std::uint32_t> closed = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};

}  // namespace

TEST_CASE("FreeSurfer: binary and text files have the same mesh, with each ending of its surfaces") {
  ReadReport report;
  const Mesh mesh = read_text(Format::freesurfer, file_of(4, 4, corner, closed), {}, &report);
  CHECK(report.format == "FreeSurfer, binary");
  CHECK(report.notes.empty());
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.positions[3] == Vector3(0, 0, 1.5));
  CHECK(mesh.triangles == Array<Triangle>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
  const Mesh text = read_text(Format::freesurfer,
                              "#!ascii version of lh.white\n4 4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0.0 0.0 1.5 0\n"
                              "0 2 1 0\n0 1 3 0\n1 2 3 0\n0 3 2 0\n",
                              {}, &report);
  CHECK(report.format == "FreeSurfer, text");
  CHECK(text.positions == mesh.positions);
  CHECK(text.triangles == mesh.triangles);
  for (const char* name : {"lh.white", "rh.pial", "lh.sphere", "lh.sphere.reg", "rh.inflated", "lh.ORIG"})
    CHECK(format_of_path(name) == Format::freesurfer);
}

TEST_CASE("FreeSurfer: the offset to the scanner's space is noted, and coordinates are kept") {
  const auto read = [](const std::string& text) {
    std::string bytes = file_of(4, 4, corner, closed);
    for (const std::uint32_t number : {2U, 0U, 20U})
      put(bytes, number);
    ReadReport report;
    const Mesh mesh = read_text(Format::freesurfer, bytes + text, {}, &report);
    CHECK(mesh.positions[1] == Vector3(1, 0, 0));
    return report.notes;
  };
  const std::string geometry = "filename = T1.mgz\nvoxelsize = 1 1 1\nxras   = -1 0 0\n";
  const auto notes = read("valid = 1  # volume info valid\n" + geometry + "cras   = -1.5 2e0 3\n");
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].find("c_ras = -1.5 2e0 3,") != std::string::npos);
  CHECK(read("valid = 1\n" + geometry + "cras   = 0.0 0.0 0\n").empty());
  CHECK(read("valid = 0\n" + geometry + "cras   = 1 2 3\n").empty());
  CHECK(read("valid = 1\ncras   = \x01\n").empty());
  CHECK(read("valid = 1\ncras").empty());
}

TEST_CASE("FreeSurfer: what cannot be read is refused") {
  constexpr Format format = Format::freesurfer;
  CHECK(ends_as(format, "solid\n", "bad-magic"));
  CHECK(ends_as(format, "\xFF\xFF\xFF", "unsupported-version", "mris_convert"));
  CHECK(ends_as(format,
                "\xFF\xFF\xFE"
                "created\nno empty line\n",
                "parse"));
  CHECK(ends_as(format, file_of(0x80000000U, 4, corner, closed), "parse", "negative"));
  CHECK(ends_as(format, file_of(4, 0x7FFFFFFFU, corner, closed), "truncated"));
  CHECK(ends_as(format, file_of(4, 4, corner, {0, 2, 1, 0, 1, 4, 1, 2, 3, 0, 3, 2}), "index-range", "4 of 4"));
  CHECK(ends_as(format, file_of(4, 4, {std::nanf(""), 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, closed), "non-finite"));
  CHECK(ends_as(format, file_of(0, 0, {}, {}), "empty-mesh"));
  CHECK(ends_as(format, "#!ascii\n1000000 1\n0 0 0 0\n", "truncated"));
  CHECK(ends_as(format, "#!ascii\n3 1\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 1 3 0\n", "index-range"));
}
