#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/files/binary_writer.h"
#include "mesh/files/float_positions.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

Vector3 normal_of(const Mesh& mesh, const Triangle& t) {
  const Vector3& p = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).stableNormalized();
}

}  // namespace

void write_stl(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  if (options.binary) {
    if (mesh.triangles.size() > UINT32_MAX) throw base::Error("unsupported", "more triangles than STL can count");
    require_float_resolution(mesh, "binary STL", "text STL, PLY and OBJ hold them");
    BinaryWriter out(file, std::endian::little, mesh.triangles.size(), host);
    std::array<char, 80> comment{};
    const std::string_view text = "binary STL";
    text.copy(comment.data(), text.size());
    out.put_text({comment.data(), comment.size()});
    out.put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
      for (const double x : normal_of(mesh, t))
        out.put(std::isfinite(x) ? static_cast<float>(x) : 0.0F);
      for (const Index v : t) {
        for (const double x : mesh.positions[v])
          out.put(to_float(x, "STL"));
      }
      out.put(std::uint16_t{0});
      out.end_item();
    }
    out.flush();
    return;
  }
  TextWriter out(file, mesh.triangles.size(), host);
  const auto triple = [&](const Vector3& x) { out << x.x() << ' ' << x.y() << ' ' << x.z() << '\n'; };
  out << "solid surface\n";
  for (const Triangle& t : mesh.triangles) {
    const Vector3 normal = normal_of(mesh, t);
    out << "facet normal ";
    triple(normal.allFinite() ? normal : Vector3(Vector3::Zero()));
    out << "outer loop\n";
    for (const Index v : t) {
      out << "vertex ";
      triple(mesh.positions[v]);
    }
    out << "endloop\nendfacet\n";
    out.end_item();
  }
  out << "endsolid surface\n";
  out.flush();
}

}  // namespace orbicube::mesh
