#include "gltf/reading/scene.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.h"

namespace orbicube::gltf {

namespace {

std::string node_place(std::size_t node) {
  return place_of("nodes", node);
}

// check_structure has counted their numbers.
Eigen::Affine3d local_transform(const tiny::Node& node, std::size_t index) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if (!node.matrix.empty()) {
    result.matrix() = Eigen::Map<const Eigen::Matrix4d>(node.matrix.data());
    if (result.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      throw base::Error("parse", node_place(index) + ".matrix is not affine: its last row is not 0 0 0 1");
    return result;
  }
  if (!node.translation.empty()) result.translation() = Eigen::Vector3d(node.translation.data());
  if (!node.rotation.empty()) {
    const std::vector<double>& xyzw = node.rotation;
    Eigen::Quaterniond quaternion(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    // Files hold unit quaternions to the precision of floats; a rotation that also scaled would be no rotation.
    const double norm = quaternion.norm();
    if (!(std::abs(norm - 1) < 0.01))
      throw base::Error("parse", node_place(index) + ".rotation is not a unit quaternion");
    quaternion.coeffs() /= norm;
    // The identity must leave positions as they are to the bit.
    if (!quaternion.vec().isZero(0)) result.linear() = quaternion.toRotationMatrix();
  }
  if (!node.scale.empty()) result.linear() = result.linear() * Eigen::Vector3d(node.scale.data()).asDiagonal();
  return result;
}

// The sign of the determinant, whose own value may be beyond the range of doubles. Throws when it is zero.
bool is_mirror(const Eigen::Affine3d& transform, std::size_t node) {
  if (!transform.matrix().allFinite())
    throw base::Error("non-finite", node_place(node) + ": its transform is beyond the range of numbers");
  Eigen::Matrix3d columns = transform.linear();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double largest = columns.col(axis).cwiseAbs().maxCoeff();
    if (largest > 0) columns.col(axis) /= largest;
  }
  const double determinant = columns.determinant();
  if (determinant == 0)
    throw base::Error("degenerate-geometry", node_place(node) + ": its transform flattens the mesh");
  return determinant < 0;
}

// Walks the graph depth first, children in order, each node once.
class Walk {
 public:
  explicit Walk(const Asset& asset)
      : asset_(asset),
        nodes_(asset.model().nodes),
        visited_(nodes_.size(), false, asset.host().memory),
        pending_(asset.host().memory),
        placements_(asset.host().memory) {}

  // A root node and all below it; `where` is what names it.
  void from(int root, const std::string& where) {
    require_index(root, nodes_.size(), "nodes", where);
    pending_.push_back({static_cast<std::size_t>(root), Eigen::Affine3d::Identity()});
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      visit(next.node, next.parent_to_world);
    }
  }

  Placements take() { return {std::move(placements_), hidden_, first_hidden_}; }

 private:
  struct Pending {
    std::size_t node;
    Eigen::Affine3d parent_to_world;
  };

  void visit(std::size_t index, const Eigen::Affine3d& parent_to_world) {
    const tiny::Node& node = nodes_[index];
    if (visited_[index]) throw base::Error("parse", node_place(index) + " is reached twice: the nodes are not a tree");
    visited_[index] = true;
    if (++steps_ % 1024 == 0) asset_.host().report("reading nodes", steps_, nodes_.size());
    const Eigen::Affine3d to_world = parent_to_world * local_transform(node, index);
    if (node.mesh >= 0) {
      const bool skinned = node.skin >= 0;
      const Eigen::Affine3d used = skinned ? Eigen::Affine3d::Identity() : to_world;
      require_index(node.mesh, asset_.model().meshes.size(), "meshes", node_place(index) + ".mesh");
      if (used.linear().isZero(0)) {
        if (hidden_++ == 0) first_hidden_ = index;
      } else {
        placements_.push_back({static_cast<std::size_t>(node.mesh), index, used, is_mirror(used, index), skinned});
      }
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child) {
      require_index(*child, nodes_.size(), "nodes", node_place(index) + ".children");
      pending_.push_back({static_cast<std::size_t>(*child), to_world});
    }
  }

  const Asset& asset_;
  const std::vector<tiny::Node>& nodes_;
  base::Array<bool> visited_;
  base::Array<Pending> pending_;
  base::Array<Placement> placements_;
  std::size_t hidden_ = 0, first_hidden_ = no_node;
  std::uint64_t steps_ = 0;
};

// Marks every node that is somebody's child.
base::Array<bool> children_of_nodes(const Asset& asset) {
  const std::vector<tiny::Node>& nodes = asset.model().nodes;
  base::Array<bool> is_child(nodes.size(), false, asset.host().memory);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int child : nodes[i].children) {
      require_index(child, nodes.size(), "nodes", node_place(i) + ".children");
      is_child[static_cast<std::size_t>(child)] = true;
    }
  }
  return is_child;
}

}  // namespace

Placements place_meshes(const Asset& asset) {
  const tiny::Model& model = asset.model();
  Walk walk(asset);
  if (!model.scenes.empty()) {
    if (model.defaultScene >= 0) require_index(model.defaultScene, model.scenes.size(), "scenes", "scene");
    const auto scene = static_cast<std::size_t>(std::max(model.defaultScene, 0));
    for (const int root : model.scenes[scene].nodes)
      walk.from(root, place_of("scenes", scene) + ".nodes");
    return walk.take();
  }
  if (!model.nodes.empty()) {
    const base::Array<bool> is_child = children_of_nodes(asset);
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) walk.from(static_cast<int>(i), "");
    }
    return walk.take();
  }
  base::Array<Placement> all(asset.host().memory);
  for (std::size_t i = 0; i < model.meshes.size(); ++i)
    all.push_back({i, no_node, Eigen::Affine3d::Identity(), false, false});
  return {std::move(all), 0, no_node};
}

}  // namespace orbicube::gltf
