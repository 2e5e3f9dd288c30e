#include "morphs/morph_placement.h"

#include <vector>

#include "correspondence/pose.h"

namespace orbicube::cli {

Json json_of(const Eigen::Matrix3d& rotation) {
  Json rows = Json::array();
  for (Eigen::Index row = 0; row < 3; ++row)
    rows.push_back({rotation(row, 0), rotation(row, 1), rotation(row, 2)});
  return rows;
}

void place_states(const std::string& how, std::span<const mesh::Triangle> triangles,
                  std::span<base::Array<mesh::Vector3>> states, std::span<Json* const> figures) {
  using correspondence::Pose;
  const Pose pose = how == "scaled" ? Pose::scaled : how == "turned" ? Pose::turned : Pose::kept;
  const std::vector<correspondence::Similarity> placed = correspondence::place(pose, triangles, states);
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const mesh::Vector3& shift = placed[i].shift;
    (*figures[i])["placement"] = {{"scale", placed[i].scale},
                                  {"rotation", json_of(placed[i].rotation)},
                                  {"shift", {shift[0], shift[1], shift[2]}}};
  }
}

}  // namespace orbicube::cli
