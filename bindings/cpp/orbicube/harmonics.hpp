// Spherical harmonics of samples and shapes; wraps orbicube/harmonics.h.
#ifndef ORBICUBE_HARMONICS_HPP
#define ORBICUBE_HARMONICS_HPP

#include <vector>

#include <orbicube/harmonics.h>
#include <orbicube/base.hpp>

namespace orbicube {
inline namespace api {
namespace harmonics {

using FitOptions = detail::Filled<obc_harmonics_fit_options, obc_harmonics_fit_options_init>;
using FitReport = detail::Filled<obc_harmonics_fit_report, obc_harmonics_fit_report_init>;
using RefinementReport = detail::Filled<obc_harmonics_refinement_report, obc_harmonics_refinement_report_init>;
using AlignOptions = detail::Filled<obc_harmonics_align_options, obc_harmonics_align_options_init>;
using Alignment = detail::Filled<obc_harmonics_alignment, obc_harmonics_alignment_init>;

// (degree + 1)^2 * channels numbers, that of Y_lm in channel c at (l*l + l + m) * channels + c.
struct Coefficients {
  std::uint32_t degree = 0;
  std::size_t channels = 0;
  std::vector<double> values;

  Coefficients() = default;
  Coefficients(std::uint32_t degree_, std::size_t channels_)
      : degree(degree_), channels(channels_), values(obc_harmonics_size(degree_) * channels_) {}
  void check() const { detail::check_size(values.size(), obc_harmonics_size(degree) * channels, "coefficients"); }
};

// Y_lm at each direction, (degree + 1)^2 numbers a row.
inline std::vector<double> evaluate(Doubles directions, std::uint32_t degree, Host* host = nullptr) {
  const std::size_t n = detail::rows(directions.size(), 3, "directions");
  std::vector<double> found(n * obc_harmonics_size(degree));
  detail::call(host, [&](obc_error* error) {
    return obc_harmonics_evaluate(directions.data(), n, degree, detail::c(host), found.data(), error);
  });
  return found;
}
inline Coefficients fit(Doubles directions, Doubles values, std::size_t channels, Doubles weights = {},
                        const FitOptions& options = {}, FitReport* report = nullptr, Host* host = nullptr) {
  const std::size_t n = detail::rows(directions.size(), 3, "directions");
  detail::check_size(values.size(), n * channels, "values");
  if (!weights.empty()) detail::check_size(weights.size(), n, "weights");
  Coefficients fitted(options.degree, channels);
  detail::call(host, [&](obc_error* error) {
    return obc_harmonics_fit(directions.data(), weights.data(), values.data(), n, channels, &options, detail::c(host),
                             fitted.values.data(), report, error);
  });
  return fitted;
}
// A sphere map moved to where the surface of the degree of the options comes nearest to the vertices.
inline std::vector<double> refine_map(Doubles positions, Indices triangles, std::vector<double> directions,
                                      std::uint32_t rounds = 10, Doubles weights = {}, const FitOptions& options = {},
                                      RefinementReport* report = nullptr, Host* host = nullptr) {
  const std::size_t n = detail::rows(positions.size(), 3, "positions");
  const std::size_t count = detail::rows(triangles.size(), 3, "triangles");
  detail::check_size(directions.size(), 3 * n, "directions");
  if (!weights.empty()) detail::check_size(weights.size(), n, "weights");
  detail::call(host, [&](obc_error* error) {
    return obc_harmonics_refine_map(positions.data(), n, triangles.data(), count, weights.data(), &options, rounds,
                                    detail::c(host), directions.data(), report, error);
  });
  return directions;
}
inline std::vector<double> synthesize(const Coefficients& of, Doubles directions,
                                      std::vector<double>* gradients = nullptr, Host* host = nullptr) {
  of.check();
  const std::size_t n = detail::rows(directions.size(), 3, "directions");
  std::vector<double> values(n * of.channels);
  if (gradients != nullptr) gradients->resize(3 * n * of.channels);
  detail::call(host, [&](obc_error* error) {
    return obc_harmonics_synthesize(of.values.data(), of.degree, of.channels, directions.data(), n, detail::c(host),
                                    values.data(), gradients == nullptr ? nullptr : gradients->data(), error);
  });
  return values;
}
inline std::vector<double> degree_norms(const Coefficients& of) {
  of.check();
  std::vector<double> norms(of.degree + 1);
  detail::call(nullptr, [&](obc_error* error) {
    return obc_harmonics_degree_norms(of.values.data(), of.degree, of.channels, norms.data(), error);
  });
  return norms;
}
inline double shape_distance(const Coefficients& f, const Coefficients& g, std::uint32_t first, std::uint32_t last) {
  f.check();
  g.check();
  detail::check_size(g.channels, f.channels, "channels");
  double distance = 0;
  detail::call(nullptr, [&](obc_error* error) {
    return obc_harmonics_shape_distance(f.values.data(), f.degree, g.values.data(), g.degree, f.channels, first, last,
                                        &distance, error);
  });
  return distance;
}
// The functions turned with the sphere by a matrix, nine numbers by rows.
inline Coefficients rotate(const Coefficients& of, Doubles rotation, Host* host = nullptr) {
  of.check();
  detail::check_size(rotation.size(), 9, "rotation");
  Coefficients turned(of.degree, of.channels);
  detail::call(host, [&](obc_error* error) {
    return obc_harmonics_rotate(of.values.data(), of.degree, of.channels, rotation.data(), detail::c(host),
                                turned.values.data(), error);
  });
  return turned;
}
inline void filter(Coefficients& of, std::uint32_t low, std::uint32_t high, std::uint32_t width = 0,
                   bool keep_mean = false) {
  of.check();
  detail::call(nullptr, [&](obc_error* error) {
    return obc_harmonics_filter(of.values.data(), of.degree, of.channels, low, high, width, keep_mean ? 1 : 0, error);
  });
}
inline Alignment align(const Coefficients& fixed, const Coefficients& moving, const AlignOptions& options = {},
                       Host* host = nullptr) {
  fixed.check();
  moving.check();
  detail::check_size(moving.channels, fixed.channels, "channels");
  Alignment found;
  detail::call(host, [&](obc_error* error) {
    return obc_harmonics_align(fixed.values.data(), fixed.degree, moving.values.data(), moving.degree, fixed.channels,
                               &options, detail::c(host), &found, error);
  });
  return found;
}
// format: OBC_HARMONICS_BY_ENDING, ...
inline void write(const std::string& path, const Coefficients& of, std::int32_t format = OBC_HARMONICS_BY_ENDING) {
  of.check();
  detail::call(nullptr, [&](obc_error* error) {
    return obc_harmonics_write(path.c_str(), format, of.values.data(), of.degree, of.channels, error);
  });
}
inline Coefficients read(const std::string& path, std::int32_t format = OBC_HARMONICS_BY_ENDING, Host* host = nullptr) {
  const auto handle = detail::take<obc_harmonics_coefficients, obc_harmonics_coefficients_destroy>(
      host, [&](obc_harmonics_coefficients** made, obc_error* error) {
        return obc_harmonics_read(path.c_str(), format, detail::c(host), made, error);
      });
  const obc_harmonics_coefficients* const out = handle.get();
  Coefficients found(obc_harmonics_coefficients_degree(out), obc_harmonics_coefficients_channels(out));
  detail::call(nullptr,
               [&](obc_error* error) { return obc_harmonics_coefficients_copy(out, found.values.data(), error); });
  return found;
}

}  // namespace harmonics
}  // namespace api
}  // namespace orbicube

#endif
