// Maps of solids to polycubes without inverted tetrahedra; wraps orbicube/volume_map.h.
#ifndef ORBICUBE_VOLUME_MAP_HPP
#define ORBICUBE_VOLUME_MAP_HPP

#include <vector>

#include <orbicube/volume_map.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {
namespace volume_map {

using SolidOptions = detail::Filled<obc_volume_map_solid_options, obc_volume_map_solid_options_init>;

// A solid on the polycube of its boundary, one to one.
struct Solid {
  std::vector<double> positions, polycube;  // x y z a vertex, in space and on the polycube
  std::vector<std::uint32_t> tetrahedra;
};

inline Solid map_to_polycube(Doubles positions, Indices tetrahedra, const SolidOptions& options = {},
                             Host* host = nullptr) {
  const std::size_t vertices = detail::rows(positions.size(), 3, "positions");
  const std::size_t cells = detail::rows(tetrahedra.size(), 4, "tetrahedra");
  const auto keeper = detail::take<obc_volume_map_solid, obc_volume_map_solid_destroy>(
      host, [&](obc_volume_map_solid** out, obc_error* error) {
        return obc_volume_map_solid_compute(positions.data(), vertices, tetrahedra.data(), cells, &options,
                                            detail::c(host), out, error);
      });
  const obc_volume_map_solid* const made = keeper.get();
  Solid result;
  result.positions.resize(3 * obc_volume_map_solid_vertex_count(made));
  result.polycube.resize(result.positions.size());
  result.tetrahedra.resize(4 * obc_volume_map_solid_tetrahedron_count(made));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_volume_map_solid_copy(made, result.positions.data(), result.polycube.data(), result.tetrahedra.data(),
                                     error);
  });
  return result;
}

using FrameMapOptions = detail::Filled<obc_volume_map_frame_map_options, obc_volume_map_frame_map_options_init>;

// A parameterization along frames. Faces are 4 t + k, opposite corner k of tetrahedron t.
struct FrameMap {
  std::vector<double> parameters, gaps;              // 12 a tetrahedron; three a face
  std::vector<std::uint8_t> rotations, cut, labels;  // of each face
  std::vector<std::uint32_t> singular_edges;         // two vertices each
  obc_volume_map_frame_map_report report;
};

// `frames`: w x y z a tetrahedron, or empty for computed ones.
inline FrameMap parameterize(Doubles positions, Indices tetrahedra, Doubles frames = {},
                             const FrameMapOptions& options = {}, Host* host = nullptr) {
  const std::size_t vertices = detail::rows(positions.size(), 3, "positions");
  const std::size_t cells = detail::rows(tetrahedra.size(), 4, "tetrahedra");
  if (frames.size() != 0) detail::check_size(frames.size(), 4 * cells, "frames");
  FrameMap map;
  map.report = detail::sized<obc_volume_map_frame_map_report>();
  const auto made = detail::take<obc_volume_map_frame_map, obc_volume_map_frame_map_destroy>(
      host, [&](obc_volume_map_frame_map** out, obc_error* error) {
        return obc_volume_map_frame_map_compute(positions.data(), vertices, tetrahedra.data(), cells,
                                                frames.size() != 0 ? frames.data() : nullptr, &options, detail::c(host),
                                                &map.report, out, error);
      });
  map.parameters.resize(12 * cells);
  map.gaps.resize(12 * cells);
  for (auto* of_faces : {&map.rotations, &map.cut, &map.labels})
    of_faces->resize(4 * cells);
  map.singular_edges.resize(2 * obc_volume_map_frame_map_singular_edge_count(made.get()));
  detail::call(nullptr, [&](obc_error* error) {
    return obc_volume_map_frame_map_copy(made.get(), map.parameters.data(), map.rotations.data(), map.gaps.data(),
                                         map.cut.data(), map.labels.data(), map.singular_edges.data(), error);
  });
  return map;
}

// Finds points in a mesh of tetrahedra.
class Locator {
 public:
  Locator(Doubles positions, Indices tetrahedra, Host* host = nullptr)
      : vertex_count_(detail::rows(positions.size(), 3, "positions")) {
    const std::size_t cells = detail::rows(tetrahedra.size(), 4, "tetrahedra");
    handle_ = detail::take<obc_volume_map_locator, obc_volume_map_locator_destroy>(
        host, [&](obc_volume_map_locator** out, obc_error* error) {
          return obc_volume_map_locator_create(positions.data(), vertex_count_, tetrahedra.data(), cells,
                                               detail::c(host), out, error);
        });
  }
  struct Places {
    std::vector<std::uint32_t> tetrahedra;  // UINT32_MAX where no tetrahedron has the point
    std::vector<double> weights;            // four a point
  };
  Places locate(Doubles points, Host* host = nullptr) const {
    const std::size_t n = detail::rows(points.size(), 3, "points");
    Places places{std::vector<std::uint32_t>(n), std::vector<double>(4 * n)};
    detail::call(host, [&](obc_error* error) {
      return obc_volume_map_locator_locate(handle(), points.data(), n, detail::c(host), places.tetrahedra.data(),
                                           places.weights.data(), error);
    });
    return places;
  }
  // Values of the vertices, interpolated; NaN where no tetrahedron has the point. With the positions of the image as
  // values it is the map, and for a locator of the image, with those in space, its inverse.
  std::vector<double> sample(Doubles points, Doubles values, Host* host = nullptr) const {
    const std::size_t components = vertex_count_ != 0 ? detail::rows(values.size(), vertex_count_, "values") : 0;
    const Places places = locate(points, host);
    std::vector<double> sampled(components * places.tetrahedra.size());
    detail::call(host, [&](obc_error* error) {
      return obc_volume_map_locator_interpolate(handle(), places.tetrahedra.data(), places.weights.data(),
                                                places.tetrahedra.size(), values.data(), components, detail::c(host),
                                                sampled.data(), error);
    });
    return sampled;
  }
  obc_volume_map_locator* handle() const noexcept { return handle_.get(); }

 private:
  std::size_t vertex_count_;
  detail::Handle<obc_volume_map_locator, obc_volume_map_locator_destroy> handle_;
};

}  // namespace volume_map
}  // namespace api
}  // namespace orbicube

#endif
