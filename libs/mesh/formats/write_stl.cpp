#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/files/binary_writer.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/codecs.h"

namespace orbicube::mesh {
namespace {

Vector3 normal_of(const Mesh& mesh, const Triangle& t) {
  const Vector3& p = mesh.positions[t[0]];
  return (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).stableNormalized();
}

float rounded(double x) {
  const auto result = static_cast<float>(x);
  if (!std::isfinite(result))
    throw base::Error("unsupported", "a coordinate is too large for float32, which STL holds");
  return result;
}

// Refuses what float32 would make another surface of: far from the origin, or tiny, where numbers become 0.
void require_float_resolution(const Mesh& mesh) {
  if (mesh.triangles.empty()) return;
  Vector3 low = mesh.positions[mesh.triangles[0][0]], high = low;
  double moved = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) {
      low = low.cwiseMin(mesh.positions[v]);
      high = high.cwiseMax(mesh.positions[v]);
      for (const double x : mesh.positions[v])
        moved = std::max(moved, std::abs(x - static_cast<double>(rounded(x))));
    }
  }
  constexpr double visible = 1e-3;  // of the size; what is just seen in a picture
  const double size = 2 * (0.5 * high - 0.5 * low).maxCoeff();
  if (moved <= visible * size) return;
  throw base::Error("unsupported", "float32, which binary STL holds, would move vertices by " +
                                       std::to_string(std::lround(std::min(100.0, 100 * moved / size))) +
                                       " % of the size; text STL, PLY and OBJ hold them");
}

}  // namespace

void write_stl(OutputFile& file, const Mesh& mesh, const WriteOptions& options, const base::Host& host) {
  if (options.binary) {
    if (mesh.triangles.size() > UINT32_MAX) throw base::Error("unsupported", "more triangles than STL can count");
    require_float_resolution(mesh);
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
          out.put(rounded(x));
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
