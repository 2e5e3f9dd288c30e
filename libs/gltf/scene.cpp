#include "gltf/scene.h"

#include <array>
#include <cmath>
#include <string>

#include "base/error.h"

namespace orbicube::gltf {

namespace {

template <std::size_t count>
std::array<double, count> numbers(JsonValue array) {
  std::array<double, count> result{};
  std::size_t found = 0;
  array.for_each_element([&](JsonValue value) {
    if (found < count) result[found] = value.number();
    ++found;
  });
  if (found != count) throw base::Error("parse", array.path() + " does not have " + std::to_string(count) + " numbers");
  return result;
}

Eigen::Affine3d local_transform(JsonValue node) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  if (const JsonValue matrix = node.member("matrix")) {
    const std::array<double, 16> columns = numbers<16>(matrix);
    result.matrix() = Eigen::Map<const Eigen::Matrix4d>(columns.data());
    if (result.matrix().row(3) != Eigen::RowVector4d(0, 0, 0, 1))
      throw base::Error("parse", matrix.path() + " is not affine: its last row is not 0 0 0 1");
    return result;
  }
  if (const JsonValue translation = node.member("translation"))
    result.translation() = Eigen::Vector3d(numbers<3>(translation).data());
  if (const JsonValue rotation = node.member("rotation")) {
    const std::array<double, 4> xyzw = numbers<4>(rotation);
    Eigen::Quaterniond quaternion(xyzw[3], xyzw[0], xyzw[1], xyzw[2]);
    // Files hold unit quaternions to the precision of floats; a rotation that also scaled would be no rotation.
    const double norm = quaternion.norm();
    if (!(std::abs(norm - 1) < 0.01)) throw base::Error("parse", rotation.path() + " is not a unit quaternion");
    quaternion.coeffs() /= norm;
    // The identity must leave positions as they are to the bit.
    if (!quaternion.vec().isZero(0)) result.linear() = quaternion.toRotationMatrix();
  }
  if (const JsonValue scale = node.member("scale"))
    result.linear() = result.linear() * Eigen::Vector3d(numbers<3>(scale).data()).asDiagonal();
  return result;
}

// The sign of the determinant, whose own value may be beyond the range of doubles. Throws when it is zero.
bool is_mirror(const Eigen::Affine3d& transform, JsonValue node) {
  if (!transform.matrix().allFinite())
    throw base::Error("non-finite", node.path() + ": its transform is beyond the range of numbers");
  Eigen::Matrix3d columns = transform.linear();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const double largest = columns.col(axis).cwiseAbs().maxCoeff();
    if (largest > 0) columns.col(axis) /= largest;
  }
  const double determinant = columns.determinant();
  if (determinant == 0) throw base::Error("degenerate-geometry", node.path() + ": its transform flattens the mesh");
  return determinant < 0;
}

// Walks the graph depth first, children in order, each node once.
class Walk {
 public:
  explicit Walk(const Asset& asset)
      : asset_(asset),
        visited_(asset.nodes().size(), false, asset.host().memory),
        pending_(asset.host().memory),
        placements_(asset.host().memory) {}

  // A root node and all below it.
  void from(JsonValue index) {
    asset_.nodes().at(index, "index-range");
    from(static_cast<std::size_t>(index.unsigned_integer()));
  }

  void from(std::size_t root) {
    pending_.push_back({root, Eigen::Affine3d::Identity()});
    while (!pending_.empty()) {
      const Pending next = pending_.back();
      pending_.pop_back();
      visit(next.node, next.parent_to_world);
    }
  }

  base::Array<Placement> take() { return std::move(placements_); }

 private:
  struct Pending {
    std::size_t node;
    Eigen::Affine3d parent_to_world;
  };

  void visit(std::size_t index, const Eigen::Affine3d& parent_to_world) {
    const JsonValue node = asset_.nodes()[index];
    if (visited_[index]) throw base::Error("parse", node.path() + " is reached twice: the nodes are not a tree");
    visited_[index] = true;
    if (++steps_ % 1024 == 0) asset_.host().report("reading nodes", steps_, asset_.nodes().size());
    const Eigen::Affine3d to_world = parent_to_world * local_transform(node);
    if (const JsonValue mesh = node.member("mesh")) {
      const bool skinned = static_cast<bool>(node.member("skin"));
      const Eigen::Affine3d used = skinned ? Eigen::Affine3d::Identity() : to_world;
      placements_.push_back({asset_.meshes().at(mesh, "index-range"), used, is_mirror(used, node), skinned});
    }
    const JsonValue children = node.member("children");
    if (!children) return;
    const std::size_t first = pending_.size();
    children.for_each_element([&](JsonValue child) {
      asset_.nodes().at(child, "index-range");
      pending_.push_back({static_cast<std::size_t>(child.unsigned_integer()), to_world});
    });
    std::reverse(pending_.begin() + static_cast<std::ptrdiff_t>(first), pending_.end());
  }

  const Asset& asset_;
  base::Array<bool> visited_;
  base::Array<Pending> pending_;
  base::Array<Placement> placements_;
  std::uint64_t steps_ = 0;
};

// Marks every node that is somebody's child.
base::Array<bool> children_of_nodes(const Asset& asset) {
  base::Array<bool> is_child(asset.nodes().size(), false, asset.host().memory);
  for (std::size_t i = 0; i < asset.nodes().size(); ++i) {
    const JsonValue children = asset.nodes()[i].member("children");
    if (!children) continue;
    children.for_each_element([&](JsonValue child) {
      asset.nodes().at(child, "index-range");
      is_child[static_cast<std::size_t>(child.unsigned_integer())] = true;
    });
  }
  return is_child;
}

}  // namespace

base::Array<Placement> place_meshes(const Asset& asset) {
  Walk walk(asset);
  if (asset.scenes().size() > 0) {
    const JsonValue named = asset.root().member("scene");
    const JsonValue scene = named ? asset.scenes().at(named, "index-range") : asset.scenes()[0];
    if (const JsonValue roots = scene.member("nodes")) roots.for_each_element([&](JsonValue root) { walk.from(root); });
    return walk.take();
  }
  if (asset.nodes().size() > 0) {
    const base::Array<bool> is_child = children_of_nodes(asset);
    for (std::size_t i = 0; i < is_child.size(); ++i) {
      if (!is_child[i]) walk.from(i);
    }
    return walk.take();
  }
  base::Array<Placement> all(asset.host().memory);
  for (std::size_t i = 0; i < asset.meshes().size(); ++i)
    all.push_back({asset.meshes()[i], Eigen::Affine3d::Identity(), false, false});
  return all;
}

}  // namespace orbicube::gltf
