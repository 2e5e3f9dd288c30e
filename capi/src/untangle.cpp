#include "orbicube/untangle.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>

#include "base/version.h"
#include "capi/src/entry.h"
#include "mesh/topology/conforming_tetrahedra.h"
#include "untangle/refine/refined.h"
#include "untangle/tetrahedra/untangle_tetrahedra.h"
#include "untangle/triangles/untangle_triangles.h"

using namespace orbicube;
using mesh::Tetrahedron;
using mesh::Triangle;
using mesh::Vector3;
using untangle::Vector2d;

// Of triangles or of tetrahedra, in flat arrays.
struct obc_untangle_refined {
  explicit obc_untangle_refined(const obc_host* host) : adapter(host) {}

  capi::HostAdapter adapter;
  base::Array<double> positions{adapter.host().memory}, weights{adapter.host().memory};
  base::Array<std::uint32_t> elements{adapter.host().memory}, parents{adapter.host().memory},
      origins{adapter.host().memory};
  std::size_t vertices = 0;
};

namespace {

obc_untangle_tetrahedra_problem no_tetrahedra() {
  obc_untangle_tetrahedra_problem t{};
  t.struct_size = sizeof t;
  return t;
}

obc_untangle_triangles_problem no_triangles() {
  obc_untangle_triangles_problem t{};
  t.struct_size = sizeof t;
  return t;
}

obc_untangle_options default_options() {
  const untangle::UntangleOptions defaults;
  obc_untangle_options o{};
  o.struct_size = sizeof o;
  o.max_steps = defaults.steps;
  o.max_polish_steps = defaults.polish_steps;
  o.volume_weight = defaults.volume_weight;
  o.tolerance = defaults.tolerance;
  return o;
}

untangle::UntangleOptions options_of(const obc_untangle_options& o) {
  return {.steps = o.max_steps,
          .polish_steps = o.max_polish_steps,
          .volume_weight = o.volume_weight,
          .tolerance = o.tolerance};
}

obc_untangle_report empty_report() {
  obc_untangle_report r{};
  r.struct_size = sizeof r;
  r.first_inverted = UINT32_MAX;
  return r;
}

obc_untangle_report report_of(const untangle::UntanglingFigures& figures) {
  obc_untangle_report r = empty_report();
  r.first_inverted = figures.first_inverted;
  r.inverted_before = figures.inverted_before;
  r.inverted = figures.inverted;
  r.steps = figures.steps;
  r.polish_steps = figures.polish_steps;
  r.min_determinant = figures.min_determinant;
  r.max_determinant = figures.max_determinant;
  r.energy = figures.energy;
  return r;
}

untangle::UntangleProblem view_of(const obc_untangle_tetrahedra_problem& t) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double) && sizeof(Tetrahedron) == 4 * sizeof(uint32_t));
  capi::require(t.positions != nullptr || t.vertex_count == 0, "problem->positions is NULL");
  capi::require(t.tetrahedra != nullptr || t.tetrahedron_count == 0, "problem->tetrahedra is NULL");
  constexpr std::size_t most = UINT32_MAX / 4;
  capi::require(t.vertex_count < most && t.tetrahedron_count < most, "too many vertices or tetrahedra");
  const auto positions = [&](const double* from) {
    return std::span(reinterpret_cast<const Vector3*>(from), from != nullptr ? t.vertex_count : 0);
  };
  const auto coordinates = [&](const auto* from) { return std::span(from, from != nullptr ? 3 * t.vertex_count : 0); };
  return {{reinterpret_cast<const Tetrahedron*>(t.tetrahedra), t.tetrahedron_count},
          positions(t.positions),
          positions(t.rest),
          coordinates(t.fixed_coordinates),
          coordinates(t.ties)};
}

untangle::TriangleProblem view_of(const obc_untangle_triangles_problem& t) {
  static_assert(sizeof(Vector2d) == 2 * sizeof(double) && sizeof(Triangle) == 3 * sizeof(uint32_t));
  capi::require(t.positions != nullptr || t.vertex_count == 0, "problem->positions is NULL");
  capi::require(t.triangles != nullptr || t.triangle_count == 0, "problem->triangles is NULL");
  constexpr std::size_t most = UINT32_MAX / 4;
  capi::require(t.vertex_count < most && t.triangle_count < most, "too many vertices or triangles");
  const auto coordinates = [&](const auto* from) { return std::span(from, from != nullptr ? 2 * t.vertex_count : 0); };
  return {{reinterpret_cast<const Triangle*>(t.triangles), t.triangle_count},
          {reinterpret_cast<const Vector2d*>(t.positions), t.vertex_count},
          {reinterpret_cast<const Vector3*>(t.rest), t.rest != nullptr ? t.vertex_count : 0},
          coordinates(t.fixed_coordinates),
          coordinates(t.ties)};
}

// Returns an entry a coordinate, `axes` of them a vertex: those that are fixed by themselves, as vertices, or, where
// nothing else is, with the boundary.
template <class Problem, class Boundary>
base::Array<std::uint8_t> fixed_coordinates(const Problem& given, std::span<const std::uint8_t> coordinates,
                                            std::size_t axes, const obc_untangle_options& options,
                                            const base::Host& host, const Boundary& boundary) {
  base::Array<std::uint8_t> fixed(coordinates.begin(), coordinates.end(), host.memory);
  const auto add = [&](std::span<const std::uint8_t> vertices) {
    fixed.resize(axes * given.vertex_count);
    for (std::size_t i = 0; i < fixed.size(); ++i)
      fixed[i] |= vertices[i / axes];
  };
  if (given.fixed != nullptr)
    add({given.fixed, given.vertex_count});
  else if (coordinates.empty() && options.free_boundary == 0)
    add(boundary());
  return fixed;
}

// Runs `body` on the mesh and the options of a problem; the report is empty until then.
template <class Body>
void on_tetrahedra(const obc_untangle_tetrahedra_problem* problem, const obc_untangle_options* options,
                   obc_untangle_report* report, const base::Host& host, const Body& body) {
  capi::require(problem != nullptr, "the argument `problem` is NULL");
  const obc_untangle_tetrahedra_problem given = capi::copy_versioned(problem, no_tetrahedra());
  untangle::UntangleProblem mesh = view_of(given);
  const obc_untangle_options o = capi::copy_versioned(options, default_options());
  capi::write_versioned(report, empty_report());
  untangle::require_vertices(mesh.tetrahedra, mesh.start);
  const base::Array<std::uint8_t> fixed = fixed_coordinates(given, mesh.fixed, 3, o, host, [&] {
    return mesh::boundary_vertices(mesh.tetrahedra, given.vertex_count, host);
  });
  mesh.fixed = fixed;
  body(mesh, options_of(o));
}

template <class Body>
void on_triangles(const obc_untangle_triangles_problem* problem, const obc_untangle_options* options,
                  obc_untangle_report* report, const base::Host& host, const Body& body) {
  capi::require(problem != nullptr, "the argument `problem` is NULL");
  const obc_untangle_triangles_problem given = capi::copy_versioned(problem, no_triangles());
  untangle::TriangleProblem mesh = view_of(given);
  const obc_untangle_options o = capi::copy_versioned(options, default_options());
  capi::write_versioned(report, empty_report());
  const base::Array<std::uint8_t> fixed = fixed_coordinates(given, mesh.fixed, 2, o, host, [&] {
    return untangle::boundary_vertices(mesh.triangles, given.vertex_count, host);
  });
  mesh.fixed = fixed;
  body(mesh, options_of(o));
}

template <std::size_t corners, class Vector>
void flatten(const untangle::Refined<corners, Vector>& from, obc_untangle_refined& to) {
  to.vertices = from.positions.size();
  for (const Vector& p : from.positions)
    to.positions.insert(to.positions.end(), p.begin(), p.end());
  for (const auto& e : from.elements)
    to.elements.insert(to.elements.end(), e.begin(), e.end());
  to.parents = from.parents;
  for (const untangle::Origin<corners>& o : from.origins) {
    to.origins.insert(to.origins.end(), o.vertices.begin(), o.vertices.end());
    to.weights.insert(to.weights.end(), o.weights.begin(), o.weights.end());
  }
}

// What errors say of the elements that stay inverted.
struct Staying {
  const char *one, *many;
};

// on(host, body) runs `body` on a mesh and options, as above; `out` owns what it makes of them.
template <class On>
void refine(const obc_host* host, obc_untangle_refined** out, obc_untangle_report* report, const Staying& staying,
            const On& on) {
  capi::require(out != nullptr, "out is NULL");
  *out = nullptr;
  auto made = std::make_unique<obc_untangle_refined>(host);
  on(made->adapter.host(), [&](const auto& mesh, const auto& options) {
    const auto refined = untangle::untangle_refined(mesh, options, made->adapter.host());
    capi::write_versioned(report, report_of(refined));
    untangle::require_untangled(refined, refined.elements.size(), staying.one, staying.many);
    flatten(refined, *made);
  });
  *out = made.release();
}

}  // namespace

obc_status obc_untangle_options_init(obc_untangle_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_untangle_report_init(obc_untangle_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, empty_report());
}

obc_status obc_untangle_tetrahedra_problem_init(obc_untangle_tetrahedra_problem* problem, size_t struct_size) {
  return capi::init_versioned(problem, struct_size, no_tetrahedra());
}

obc_status obc_untangle_tetrahedra(const obc_untangle_tetrahedra_problem* problem, const obc_untangle_options* options,
                                   const obc_host* host, double* result, obc_untangle_report* report,
                                   obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(result != nullptr, "result is NULL");
    const capi::HostAdapter adapter(host);
    on_tetrahedra(problem, options, report, adapter.host(), [&](const auto& mesh, const auto& o) {
      const untangle::Untangled untangled = untangle::untangle_tetrahedra(mesh, o, adapter.host());
      capi::write_versioned(report, report_of(untangled));
      std::memcpy(result, untangled.positions.data(), untangled.positions.size() * sizeof(Vector3));
      untangle::require_untangled(untangled, mesh.tetrahedra.size(), "tetrahedron stays", "tetrahedra stay");
    });
  });
}

obc_status obc_untangle_triangles_problem_init(obc_untangle_triangles_problem* problem, size_t struct_size) {
  return capi::init_versioned(problem, struct_size, no_triangles());
}

obc_status obc_untangle_triangles(const obc_untangle_triangles_problem* problem, const obc_untangle_options* options,
                                  const obc_host* host, double* result, obc_untangle_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(result != nullptr, "result is NULL");
    const capi::HostAdapter adapter(host);
    on_triangles(problem, options, report, adapter.host(), [&](const auto& mesh, const auto& o) {
      const untangle::UntangledTriangles untangled = untangle::untangle_triangles(mesh, o, adapter.host());
      capi::write_versioned(report, report_of(untangled));
      std::memcpy(result, untangled.positions.data(), untangled.positions.size() * sizeof(Vector2d));
      untangle::require_untangled(untangled, mesh.triangles.size(), "triangle stays", "triangles stay");
    });
  });
}

obc_status obc_untangle_refine_tetrahedra(const obc_untangle_tetrahedra_problem* problem,
                                          const obc_untangle_options* options, const obc_host* host,
                                          obc_untangle_refined** out, obc_untangle_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    refine(
        host, out, report, {"tetrahedron stays", "tetrahedra stay"},
        [&](const base::Host& adapted, const auto& body) { on_tetrahedra(problem, options, report, adapted, body); });
  });
}

obc_status obc_untangle_refine_triangles(const obc_untangle_triangles_problem* problem,
                                         const obc_untangle_options* options, const obc_host* host,
                                         obc_untangle_refined** out, obc_untangle_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    refine(host, out, report, {"triangle stays", "triangles stay"},
           [&](const base::Host& adapted, const auto& body) { on_triangles(problem, options, report, adapted, body); });
  });
}

void obc_untangle_refined_destroy(obc_untangle_refined* refined) {
  delete refined;
}

size_t obc_untangle_refined_vertex_count(const obc_untangle_refined* refined) {
  return refined != nullptr ? refined->vertices : 0;
}

size_t obc_untangle_refined_element_count(const obc_untangle_refined* refined) {
  return refined != nullptr ? refined->parents.size() : 0;
}

obc_status obc_untangle_refined_copy(const obc_untangle_refined* refined, double* positions, uint32_t* elements,
                                     uint32_t* parents, uint32_t* origins, double* weights, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(refined != nullptr, "refined is NULL");
    const auto copy = [](const auto& from, auto* to) {
      if (to != nullptr) std::copy(from.begin(), from.end(), to);
    };
    copy(refined->positions, positions);
    copy(refined->elements, elements);
    copy(refined->parents, parents);
    copy(refined->origins, origins);
    copy(refined->weights, weights);
  });
}

uint32_t obc_untangle_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
