#include "gltf/writing/morph_data.h"

#include <cmath>
#include <utility>

#include "base/error.h"
#include "gltf/writing/morph.h"

namespace orbicube::gltf {

base::Array<float> deltas_of(std::span<const float> base, std::span<const float> wanted, const base::Host& host) {
  base::Array<float> deltas(base.size(), host.memory);
  constexpr std::size_t values_between_reports = std::size_t{1} << 17U;
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (i % values_between_reports == 0) host.report("making morph targets", i, base.size());
    deltas[i] = delta_for(base[i], wanted[i]);
    if (!std::isfinite(deltas[i]))
      throw base::Error("invalid-argument", "differences of a morph target are not finite");
  }
  return deltas;
}

AnimationAccessors add_animation(BinaryBuffer& buffer, const Scene& scene, const base::Host& host) {
  const std::size_t targets = scene.morph_targets.size();
  base::Array<float> times(host.memory);
  base::Array<float> weights((targets + 2) * targets, 0.0F, host.memory);
  for (std::size_t key = 0; key < targets + 2; ++key)
    times.push_back(static_cast<float>(scene.morph_seconds * static_cast<double>(key)));
  for (std::size_t target = 0; target < targets; ++target)
    weights[(target + 1) * targets + target] = 1;
  return {buffer.add_floats(std::move(times), 1, true, BinaryBuffer::Target::none),
          buffer.add_floats(std::move(weights), 1, false, BinaryBuffer::Target::none)};
}

}  // namespace orbicube::gltf
