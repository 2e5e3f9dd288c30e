// Meshes, their files, topology and searches; wraps orbicube/mesh.h.
//
//   orbicube::Mesh mesh = orbicube::Mesh::read("scan.ply");
//   auto report = orbicube::mesh::topology(mesh);
#ifndef ORBICUBE_MESH_HPP
#define ORBICUBE_MESH_HPP

#include <array>
#include <vector>

#include <orbicube/mesh.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {

// A surface that lies elsewhere: in arrays, or in a Mesh.
struct Surface : obc_surface {
  Surface() : obc_surface() {}
  Surface(const obc_surface& surface) : obc_surface(surface) {}
  Surface(Doubles places, Indices corners) : obc_surface() {
    positions = places.data();
    vertex_count = detail::rows(places.size(), 3, "positions");
    triangles = corners.data();
    triangle_count = detail::rows(corners.size(), 3, "triangles");
  }
};

// A mesh in the library's memory.
class Mesh {
 public:
  using ReadOptions = detail::Filled<obc_mesh_read_options, obc_mesh_read_options_init>;
  using WriteOptions = detail::Filled<obc_mesh_write_options, obc_mesh_write_options_init>;
  using Cells = detail::Filled<obc_mesh_cells, obc_mesh_cells_init>;  // views of the caller's arrays

  explicit Mesh(obc_mesh* owned) noexcept : handle_(owned) {}
  explicit Mesh(const Cells& cells, Host* host = nullptr)
      : Mesh(made(host, [&](obc_mesh** out, obc_error* error) {
          return obc_mesh_create(&cells, detail::c(host), out, error);
        })) {}
  // A closed surface by name.
  static Mesh make(const std::string& shape, std::size_t triangles, std::uint64_t seed = 0, Host* host = nullptr) {
    return Mesh(made(host, [&](obc_mesh** out, obc_error* error) {
      return obc_mesh_make(shape.c_str(), triangles, seed, detail::c(host), out, error);
    }));
  }
  static Mesh read(const std::string& path, const ReadOptions& options = {}, Host* host = nullptr) {
    return Mesh(made(host, [&](obc_mesh** out, obc_error* error) {
      return obc_mesh_read(path.c_str(), &options, detail::c(host), out, error);
    }));
  }
  // format: OBC_MESH_OBJ, ...
  static Mesh read(View<const unsigned char> bytes, std::int32_t format, const ReadOptions& options = {},
                   Host* host = nullptr) {
    return Mesh(made(host, [&](obc_mesh** out, obc_error* error) {
      return obc_mesh_read_memory(bytes.data(), bytes.size(), format, &options, detail::c(host), out, error);
    }));
  }
  void write(const std::string& path, const WriteOptions& options = {}, Host* host = nullptr) const {
    detail::call(host, [&](obc_error* error) {
      return obc_mesh_write(path.c_str(), handle(), &options, detail::c(host), error);
    });
  }

  std::size_t vertex_count() const noexcept { return obc_mesh_vertex_count(handle()); }
  std::size_t triangle_count() const noexcept { return obc_mesh_triangle_count(handle()); }
  std::size_t tetrahedron_count() const noexcept { return obc_mesh_tetrahedron_count(handle()); }
  std::size_t hexahedron_count() const noexcept { return obc_mesh_hexahedron_count(handle()); }

  // Views of the mesh's memory, valid as long as it.
  orbicube::Surface surface() const {
    obc_surface surface;
    detail::call(nullptr, [&](obc_error* error) { return obc_mesh_surface(handle(), &surface, error); });
    return surface;
  }
  operator orbicube::Surface() const { return surface(); }
  Doubles positions() const { return {surface().positions, 3 * vertex_count()}; }
  Indices triangles() const { return {surface().triangles, 3 * triangle_count()}; }
  // Copies.
  std::vector<std::uint32_t> tetrahedra() const {
    std::vector<std::uint32_t> cells(4 * tetrahedron_count());
    detail::call(nullptr, [&](obc_error* error) {
      return obc_mesh_copy(handle(), nullptr, nullptr, cells.data(), nullptr, error);
    });
    return cells;
  }
  std::vector<std::uint32_t> hexahedra() const {
    std::vector<std::uint32_t> cells(8 * hexahedron_count());
    detail::call(nullptr, [&](obc_error* error) {
      return obc_mesh_copy(handle(), nullptr, nullptr, nullptr, cells.data(), error);
    });
    return cells;
  }
  // Copies of the region numbers, one for each triangle or cell, 0 for none; empty if there are none.
  std::vector<std::int32_t> triangle_regions() const { return regions(OBC_MESH_TRIANGLE_REGIONS, triangle_count(), 0); }
  std::vector<std::int32_t> tetrahedron_regions() const {
    return regions(OBC_MESH_TETRAHEDRON_REGIONS, tetrahedron_count(), 1);
  }
  std::vector<std::int32_t> hexahedron_regions() const {
    return regions(OBC_MESH_HEXAHEDRON_REGIONS, hexahedron_count(), 2);
  }
  std::string format() const { return obc_mesh_format(handle()); }
  std::size_t polygon_count() const noexcept { return obc_mesh_polygon_count(handle()); }
  std::size_t welded_vertex_count() const noexcept { return obc_mesh_welded_vertex_count(handle()); }
  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    for (const char* note; (note = obc_mesh_note(handle(), notes.size())) != nullptr;)
      notes.emplace_back(note);
    return notes;
  }

  // Throws, with the place, unless the cells fill a solid.
  void check_cells(Host* host = nullptr) const {
    detail::call(host, [&](obc_error* error) { return obc_mesh_check_cells(handle(), detail::c(host), error); });
  }
  Mesh boundary(Host* host = nullptr) const {
    return Mesh(made(host, [&](obc_mesh** out, obc_error* error) {
      return obc_mesh_boundary(handle(), detail::c(host), out, error);
    }));
  }

  obc_mesh* handle() const noexcept { return handle_.get(); }

 private:
  std::vector<std::int32_t> regions(std::uint32_t kind, std::size_t count, std::size_t place) const {
    std::vector<std::int32_t> numbers;
    if ((obc_mesh_region_kinds(handle()) & kind) == 0) return numbers;
    numbers.resize(count);
    std::array<std::int32_t*, 3> to = {};
    to[place] = numbers.data();
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_mesh_copy_regions(handle(), to[0], to[1], to[2], error); });
    return numbers;
  }

  template <class F>
  static obc_mesh* made(Host* host, F&& f) {
    return detail::take<obc_mesh, obc_mesh_destroy>(host, std::forward<F>(f)).release();
  }
  detail::Handle<obc_mesh, obc_mesh_destroy> handle_;
};

namespace mesh {

namespace detail {
using namespace orbicube::detail;
inline int sign(std::int32_t answer) {
  if (answer == 2) throw Error(OBC_INVALID_ARGUMENT, "a coordinate is not finite, or there is no memory");
  return answer;
}
}  // namespace detail

// A file format. Polygons: of shared vertices, whose coordinates read back bit-identically.
struct Format {
  std::string name, ending;
  bool polygons, cells, binary, regions;
};
// The formats of Mesh::read and Mesh::write, in the order of OBC_MESH_....
inline std::vector<Format> formats() {
  std::vector<Format> found;
  for (std::int32_t i = 0; const char* name = obc_mesh_format_name(i); ++i) {
    const std::uint32_t held = obc_mesh_format_contents(i);
    found.push_back({name, obc_mesh_format_ending(i), (held & OBC_MESH_HOLDS_POLYGONS) != 0,
                     (held & OBC_MESH_HOLDS_CELLS) != 0, (held & OBC_MESH_HOLDS_BINARY) != 0,
                     (held & OBC_MESH_HOLDS_REGIONS) != 0});
  }
  return found;
}
inline std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const char* name; (name = obc_mesh_shape_name(names.size())) != nullptr;)
    names.emplace_back(name);
  return names;
}
inline obc_mesh_topology_report topology(const Surface& surface, Host* host = nullptr) {
  detail::Filled<obc_mesh_topology_report, obc_mesh_topology_report_init> report;
  detail::call(host, [&](obc_error* error) { return obc_mesh_topology(&surface, detail::c(host), &report, error); });
  return report;
}
// Throws, with the place, unless the surface is what sphere maps need.
inline void check_closed_genus_zero(const Surface& surface, Host* host = nullptr) {
  detail::call(host,
               [&](obc_error* error) { return obc_mesh_check_closed_genus_zero(&surface, detail::c(host), error); });
}
inline obc_mesh_tetrahedron_quality_report tetrahedron_quality(const Mesh& mesh, Host* host = nullptr) {
  detail::Filled<obc_mesh_tetrahedron_quality_report, obc_mesh_tetrahedron_quality_report_init> report;
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_tetrahedron_quality(mesh.handle(), detail::c(host), &report, error);
  });
  return report;
}
// Turns triangles in place so that neighbors agree and a closed surface is outward-oriented.
inline obc_mesh_orient_report orient(Doubles positions, View<std::uint32_t> triangles, Host* host = nullptr) {
  detail::Filled<obc_mesh_orient_report, obc_mesh_orient_report_init> report;
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_orient(positions.data(), detail::rows(positions.size(), 3, "positions"), triangles.data(),
                           detail::rows(triangles.size(), 3, "triangles"), detail::c(host), &report, error);
  });
  return report;
}
// The first pairs of triangles that meet where they should not, two entries each.
inline std::vector<std::uint32_t> intersections(const Surface& surface, std::size_t capacity = 1000,
                                                Host* host = nullptr) {
  std::vector<std::uint32_t> pairs(2 * capacity);
  std::size_t count = 0;
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_intersections(&surface, detail::c(host), pairs.data(), capacity, &count, error);
  });
  pairs.resize(2 * count);
  return pairs;
}

// Unit normals, the triangles' weighted by their angles.
inline std::vector<double> vertex_normals(const Surface& surface, Host* host = nullptr) {
  std::vector<double> normals(3 * surface.vertex_count);
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_vertex_normals(&surface, detail::c(host), normals.data(), error);
  });
  return normals;
}
// A third of the area of its triangles for each vertex: the usual weights of a fit by harmonics.
inline std::vector<double> vertex_areas(const Surface& surface, Host* host = nullptr) {
  std::vector<double> areas(surface.vertex_count);
  detail::call(host,
               [&](obc_error* error) { return obc_mesh_vertex_areas(&surface, detail::c(host), areas.data(), error); });
  return areas;
}
inline obc_mesh_distance surface_distance(const Surface& first, const Surface& second, Host* host = nullptr) {
  detail::Filled<obc_mesh_distance, obc_mesh_distance_init> distance;
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_surface_distance(&first, &second, detail::c(host), &distance, error);
  });
  return distance;
}
// The mean distance from points to the nearest of the others, the greater of both ways: the reconstruction error.
inline double mean_distance(Doubles a, Doubles b, Host* host = nullptr) {
  double distance = 0;
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_mean_distance(a.data(), detail::rows(a.size(), 3, "a"), b.data(), detail::rows(b.size(), 3, "b"),
                                  detail::c(host), &distance, error);
  });
  return distance;
}

// For each vertex the lowest one at its very position.
inline std::vector<std::uint32_t> first_at_same_position(Doubles positions, Host* host = nullptr) {
  std::vector<std::uint32_t> first(detail::rows(positions.size(), 3, "positions"));
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_first_at_same_position(positions.data(), first.size(), detail::c(host), first.data(), error);
  });
  return first;
}
inline void write(const std::string& path, const Surface& surface, const Mesh::WriteOptions& options = {},
                  Host* host = nullptr) {
  detail::call(host, [&](obc_error* error) {
    return obc_mesh_write_surface(path.c_str(), &surface, &options, detail::c(host), error);
  });
}
// Exact signs: of (b - a) x (c - a), det[b - a, c - a, d - a] and det[p, q, r].
inline int orientation_2d(const std::array<double, 2>& a, const std::array<double, 2>& b,
                          const std::array<double, 2>& c) {
  return detail::sign(obc_mesh_orientation_2d(a.data(), b.data(), c.data()));
}
inline int orientation_3d(const std::array<double, 3>& a, const std::array<double, 3>& b,
                          const std::array<double, 3>& c, const std::array<double, 3>& d) {
  return detail::sign(obc_mesh_orientation_3d(a.data(), b.data(), c.data(), d.data()));
}
inline int orientation_from_origin(const std::array<double, 3>& p, const std::array<double, 3>& q,
                                   const std::array<double, 3>& r) {
  return detail::sign(obc_mesh_orientation_from_origin(p.data(), q.data(), r.data()));
}

// A surface made ready for searching.
class Search {
 public:
  explicit Search(const Surface& surface, Host* host = nullptr)
      : handle_(
            detail::take<obc_mesh_search, obc_mesh_search_destroy>(host, [&](obc_mesh_search** out, obc_error* error) {
              return obc_mesh_search_create(&surface, detail::c(host), out, error);
            })) {}
  struct Nearest {
    std::vector<std::uint32_t> triangles;
    std::vector<double> weights, positions, distances;
  };
  std::vector<std::uint32_t> vertices(Doubles points) const {
    std::vector<std::uint32_t> found(detail::rows(points.size(), 3, "points"));
    detail::call(nullptr, [&](obc_error* error) {
      return obc_mesh_search_vertices(handle_.get(), points.data(), found.size(), found.data(), error);
    });
    return found;
  }
  Nearest surface(Doubles points) const {
    const std::size_t n = detail::rows(points.size(), 3, "points");
    Nearest found{std::vector<std::uint32_t>(n), std::vector<double>(3 * n), std::vector<double>(3 * n),
                  std::vector<double>(n)};
    detail::call(nullptr, [&](obc_error* error) {
      return obc_mesh_search_surface(handle_.get(), points.data(), n, found.triangles.data(), found.weights.data(),
                                     found.positions.data(), found.distances.data(), error);
    });
    return found;
  }
  obc_mesh_search* handle() const noexcept { return handle_.get(); }

 private:
  detail::Handle<obc_mesh_search, obc_mesh_search_destroy> handle_;
};

}  // namespace mesh
}  // namespace api
}  // namespace orbicube

#endif
