// The C functions for points, curves and sharp edges that must be mapped to target positions.
#include <algorithm>
#include <cstddef>
#include <vector>

#include "capi/src/polycube_handle.h"
#include "polycube/features/features.h"

using namespace orbicube;

namespace {

using mesh::Index;
using mesh::Vector3;

obc_polycube_feature_options default_feature_options() {
  obc_polycube_feature_options o{};
  o.struct_size = sizeof o;
  return o;
}

double weight_of(const double* weights, size_t i) {
  return weights == nullptr ? 0 : weights[i];
}

std::vector<polycube::FeaturePoint> points_of(const obc_polycube_feature_options& o) {
  capi::require(o.point_count == 0 || (o.points != nullptr && o.targets != nullptr), "points or targets is NULL");
  std::vector<polycube::FeaturePoint> result;
  for (size_t i = 0; i < o.point_count; ++i)
    result.push_back({o.points[i], Vector3(o.targets[3 * i], o.targets[3 * i + 1], o.targets[3 * i + 2]),
                      weight_of(o.point_weights, i)});
  return result;
}

std::vector<polycube::FeatureCurve> curves_of(const obc_polycube_feature_options& o) {
  std::vector<polycube::FeatureCurve> result;
  if (o.curve_count == 0) return result;
  capi::require(o.curve_starts != nullptr && o.curve_vertices != nullptr && o.curve_lines != nullptr,
                "curve_starts, curve_vertices or curve_lines is NULL");
  for (size_t i = 0; i < o.curve_count; ++i) {
    const double* const line = o.curve_lines + 6 * i;
    capi::require(o.curve_starts[i] <= o.curve_starts[i + 1], "curve_starts must not fall");
    result.push_back({{o.curve_vertices + o.curve_starts[i], o.curve_starts[i + 1] - o.curve_starts[i]},
                      Vector3(line[0], line[1], line[2]),
                      Vector3(line[3], line[4], line[5]),
                      weight_of(o.curve_weights, i)});
  }
  return result;
}

obc_polycube_feature_report to_report(const polycube::FeatureFit& from) {
  obc_polycube_feature_report report{};
  const auto largest = [](const auto& of) { return of.empty() ? 0 : *std::max_element(of.begin(), of.end()); };
  report.distance_before = largest(from.distances_before);
  report.distance = largest(from.distances);
  report.sharp_length = from.sharp_length;
  report.sharp_before = from.sharp_before;
  report.sharp = from.sharp;
  capi::set_distortion(from.distortion, report);
  return report;
}

}  // namespace

obc_status obc_polycube_feature_options_init(obc_polycube_feature_options* options, size_t struct_size) {
  return capi::init_versioned(options, struct_size, default_feature_options());
}

obc_status obc_polycube_align_features(const obc_polycube* map, const obc_polycube_feature_options* options,
                                       const obc_host* host, obc_polycube_feature_report* report, obc_polycube** out,
                                       obc_error* error) {
  return capi::guarded(error, [&] {
    capi::require(out != nullptr, "out is NULL");
    *out = nullptr;
    capi::require(map != nullptr, "map is NULL");
    const obc_polycube_feature_options o = capi::copy_versioned(options, default_feature_options());
    const auto points = points_of(o);
    const auto curves = curves_of(o);
    const polycube::FeatureOptions features = {.points = points, .curves = curves, .feature_angle = o.feature_angle};
    capi::changed_copy(
        *map, host, out,
        [&](polycube::SurfaceMap& copy, const base::Host& on) { return polycube::align_features(copy, features, on); },
        [&](const polycube::FeatureFit& found) { capi::write_versioned(report, to_report(found)); });
  });
}
