#include "files/sizing_file.h"

#include <string>

#include "base/counted.h"
#include "mesh/files/file.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::cli {

base::Array<tetrahedra::SizePoint> read_sizing(const std::filesystem::path& path,
                                               std::span<const mesh::Vector3> vertices, const base::Host& host) {
  const auto bytes = mesh::read_file(path, host);
  mesh::TextScanner in(bytes, '#', host);
  base::Array<tetrahedra::SizePoint> sizes(host.memory);
  bool places = false;  // as the first line has it
  for (; !in.at_end_of_file(); in.next_line()) {
    if (in.at_end_of_line()) continue;
    double length = in.coordinate("a length or a coordinate");
    if (sizes.empty()) places = !in.at_end_of_line();
    if (!places && sizes.size() == vertices.size()) {
      in.fail("trailing-data", "more lengths than the " + base::counted(vertices.size(), "vertex", "vertices"));
    }
    mesh::Vector3 position = places ? mesh::Vector3(length, 0, 0) : vertices[sizes.size()];
    if (places) {
      position[1] = in.coordinate("y");
      position[2] = in.coordinate("z");
      length = in.coordinate("a length");
    }
    if (!in.at_end_of_line()) in.fail("parse", places ? "more than x y z and a length" : "more than one length");
    if (!(length > 0)) in.fail("invalid-argument", "a length that is not positive");
    sizes.push_back({position, length});
    in.progress();
  }
  if (!places && sizes.size() < vertices.size()) {
    in.fail("truncated", base::counted(sizes.size(), "length") + ", where there are " +
                             base::counted(vertices.size(), "vertex", "vertices"));
  }
  return sizes;
}

}  // namespace orbicube::cli
