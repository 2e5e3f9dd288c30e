#include <algorithm>

#include "base/error.h"
#include "hexmesh/captured/feature_choice.h"
#include "hexmesh/hexmesh.h"

namespace orbicube::hexmesh {

bool may_have_features(const Options& o) {
  if (o.features != Features::machined) return o.features != Features::off;
  const bool keeps_them =
      can_keep_features() && (o.method == Method::grid || (o.method == Method::automatic && !by_frames(o)));
  return keeps_them && o.padding == Padding::automatic && o.given.target == nullptr;
}

bool by_frames(const Options& options) {
  return options.method == Method::frames || (options.method == Method::automatic && !options.frames.empty());
}

double feature_angle_of(const Options& options) {
  constexpr double of_features = 35;  // many sharp edges of CAD parts with blends turn by less than 40 in places
  const double unset = may_have_features(options) ? of_features : by_frames(options) ? 0 : HexOptions{}.feature_angle;
  return options.feature_angle.value_or(unset);
}

void require_valid(const Options& options, std::size_t vertices) {
  base::require(options.method >= Method::automatic && options.method <= Method::frames, "the method is unknown");
  base::require(options.features >= Features::off && options.features <= Features::machined, "`features` is unknown");
  base::require(options.padding >= Padding::automatic && options.padding <= Padding::without, "the padding is unknown");
  base::require(feature_angle_of(options) >= 0 && feature_angle_of(options) < 180,
                "the feature angle must be from 0 to below 180 degrees");
  const auto known = [&](Index v) { return v < vertices; };
  base::require(std::all_of(options.tagged_vertices.begin(), options.tagged_vertices.end(), known) &&
                    std::all_of(options.tagged_edges.begin(), options.tagged_edges.end(),
                                [&](const mesh::Edge& e) { return known(e[0]) && known(e[1]); }),
                "tagged edges and vertices must be of vertices of the input");
  base::require(options.frames.empty() || by_frames(options), "frames are for the method frames");
  base::require(options.given.target == nullptr || (!by_frames(options) && options.method != Method::grid),
                "a given polycube is for the methods automatic and polycube");
  base::require(options.given.target == nullptr || !may_have_features(options),
                "a given polycube goes without `features`");
}

}  // namespace orbicube::hexmesh
