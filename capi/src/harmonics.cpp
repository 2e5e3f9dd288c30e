#include "orbicube/harmonics.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "base/version.h"
#include "capi/src/entry.h"
#include "harmonics/fitting/fit.h"
#include "harmonics/fitting/map_refinement.h"
#include "harmonics/functions/basis.h"
#include "harmonics/functions/coefficient_file.h"
#include "harmonics/functions/spectrum.h"
#include "harmonics/rotations/alignment.h"
#include "harmonics/rotations/rotation.h"

using namespace orbicube;
using harmonics::Coefficients;
using harmonics::Vector3;

struct obc_harmonics_coefficients {
  explicit obc_harmonics_coefficients(const obc_host* host) : adapter(host), coefficients(adapter.host().memory) {}
  capi::HostAdapter adapter;
  Coefficients coefficients;
};

namespace {

using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

obc_harmonics_align_options default_align_options() {
  obc_harmonics_align_options o{};
  o.struct_size = sizeof o;
  o.search_degree = harmonics::AlignmentOptions{}.search_degree;
  return o;
}

harmonics::FileFormat checked_format(int32_t format) {
  capi::require(format >= OBC_HARMONICS_BY_ENDING && format <= OBC_HARMONICS_SPHARM_PDM, "unknown format");
  return static_cast<harmonics::FileFormat>(format);
}

obc_harmonics_fit_options default_options() {
  obc_harmonics_fit_options o{};
  o.struct_size = sizeof o;
  o.degree = harmonics::FitOptions{}.degree;
  o.method = OBC_HARMONICS_AUTOMATIC;
  return o;
}

// Doubles have the layout of vectors.
std::span<const Vector3> vectors(const double* data, std::size_t count, const char* message) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  capi::require(data != nullptr || count == 0, message);
  return {reinterpret_cast<const Vector3*>(data), count};
}

std::size_t checked_size(std::uint32_t degree, std::size_t channels) {
  harmonics::require_degree(degree);
  capi::require(channels > 0, "channels is 0");
  capi::require(channels <= SIZE_MAX / sizeof(double) / harmonics::basis_size(degree), "channels is too large");
  return harmonics::basis_size(degree) * channels;
}

Coefficients copy_of(const double* values, std::uint32_t degree, std::size_t channels,
                     std::pmr::memory_resource* memory) {
  capi::require(values != nullptr, "coefficients are NULL");
  const std::size_t size = checked_size(degree, channels);
  Coefficients coefficients(degree, channels, memory);
  std::copy_n(values, size, coefficients.values.begin());
  return coefficients;
}

}  // namespace

obc_status obc_harmonics_fit_options_init(obc_harmonics_fit_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_options());
}

obc_status obc_harmonics_fit_report_init(obc_harmonics_fit_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_harmonics_fit_report{});
}

size_t obc_harmonics_size(uint32_t degree) {
  return harmonics::basis_size(degree);
}

obc_status obc_harmonics_evaluate(const double* directions, size_t count, uint32_t degree, const obc_host* host,
                                  double* rows, obc_error* error) {
  return capi::guarded(error, [&] {
    const std::size_t size = checked_size(degree, 1);
    capi::require(rows != nullptr || count == 0, "rows is NULL");
    const capi::HostAdapter adapter(host);
    harmonics::evaluate(vectors(directions, count, "directions is NULL"), degree, {rows, count * size}, adapter.host());
  });
}

obc_status obc_harmonics_fit(const double* directions, const double* weights, const double* values, size_t count,
                             size_t channels, const obc_harmonics_fit_options* options, const obc_host* host,
                             double* coefficients, obc_harmonics_fit_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const obc_harmonics_fit_options o = capi::copy_versioned(options, default_options());
    checked_size(o.degree, channels);
    capi::require(values != nullptr || count == 0, "values is NULL");
    capi::require(coefficients != nullptr, "coefficients is NULL");
    const capi::HostAdapter adapter(host);
    harmonics::FitReport told;
    const Coefficients fitted = harmonics::fit(
        vectors(directions, count, "directions is NULL"), {weights, weights != nullptr ? count : 0},
        {values, count * channels}, channels,
        {.degree = o.degree, .method = static_cast<harmonics::FitMethod>(o.method), .regularization = o.regularization},
        adapter.host(), told);
    obc_harmonics_fit_report r{};
    r.method = static_cast<std::int32_t>(told.method);
    r.unknowns = told.unknowns;
    r.rank = told.rank;
    r.condition = told.condition;
    r.residual = told.residual;
    r.iterations = told.iterations;
    capi::write_versioned(report, r);
    std::copy(fitted.values.begin(), fitted.values.end(), coefficients);
  });
}

obc_status obc_harmonics_refinement_report_init(obc_harmonics_refinement_report* report, size_t struct_size) {
  return capi::init_versioned(report, struct_size, obc_harmonics_refinement_report{});
}

obc_status obc_harmonics_refine_map(const double* positions, size_t vertex_count, const uint32_t* triangles,
                                    size_t triangle_count, const double* weights,
                                    const obc_harmonics_fit_options* options, uint32_t rounds, const obc_host* host,
                                    double* directions, obc_harmonics_refinement_report* report, obc_error* error) {
  return capi::guarded(error, [&] {
    const obc_harmonics_fit_options o = capi::copy_versioned(options, default_options());
    checked_size(o.degree, 3);
    capi::require(triangles != nullptr || triangle_count == 0, "triangles is NULL");
    const capi::HostAdapter adapter(host);
    const auto given = vectors(directions, vertex_count, "directions is NULL");
    base::Array<Vector3> moved(given.begin(), given.end(), adapter.host().memory);
    const harmonics::RefinementReport told =
        harmonics::refine_map(vectors(positions, vertex_count, "positions is NULL"),
                              {reinterpret_cast<const harmonics::Triangle*>(triangles), triangle_count},
                              {weights, weights != nullptr ? vertex_count : 0},
                              {.fit = {.degree = o.degree,
                                       .method = static_cast<harmonics::FitMethod>(o.method),
                                       .regularization = o.regularization},
                               .rounds = rounds},
                              moved, adapter.host());
    obc_harmonics_refinement_report r{};
    r.rounds = told.rounds;
    r.residual_before = told.residual_before;
    r.residual = told.residual;
    capi::write_versioned(report, r);
    std::copy_n(moved.front().data(), 3 * vertex_count, directions);
  });
}

obc_status obc_harmonics_synthesize(const double* coefficients, uint32_t degree, size_t channels,
                                    const double* directions, size_t count, const obc_host* host, double* values,
                                    double* gradients, obc_error* error) {
  return capi::guarded(error, [&] {
    const capi::HostAdapter adapter(host);
    const Coefficients given = copy_of(coefficients, degree, channels, adapter.host().memory);
    const auto at = vectors(directions, count, "directions is NULL");
    capi::require(values != nullptr || count == 0, "values is NULL");
    if (gradients == nullptr) {
      harmonics::synthesise(given, at, {values, count * channels}, adapter.host());
    } else {
      harmonics::synthesise_with_gradients(given, at, {values, count * channels},
                                           {reinterpret_cast<Vector3*>(gradients), count * channels}, adapter.host());
    }
  });
}

obc_status obc_harmonics_analyze(const double* directions, const double* weights, const double* values, size_t count,
                                 size_t channels, uint32_t degree, const obc_host* host, double* coefficients,
                                 obc_error* error) {
  return capi::guarded(error, [&] {
    checked_size(degree, channels);
    capi::require(values != nullptr || count == 0, "values is NULL");
    capi::require(coefficients != nullptr, "coefficients is NULL");
    const auto at = vectors(directions, count, "directions is NULL");
    const capi::HostAdapter adapter(host);
    Coefficients sums(degree, channels, adapter.host().memory);
    harmonics::analyse(at, {weights, weights != nullptr ? count : 0}, {values, count * channels}, sums,
                       "analyzing values", adapter.host());
    std::copy(sums.values.begin(), sums.values.end(), coefficients);
  });
}

obc_status obc_harmonics_degree_norms(const double* coefficients, uint32_t degree, size_t channels, double* norms,
                                      obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(norms != nullptr, "norms is NULL");
    harmonics::degree_norms(copy_of(coefficients, degree, channels, std::pmr::get_default_resource()),
                            {norms, std::size_t{degree} + 1});
  });
}

obc_status obc_harmonics_shape_distance(const double* f, uint32_t f_degree, const double* g, uint32_t g_degree,
                                        size_t channels, uint32_t first, uint32_t last, double* distance,
                                        obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(distance != nullptr, "distance is NULL");
    std::pmr::memory_resource* memory = std::pmr::get_default_resource();
    *distance = harmonics::shape_distance(copy_of(f, f_degree, channels, memory),
                                          copy_of(g, g_degree, channels, memory), first, last);
  });
}

obc_status obc_harmonics_filter(double* coefficients, uint32_t degree, size_t channels, uint32_t low, uint32_t high,
                                uint32_t width, int32_t keep_mean, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(low <= high, "low is above high");
    Coefficients given = copy_of(coefficients, degree, channels, std::pmr::get_default_resource());
    harmonics::filter(given, {.low = low, .high = high, .width = width}, keep_mean != 0);
    std::copy(given.values.begin(), given.values.end(), coefficients);
  });
}

obc_status obc_harmonics_rotate(const double* coefficients, uint32_t degree, size_t channels, const double* rotation,
                                const obc_host* host, double* turned, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(rotation != nullptr, "rotation is NULL");
    capi::require(turned != nullptr, "turned is NULL");
    const capi::HostAdapter adapter(host);
    const Coefficients result = harmonics::rotate(copy_of(coefficients, degree, channels, adapter.host().memory),
                                                  Eigen::Map<const RowMajor>(rotation), adapter.host());
    std::copy(result.values.begin(), result.values.end(), turned);
  });
}

obc_status obc_harmonics_align_options_init(obc_harmonics_align_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_align_options());
}

obc_status obc_harmonics_alignment_init(obc_harmonics_alignment* alignment, size_t struct_size) {
  return capi::init_versioned(alignment, struct_size, obc_harmonics_alignment{});
}

obc_status obc_harmonics_align(const double* fixed, uint32_t fixed_degree, const double* moving, uint32_t moving_degree,
                               size_t channels, const obc_harmonics_align_options* options, const obc_host* host,
                               obc_harmonics_alignment* alignment, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(alignment != nullptr, "alignment is NULL");
    const obc_harmonics_align_options o = capi::copy_versioned(options, default_align_options());
    const capi::HostAdapter adapter(host);
    std::pmr::memory_resource* memory = adapter.host().memory;
    const harmonics::Alignment found = harmonics::align(
        copy_of(fixed, fixed_degree, channels, memory), copy_of(moving, moving_degree, channels, memory),
        {.turn_values = o.turn_values != 0, .search_degree = o.search_degree}, adapter.host());
    obc_harmonics_alignment a{};
    Eigen::Map<RowMajor>(a.rotation) = found.rotation;
    Eigen::Map<RowMajor>(a.values) = found.values;
    a.correlation = found.correlation;
    capi::write_versioned(alignment, a);
  });
}

obc_status obc_harmonics_write(const char* path, int32_t format, const double* coefficients, uint32_t degree,
                               size_t channels, obc_error* error) {
  return capi::guarded(error, [&] {
    const harmonics::FileFormat chosen = checked_format(format);
    const Coefficients given = copy_of(coefficients, degree, channels, std::pmr::get_default_resource());
    capi::on_file(path, [&] { harmonics::write_coefficients(path, given, chosen); });
  });
}

obc_status obc_harmonics_read(const char* path, int32_t format, const obc_host* host,
                              obc_harmonics_coefficients** coefficients, obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(coefficients != nullptr, "coefficients is NULL");
    *coefficients = nullptr;
    const harmonics::FileFormat chosen = checked_format(format);
    auto made = std::make_unique<obc_harmonics_coefficients>(host);
    made->coefficients =
        capi::on_file(path, [&] { return harmonics::read_coefficients(path, chosen, made->adapter.host()); });
    *coefficients = made.release();
  });
}

uint32_t obc_harmonics_coefficients_degree(const obc_harmonics_coefficients* coefficients) {
  return coefficients != nullptr ? coefficients->coefficients.degree : 0;
}

size_t obc_harmonics_coefficients_channels(const obc_harmonics_coefficients* coefficients) {
  return coefficients != nullptr ? coefficients->coefficients.channels : 0;
}

obc_status obc_harmonics_coefficients_copy(const obc_harmonics_coefficients* coefficients, double* values,
                                           obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(coefficients != nullptr, "coefficients is NULL");
    capi::require(values != nullptr, "values is NULL");
    std::copy(coefficients->coefficients.values.begin(), coefficients->coefficients.values.end(), values);
  });
}

void obc_harmonics_coefficients_destroy(obc_harmonics_coefficients* coefficients) {
  delete coefficients;
}

uint32_t obc_harmonics_version(void) {
  return static_cast<uint32_t>(base::version_major * 10000 + base::version_minor * 100 + base::version_patch);
}
