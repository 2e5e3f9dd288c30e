#include "untangle/tetrahedra/elements.h"

#include <Eigen/Dense>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/search/predicates.h"
#include "mesh/topology/place_text.h"

namespace orbicube::untangle {
namespace {

// Gradients of the barycentric coordinates of a tetrahedron with these edges from its first corner.
void set_gradients(const Eigen::Matrix3d& edges, Element& element) {
  // Rows of the inverse by cross products, which is accurate for slivers too.
  const double determinant = edges.determinant();
  element.gradient[1] = edges.col(1).cross(edges.col(2)) / determinant;
  element.gradient[2] = edges.col(2).cross(edges.col(0)) / determinant;
  element.gradient[3] = edges.col(0).cross(edges.col(1)) / determinant;
  element.gradient[0] = -(element.gradient[1] + element.gradient[2] + element.gradient[3]);
}

}  // namespace

Array<Element> elements_of(std::span<const Tetrahedron> tetrahedra, std::span<const Vector3> rest, double scale,
                           const base::Host& host) {
  constexpr double min_weight = 0.02;
  Array<Element> elements(tetrahedra.size(), host.memory);
  double total = 0;
  Element regular;
  if (rest.empty()) {
    const double r = scale / std::sqrt(2.0);  // every other corner of a cube
    Eigen::Matrix3d edges;
    edges << r, r, 0, r, 0, r, 0, r, r;
    if (edges.determinant() < 0) edges.col(0).swap(edges.col(1));
    set_gradients(edges, regular);
  }
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    if (i % 8192 == 0) host.report("elements", i, tetrahedra.size());
    const Tetrahedron& t = tetrahedra[i];
    Element& element = elements[i];
    if (rest.empty()) {
      element = regular;
      element.weight = 1;
    } else {
      const int sign = mesh::orientation_3d(rest[t[0]], rest[t[1]], rest[t[2]], rest[t[3]]);
      Eigen::Matrix3d edges;
      for (std::size_t k = 0; k < 3; ++k)
        edges.col(static_cast<Eigen::Index>(k)) = scale * (rest[t[k + 1]] - rest[t[0]]);
      const double volume = edges.determinant();
      if (sign < 0)
        throw base::Error("inverted-cell", "tetrahedron " + std::to_string(i) +
                                               " is inverted where shapes come from, at " +
                                               mesh::place_text(rest[t[0]]));
      if (sign == 0 || !(volume > 1e-18 * std::pow(edges.colwise().norm().maxCoeff(), 3)))
        throw base::Error("degenerate-cell", "tetrahedron " + std::to_string(i) +
                                                 " is flat where shapes come from, at " + mesh::place_text(rest[t[0]]));
      set_gradients(edges, element);
      element.weight = volume;
    }
    element.corner = t;
    total += element.weight;
  }
  const double mean = total / static_cast<double>(elements.size());
  for (Element& element : elements)
    element.weight = element.weight / mean + min_weight;
  return elements;
}

}  // namespace orbicube::untangle
