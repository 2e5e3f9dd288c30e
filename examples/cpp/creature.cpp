// Maps a shape to the sphere, prints how good the map is, and looks up what lies at the north pole. Returns 0 only when
// the map is a bijection.
#include <array>
#include <cstdio>

#include <orbicube/sphere_map.hpp>

int main(int count, char** arguments) try {
  const orbicube::Mesh mesh = count > 1 ? orbicube::Mesh::read(arguments[1]) : orbicube::Mesh::make("creature", 1000);
  orbicube::Host host;
  int reports = 0;
  host.on_progress([&](const orbicube::Progress&) { return ++reports > 0; });
  const auto map = orbicube::sphere_map::compute(mesh, {}, &host);
  std::printf("%d vertices, %d reports of progress: mean quasi-conformal distortion %.3f\n", int(mesh.vertex_count()),
              reports, map.report.mean_quasi_conformal);

  const orbicube::sphere_map::Locator locator(mesh, map.directions);
  const auto at = locator.sample(std::array<double, 3>{0, 0, 1}, mesh.positions());
  std::printf("at the north pole: %.3f %.3f %.3f\n", at[0], at[1], at[2]);
  return map.report.bijective == 1 && reports > 0 ? 0 : 1;
} catch (const orbicube::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
