// Surfaces as images and back, in memory and through files.
#include "sphere_map/sampling/geometry_image.h"

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "mesh/search/bounding_volume_tree.h"
#include "mesh/search/distances.h"
#include "mesh/topology/topology.h"
#include "sphere_map/sampling/grids.h"
#include "uneven_maps.h"

using namespace orbicube;
using sphere_map::GeometryImage;
using sphere_map::ImageLayout;

namespace {

// Files in a folder that is removed at the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "geometry-image-XXXXXX").string();
    REQUIRE(mkdtemp(name.data()) != nullptr);
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

GeometryImage image_of(const test::MappedShape& shape, ImageLayout layout, std::size_t resolution) {
  const sphere_map::Locator locator(shape.surface.triangles, shape.directions, base::Host());
  return sphere_map::make_geometry_image(locator, shape.surface.positions, layout, resolution, base::Host());
}

std::string kind_of_reading(const std::filesystem::path& path) {
  try {
    sphere_map::read_geometry_image(path, base::Host());
  } catch (const base::Error& e) {
    return e.kind();
  }
  return "";
}

double diagonal(const mesh::Mesh& m) {
  mesh::Box box;
  for (const auto& p : m.positions)
    box.add(p);
  return (box.high - box.low).norm();
}

}  // namespace

TEST_CASE("An image of a surface gives a closed surface back, near the original, without a gap at the seams") {
  const test::MappedShape shape = test::mapped("blob", 4000);
  for (const auto& [layout, resolution] : {std::pair{ImageLayout::octahedron, 128}, {ImageLayout::cube, 64}}) {
    const GeometryImage image = image_of(shape, layout, static_cast<std::size_t>(resolution));
    const sphere_map::ImageSurface back = sphere_map::surface_of(image, base::Host());
    CHECK(back.seam_gap == 0);
    const mesh::Topology facts = mesh::topology(back.mesh.positions, back.mesh.triangles, base::Host());
    CHECK_NOTHROW(mesh::require_closed_genus_zero(facts));
    const mesh::Topology of_shape = mesh::topology(shape.surface.positions, shape.surface.triangles, base::Host());
    CHECK(facts.volume == doctest::Approx(of_shape.volume).epsilon(0.01));
    const auto distance = mesh::surface_distance(shape.surface.positions, shape.surface.triangles, back.mesh.positions,
                                                 back.mesh.triangles, base::Host());
    // Samples are on the surface; it is as round as a sphere of 128 x 128 quads round its thickest part.
    CHECK(distance.from_second.root_mean_square < 1e-3 * diagonal(shape.surface));
    CHECK(distance.from_first.largest < 0.01 * diagonal(shape.surface));
  }
}

TEST_CASE("Pixels that the cut tears apart hold the same bits") {
  const test::MappedShape shape = test::mapped("creature", 3000);
  const GeometryImage image = image_of(shape, ImageLayout::octahedron, 32);
  const auto at = [&](std::size_t column, std::size_t row) { return image.pixels[row * image.width + column]; };
  for (std::size_t i = 0; i <= 32; ++i) {
    CHECK(at(i, 0) == at(32 - i, 0));
    CHECK(at(i, 32) == at(32 - i, 32));
    CHECK(at(0, i) == at(0, 32 - i));
    CHECK(at(32, i) == at(32, 32 - i));
  }
  CHECK(at(0, 0) == at(32, 32));
  // Tiles of the cube: the right side of +x (tile 0) is the left side of ... the tile that shares its edge. Each edge
  // is in two tiles, each corner in three.
  const GeometryImage cube = image_of(shape, ImageLayout::cube, 8);
  std::map<std::array<double, 3>, int> times;
  for (const mesh::Vector3& p : cube.pixels)
    ++times[{p.x(), p.y(), p.z()}];
  std::array<int, 4> count{};
  for (const auto& [p, n] : times)
    ++count.at(static_cast<std::size_t>(n));
  CHECK(count == std::array<int, 4>{0, 6 * 7 * 7, 12 * 7, 8});
}

TEST_CASE("Images survive their files: float32 for .pfm, a step of 65535 of the box for .png") {
  const Folder folder;
  const test::MappedShape shape = test::mapped("creature", 3000);
  for (const auto& [layout, resolution] : {std::pair{ImageLayout::octahedron, 30}, {ImageLayout::cube, 15}}) {
    const GeometryImage image = image_of(shape, layout, static_cast<std::size_t>(resolution));
    mesh::Box box;
    for (const mesh::Vector3& p : image.pixels)
      box.add(p);
    sphere_map::write_geometry_image(folder / "image.pfm", image, base::Host());
    sphere_map::write_geometry_image(folder / "image.PNG", image, base::Host());
    const GeometryImage pfm = sphere_map::read_geometry_image(folder / "image.pfm", base::Host());
    const GeometryImage png = sphere_map::read_geometry_image(folder / "image.PNG", base::Host());
    for (const GeometryImage* read : {&pfm, &png}) {
      CHECK(read->layout == layout);
      CHECK(read->resolution == image.resolution);
      REQUIRE(read->pixels.size() == image.pixels.size());
      CHECK(sphere_map::surface_of(*read, base::Host()).seam_gap == 0);
    }
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        const volatile float rounded = static_cast<float>(image.pixels[i][k]);
        CHECK(pfm.pixels[i][k] == static_cast<double>(rounded));
        // Half a step of the rounding, and that of the arithmetic.
        const double step = (box.high[k] - box.low[k]) / 65535;
        CHECK(std::abs(png.pixels[i][k] - image.pixels[i][k]) <= 0.5001 * step);
      }
    }
  }
}

TEST_CASE("Damaged and foreign image files are refused with their kind") {
  const Folder folder;
  const test::MappedShape shape = test::mapped("blob", 1000);
  const GeometryImage image = image_of(shape, ImageLayout::octahedron, 8);
  const auto write = [](const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
  };
  const auto read = [](const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  sphere_map::write_geometry_image(folder / "good.pfm", image, base::Host());
  sphere_map::write_geometry_image(folder / "good.png", image, base::Host());
  CHECK(kind_of_reading(folder / "good.pfm") == "");
  CHECK(kind_of_reading(folder / "good.png") == "");
  CHECK(kind_of_reading(folder / "missing.png") == "io");
  CHECK(kind_of_reading(folder / "image.tiff") == "unsupported-format");
  const std::string pfm = read(folder / "good.pfm");
  const std::string png = read(folder / "good.png");
  // Cut anywhere: never read as if it were whole.
  for (std::size_t size = 0; size < pfm.size(); size += 13) {
    write(folder / "cut.pfm", pfm.substr(0, size));
    CHECK(kind_of_reading(folder / "cut.pfm") != "");
  }
  for (std::size_t size = 0; size + 16 < png.size(); size += 13) {  // without its last chunk a PNG is readable
    write(folder / "cut.png", png.substr(0, size));
    CHECK(kind_of_reading(folder / "cut.png") != "");
  }
  for (const char* head : {"PF\n8 8\n-1.0\n", "PF\n9 10\n-1\n", "Pf\n9 9\n-1\n", "PF\n9 9\n0\n", "PF\n9 9\nnan\n",
                           "PF\n9999999999999999999999 9\n-1\n", "PF\n4097 4097\n-1\n", "", "PF", "PF\n-9 9\n1\n"}) {
    write(folder / "head.pfm", head);
    CHECK(kind_of_reading(folder / "head.pfm") != "");
  }
  std::string infinite = pfm;
  infinite.replace(infinite.size() - 4, 4, std::string("\0\0\x80\x7f", 4));
  write(folder / "infinite.pfm", infinite);
  CHECK(kind_of_reading(folder / "infinite.pfm") == "non-finite");
  // Big-endian floats are read as well.
  std::string turned = pfm;
  const std::size_t head = turned.find("-1.0\n") + 5;
  for (std::size_t i = head; i < turned.size(); i += 4)
    std::reverse(turned.begin() + static_cast<std::ptrdiff_t>(i), turned.begin() + static_cast<std::ptrdiff_t>(i + 4));
  turned.replace(head - 5, 4, "1.00");
  write(folder / "turned.pfm", turned);
  CHECK(sphere_map::read_geometry_image(folder / "turned.pfm", base::Host()).pixels ==
        sphere_map::read_geometry_image(folder / "good.pfm", base::Host()).pixels);
}

TEST_CASE("Layouts are known by their sizes, and others are none") {
  CHECK(sphere_map::layout_of_size(3, 3) == ImageLayout::octahedron);
  CHECK(sphere_map::layout_of_size(6, 4) == ImageLayout::cube);
  for (const auto& [w, h] : {std::pair{4, 4}, {1, 1}, {0, 0}, {3, 2}, {6, 6}, {100000001, 100000001}})
    CHECK(!sphere_map::layout_of_size(static_cast<std::size_t>(w), static_cast<std::size_t>(h)));
  CHECK_THROWS_AS(sphere_map::image_size(ImageLayout::octahedron, 5), base::Error);
  CHECK_THROWS_AS(sphere_map::image_size(static_cast<ImageLayout>(7), 4), base::Error);
  GeometryImage wrong(std::pmr::get_default_resource());
  wrong.resolution = 4;
  CHECK_THROWS_AS(sphere_map::surface_of(wrong, base::Host()), base::Error);
}

TEST_CASE("The distance between surfaces is that of a sphere and a larger one") {
  const auto grid = sphere_map::make_grid(sphere_map::GridKind::icosphere, 4, base::Host());
  std::vector<mesh::Vector3> larger;
  for (const mesh::Vector3& d : grid.directions)
    larger.push_back(1.25 * d);
  const auto d = mesh::surface_distance(grid.directions, grid.triangles, larger, grid.triangles, base::Host());
  // The flat triangles are inside of the spheres by up to the square of half an edge over two: 0.0012.
  for (const mesh::Distances& way : {d.from_first, d.from_second}) {
    CHECK(way.mean == doctest::Approx(0.25).epsilon(0.01));
    CHECK(way.root_mean_square >= way.mean);
    CHECK(way.largest < 0.2535);
    CHECK(way.largest >= way.root_mean_square);
  }
  const auto none =
      mesh::surface_distance(grid.directions, grid.triangles, grid.directions, grid.triangles, base::Host());
  CHECK(none.from_first.largest < 1e-15);
}
