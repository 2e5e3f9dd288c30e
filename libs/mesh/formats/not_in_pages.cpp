// In place of read_msh.cpp and write_msh.cpp in the module for web pages, which has to stay small.
#include "base/error.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

constexpr const char* left_out = "files of Gmsh are not part of the module for web pages";

}  // namespace

Mesh read_msh(std::span<const std::byte>, const base::Host&, ReadReport&) {
  throw base::Error("unsupported", left_out);
}

void write_msh(OutputFile&, const Mesh&, const WriteOptions&, const base::Host&) {
  throw base::Error("unsupported", left_out);
}

}  // namespace orbicube::mesh
