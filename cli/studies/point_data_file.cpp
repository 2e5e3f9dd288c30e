#include "studies/point_data_file.h"

#include <bit>
#include <cstdint>

#include "mesh/files/binary_writer.h"

namespace orbicube::cli {

void write_point_data(const std::filesystem::path& path, const mesh::Mesh& surface, const std::vector<PointData>& data,
                      Session& session) {
  about(path, Role::output, [&] {
    base::OutputFile file(session.stage(path));
    const std::size_t points = surface.positions.size(), triangles = surface.triangles.size();
    mesh::BinaryWriter out(file, std::endian::big, points * (1 + data.size()) + triangles, session.host());
    out.put_text("# vtk DataFile Version 3.0\nsurface with values of its points\nBINARY\nDATASET POLYDATA\nPOINTS " +
                 std::to_string(points) + " double\n");
    for (const mesh::Vector3& p : surface.positions) {
      for (const double x : p)
        out.put(x);
      out.end_item();
    }
    out.put_text("\nPOLYGONS " + std::to_string(triangles) + " " + std::to_string(4 * triangles) + "\n");
    for (const mesh::Triangle& t : surface.triangles) {
      out.put(std::int32_t{3});
      for (const mesh::Index v : t)
        out.put(static_cast<std::int32_t>(v));
      out.end_item();
    }
    out.put_text("\nPOINT_DATA " + std::to_string(points) + "\n");
    for (const PointData& of_points : data) {
      out.put_text(of_points.vectors ? "VECTORS " + of_points.name + " double\n"
                                     : "SCALARS " + of_points.name + " double 1\nLOOKUP_TABLE default\n");
      const std::size_t components = of_points.vectors ? 3 : 1;
      for (std::size_t i = 0; i < of_points.values.size(); ++i) {
        out.put(of_points.values[i]);
        if (i % components == 0) out.end_item();
      }
      out.put_text("\n");
    }
    out.flush();
    file.commit();
  });
}

}  // namespace orbicube::cli
