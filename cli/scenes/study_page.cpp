#include "scenes/study_page.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "report_page/base64_text.h"
#include "report_page/filled_page.h"
#include "report_page/template.h"

namespace orbicube::cli {
namespace {

using Json = nlohmann::ordered_json;

// Numbers in 65,536 steps from the lowest to the highest that is finite.
Json packed(std::span<const double> values) {
  constexpr double steps = 65535;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (!(low <= high)) low = high = 0;
  const double step = high / steps - low / steps;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(2 * values.size());
  for (const double value : values) {
    const double place = step > 0 ? (value - low) / step : 0;
    const auto number = static_cast<std::uint32_t>(place > 0 ? std::lround(std::min(place, steps)) : 0);
    bytes.push_back(static_cast<std::uint8_t>(number & 255U));
    bytes.push_back(static_cast<std::uint8_t>(number >> 8U));
  }
  return {{"low", low}, {"step", step}, {"values", base64(bytes)}};
}

std::string packed_corners(std::span<const mesh::Triangle> triangles) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(12 * triangles.size());
  for (const mesh::Triangle& triangle : triangles)
    for (const std::uint32_t corner : triangle)
      for (unsigned shift = 0; shift < 32; shift += 8)
        bytes.push_back(static_cast<std::uint8_t>(corner >> shift & 255U));
  return base64(bytes);
}

const char* word_of(MapKind kind) {
  if (kind == MapKind::size) return "size";
  return kind == MapKind::vectors ? "vectors" : "probability";
}

Json json_of(const StudyPageMap& map) {
  Json json = {{"name", map.name}, {"title", map.title}, {"kind", word_of(map.kind)}};
  json.update(packed(map.values));
  return json;
}

Json json_of(const StudyPageShift& shift) {
  Json json = {{"id", shift.id}, {"name", shift.name}, {"unit", shift.unit}, {"limit", shift.limit}};
  json.update(packed(shift.vectors));
  return json;
}

Json json_of(const StudyPageSubject& subject) {
  Json values = Json::array();
  for (const auto& value : subject.values)
    std::visit([&](const auto& each) { values.push_back(each); }, value);
  return {{"name", subject.name},       {"values", std::move(values)}, {"distance", subject.distance},
          {"outlier", subject.outlier}, {"group", subject.group},      {"scores", subject.scores}};
}

template <class Items>
Json array_of(const Items& items) {
  Json array = Json::array();
  for (const auto& item : items)
    array.push_back(json_of(item));
  return array;
}

}  // namespace

std::string study_page(const StudyPage& study) {
  std::vector<double> mean;
  for (const mesh::Vector3& point : study.mean)
    mean.insert(mean.end(), point.begin(), point.end());
  Json failed = Json::array();
  for (const StudyPageFailure& failure : study.failed)
    failed.push_back({{"name", failure.name}, {"text", failure.text}});
  const Json data = {{"summary", study.summary},
                     {"mean", packed(mean)},
                     {"triangles", packed_corners(study.triangles)},
                     {"maps", array_of(study.maps)},
                     {"first_map", study.first_map},
                     {"shifts", array_of(study.shifts)},
                     {"fractions", study.fractions},
                     {"columns", study.columns},
                     {"groups", study.groups},
                     {"subjects", array_of(study.subjects)},
                     {"failed", std::move(failed)}};
  return filled_page(study_template(), study.title, data);
}

}  // namespace orbicube::cli
