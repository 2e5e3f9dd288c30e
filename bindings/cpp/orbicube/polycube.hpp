// Polycubes of closed surfaces, and certified maps to them; wraps orbicube/polycube.h.
//
//   auto map = orbicube::Polycube::compute(mesh).optimize_domain();
#ifndef ORBICUBE_POLYCUBE_HPP
#define ORBICUBE_POLYCUBE_HPP

#include <cstdint>
#include <utility>
#include <vector>

#include <orbicube/polycube.h>
#include <orbicube/mesh.hpp>

namespace orbicube {
inline namespace api {

// A certified map.
class Polycube {
 public:
  using Options = detail::Filled<obc_polycube_options, obc_polycube_options_init>;
  using DomainOptions = detail::Filled<obc_polycube_domain_options, obc_polycube_domain_options_init>;
  using CornerOptions = detail::Filled<obc_polycube_corner_options, obc_polycube_corner_options_init>;
  using FeatureOptions = detail::Filled<obc_polycube_feature_options, obc_polycube_feature_options_init>;
  using AtlasOptions = detail::Filled<obc_polycube_atlas_options, obc_polycube_atlas_options_init>;
  using QuadsOptions = detail::Filled<obc_polycube_quads_options, obc_polycube_quads_options_init>;

  explicit Polycube(obc_polycube* owned) noexcept : handle_(owned) {}
  static Polycube compute(const Surface& surface, const Options& options = {}, Host* host = nullptr) {
    return made(host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_compute(&surface, &options, detail::c(host), out, error);
    });
  }
  // On the given polycube, with positions of corners or without.
  static Polycube map_to_domain(const Surface& surface, const Surface& polycube,
                                const obc_polycube_constraints* constraints = nullptr, Host* host = nullptr) {
    return made(host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_map_to_domain(&surface, &polycube, constraints, detail::c(host), out, error);
    });
  }
  // A map made elsewhere; throws, with the reason, what is none.
  static Polycube certify(const Surface& surface, Doubles polycube, Host* host = nullptr) {
    detail::check_size(polycube.size(), 3 * surface.vertex_count, "polycube");
    return made(host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_create(&surface, polycube.data(), detail::c(host), nullptr, out, error);
    });
  }
  // One polycube for several shapes; constructed_from: the shape that it was made for.
  static std::vector<Polycube> compute_common(View<const Surface> surfaces, const Options& options = {},
                                              const DomainOptions& domain = {}, std::size_t* constructed_from = nullptr,
                                              Host* host = nullptr) {
    const std::vector<obc_surface> views(surfaces.begin(), surfaces.end());
    return made_together(views.size(), host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_compute_common(views.data(), views.size(), &options, &domain, detail::c(host),
                                         constructed_from, out, error);
    });
  }
  // The proportions with the minimum sum of energies of maps to one polycube.
  static std::vector<Polycube> optimize_common_domain(View<const Polycube> maps, const DomainOptions& options = {},
                                                      Host* host = nullptr) {
    std::vector<const obc_polycube*> given;
    for (const Polycube& map : maps)
      given.push_back(map.handle());
    return made_together(given.size(), host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_optimize_common_domain(given.data(), given.size(), &options, detail::c(host), out, error);
    });
  }

  Polycube optimize_domain(const DomainOptions& options = {}, obc_polycube_domain_report* report = nullptr,
                           Host* host = nullptr) const {
    if (report != nullptr) report->struct_size = sizeof *report;
    return made(host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_optimize_domain(handle(), &options, detail::c(host), report, out, error);
    });
  }
  Polycube optimize_corners(const CornerOptions& options = {}, obc_polycube_corner_report* report = nullptr,
                            Host* host = nullptr) const {
    if (report != nullptr) report->struct_size = sizeof *report;
    return made(host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_optimize_corners(handle(), &options, detail::c(host), report, out, error);
    });
  }
  // What must be mapped where; throws when something cannot be.
  Polycube align_features(const FeatureOptions& options, obc_polycube_feature_report* report = nullptr,
                          Host* host = nullptr) const {
    if (report != nullptr) report->struct_size = sizeof *report;
    return made(host, [&](obc_polycube** out, obc_error* error) {
      return obc_polycube_align_features(handle(), &options, detail::c(host), report, out, error);
    });
  }

  std::size_t vertex_count() const noexcept { return obc_polycube_vertex_count(handle()); }
  std::size_t triangle_count() const noexcept { return obc_polycube_triangle_count(handle()); }
  std::size_t corner_count() const noexcept { return obc_polycube_corner_count(handle()); }
  std::size_t patch_count() const noexcept { return obc_polycube_patch_count(handle()); }

  // In space, and on the polycube, x y z a vertex; three vertices a triangle.
  std::vector<double> positions() const {
    std::vector<double> out(3 * vertex_count());
    copy(out.data(), nullptr, nullptr);
    return out;
  }
  std::vector<double> polycube() const {
    std::vector<double> out(3 * vertex_count());
    copy(nullptr, out.data(), nullptr);
    return out;
  }
  std::vector<std::uint32_t> triangles() const {
    std::vector<std::uint32_t> out(3 * triangle_count());
    copy(nullptr, nullptr, out.data());
    return out;
  }
  struct OfTriangles {
    std::vector<std::uint8_t> labels;  // 0 to 5 for +x, -x, +y, -y, +z, -z
    std::vector<std::uint32_t> patches, sources;
  };
  OfTriangles of_triangles() const {
    const std::size_t n = triangle_count();
    OfTriangles out{std::vector<std::uint8_t>(n), std::vector<std::uint32_t>(n), std::vector<std::uint32_t>(n)};
    detail::call(nullptr, [&](obc_error* error) {
      return obc_polycube_copy_triangles(handle(), out.labels.data(), out.patches.data(), out.sources.data(), error);
    });
    return out;
  }
  std::vector<double> energies() const {
    std::vector<double> out(obc_polycube_energy_count(handle()));
    detail::call(nullptr, [&](obc_error* error) { return obc_polycube_copy_energies(handle(), out.data(), error); });
    return out;
  }

  // Where each vertex comes from: three vertices of one triangle of the surface (UINT32_MAX where fewer are needed),
  // weights.
  struct Sources {
    std::vector<std::uint32_t> corners;
    std::vector<double> weights;
  };
  Sources sources() const {
    Sources out{std::vector<std::uint32_t>(3 * vertex_count()), std::vector<double>(3 * vertex_count())};
    detail::call(nullptr, [&](obc_error* error) {
      return obc_polycube_copy_sources(handle(), out.corners.data(), out.weights.data(), error);
    });
    return out;
  }
  // OBC_POLYCUBE_LABELS, ...: how it was made.
  std::int32_t construction() const noexcept { return obc_polycube_construction(handle()); }

  // Corners, straight edges and patches without triangles; <orbicube/polycube.h> describes each array.
  struct Graph {
    std::vector<double> corner_positions;
    std::vector<std::uint32_t> corner_vertices, edge_corners, edge_patches;
    std::vector<std::uint8_t> edge_convex, patch_labels;
    std::vector<double> patch_coordinates;
    std::vector<std::uint32_t> patch_loops, loop_darts;  // where each begins among loops and darts, and one entry more
    std::vector<std::uint32_t> darts;
    std::vector<std::uint32_t> link_starts, links;  // of each patch those that share an edge with it
  };
  Graph graph(Host* host = nullptr) const {
    const auto keeper = detail::take<obc_polycube_graph, obc_polycube_graph_destroy>(
        host, [&](obc_polycube_graph** out, obc_error* error) {
          return obc_polycube_graph_create(handle(), detail::c(host), out, error);
        });
    return copied(*keeper);
  }

  struct Quads {
    std::vector<double> positions, polycube;
    std::vector<std::uint32_t> corners, patches;  // four vertices a quad, and its patch
    std::vector<std::uint32_t> triangles;         // of each vertex the triangle of the map that it is in,
    std::vector<double> weights;                  // and its three weights there
  };
  Quads quads(const QuadsOptions& options = {}, Host* host = nullptr) const {
    const auto keeper = detail::take<obc_polycube_quads, obc_polycube_quads_destroy>(
        host, [&](obc_polycube_quads** out, obc_error* error) {
          return obc_polycube_quads_create(handle(), &options, detail::c(host), out, error);
        });
    const obc_polycube_quads* const made_quads = keeper.get();
    const std::size_t n = obc_polycube_quads_vertex_count(made_quads), m = obc_polycube_quads_quad_count(made_quads);
    Quads out{std::vector<double>(3 * n),    std::vector<double>(3 * n),    std::vector<std::uint32_t>(4 * m),
              std::vector<std::uint32_t>(m), std::vector<std::uint32_t>(n), std::vector<double>(3 * n)};
    detail::call(nullptr, [&](obc_error* error) {
      return obc_polycube_quads_copy(made_quads, out.positions.data(), out.polycube.data(), out.corners.data(),
                                     out.patches.data(), error);
    });
    detail::call(nullptr, [&](obc_error* error) {
      return obc_polycube_quads_copy_sources(made_quads, out.triangles.data(), out.weights.data(), error);
    });
    return out;
  }

  // The patches packed into a square; does not need the map any more.
  class Atlas {
   public:
    // Texels along each side, and triangles of the map.
    std::uint32_t size() const noexcept { return obc_polycube_atlas_size(handle()); }
    std::size_t triangle_count() const noexcept { return obc_polycube_atlas_triangle_count(handle()); }
    // u and v of the three corners of each triangle, 0 to 1, from the top left.
    std::vector<double> coordinates() const {
      std::vector<double> out(6 * triangle_count());
      copy(out.data(), nullptr, nullptr);
      return out;
    }
    double texels_per_unit() const {  // of the polycube
      double out = 0;
      copy(nullptr, &out, nullptr);
      return out;
    }
    double coverage() const {  // fraction of the square in patches
      double out = 0;
      copy(nullptr, nullptr, &out);
      return out;
    }
    // What each texel shows, row by row from the top: a triangle of the map (UINT32_MAX: none), the weights of its
    // three corners, and whether it has the middle of the texel; others show the nearest texel in a patch.
    struct Texels {
      std::vector<std::uint32_t> triangles;
      std::vector<double> weights;
      std::vector<std::uint8_t> covered;
    };
    Texels sample(Host* host = nullptr) const {
      const std::size_t n = std::size_t{size()} * size();
      Texels out{std::vector<std::uint32_t>(n), std::vector<double>(3 * n), std::vector<std::uint8_t>(n)};
      detail::call(host, [&](obc_error* error) {
        return obc_polycube_atlas_sample(handle(), detail::c(host), out.triangles.data(), out.weights.data(),
                                         out.covered.data(), error);
      });
      return out;
    }
    const obc_polycube_atlas* handle() const noexcept { return handle_.get(); }

   private:
    friend class Polycube;
    using Owner = detail::Handle<obc_polycube_atlas, obc_polycube_atlas_destroy>;
    explicit Atlas(Owner owner) noexcept : handle_(std::move(owner)) {}
    void copy(double* coordinates, double* texels_per_unit, double* coverage) const {
      detail::call(nullptr, [&](obc_error* error) {
        return obc_polycube_atlas_copy(handle(), coordinates, texels_per_unit, coverage, error);
      });
    }
    Owner handle_;
  };
  Atlas atlas(const AtlasOptions& options = {}, Host* host = nullptr) const {
    return Atlas(detail::take<obc_polycube_atlas, obc_polycube_atlas_destroy>(
        host, [&](obc_polycube_atlas** out, obc_error* error) {
          return obc_polycube_atlas_create(handle(), &options, detail::c(host), out, error);
        }));
  }

  obc_polycube* handle() const noexcept { return handle_.get(); }

 private:
  template <class F>
  static std::vector<Polycube> made_together(std::size_t count, Host* host, F&& f) {
    std::vector<obc_polycube*> out(count, nullptr);
    std::vector<Polycube> maps;
    maps.reserve(count);  // before there is something to lose
    obc_error error;
    const obc_status status = f(out.data(), &error);
    for (obc_polycube* map : out)
      maps.emplace_back(map);
    if (host != nullptr) host->rethrow();
    if (status != OBC_OK) throw Error(error);
    return maps;
  }
  template <class F>
  static Polycube made(Host* host, F&& f) {
    return Polycube(detail::take<obc_polycube, obc_polycube_destroy>(host, std::forward<F>(f)).release());
  }
  static Graph copied(const obc_polycube_graph& of) {
    Graph out;
    const std::size_t corners = obc_polycube_graph_corner_count(&of), edges = obc_polycube_graph_edge_count(&of);
    const std::size_t patches = obc_polycube_graph_patch_count(&of);
    out.corner_positions.resize(3 * corners);
    out.corner_vertices.resize(corners);
    out.edge_corners.resize(2 * edges);
    out.edge_patches.resize(2 * edges);
    out.edge_convex.resize(edges);
    out.patch_labels.resize(patches);
    out.patch_coordinates.resize(patches);
    out.patch_loops.resize(patches + 1);
    out.loop_darts.resize(obc_polycube_graph_loop_count(&of) + 1);
    out.darts.resize(2 * edges);
    out.link_starts.resize(patches + 1);
    out.links.resize(obc_polycube_graph_link_count(&of));
    const auto call = [](auto&& f) { detail::call(nullptr, f); };
    call([&](obc_error* error) {
      return obc_polycube_graph_copy_corners(&of, out.corner_positions.data(), out.corner_vertices.data(), error);
    });
    call([&](obc_error* error) {
      return obc_polycube_graph_copy_edges(&of, out.edge_corners.data(), out.edge_patches.data(),
                                           out.edge_convex.data(), error);
    });
    call([&](obc_error* error) {
      return obc_polycube_graph_copy_patches(&of, out.patch_labels.data(), out.patch_coordinates.data(),
                                             out.patch_loops.data(), error);
    });
    call([&](obc_error* error) {
      return obc_polycube_graph_copy_loops(&of, out.loop_darts.data(), out.darts.data(), error);
    });
    call([&](obc_error* error) {
      return obc_polycube_graph_copy_dual(&of, out.link_starts.data(), out.links.data(), error);
    });
    return out;
  }
  void copy(double* positions, double* polycube, std::uint32_t* triangles) const {
    detail::call(nullptr,
                 [&](obc_error* error) { return obc_polycube_copy(handle(), positions, polycube, triangles, error); });
  }
  detail::Handle<obc_polycube, obc_polycube_destroy> handle_;
};

}  // namespace api
}  // namespace orbicube

#endif
