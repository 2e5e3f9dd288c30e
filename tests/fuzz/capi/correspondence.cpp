// Two surfaces, closed or not, on one triangulation.
#include "orbicube/correspondence.h"
#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const Shape first = surface(in), second = surface(in);
  const obc_surface given[2] = {first.surface(), second.surface()};
  obc_correspondence_options options;
  obc_correspondence_options_init(&options, sizeof options);
  if (in.one_in(2)) {
    options.via = in.choice(1);
    options.align = in.choice(2);
    options.grid = in.choice(1);
    options.placement = in.choice(2);
    options.tolerance = in.number();
    options.cells = 100;
  }
  obc_correspondence* made = nullptr;
  if (!ok([&](obc_error* e) { return obc_correspondence_create(given, 2, &options, host.c(), &made, e); })) return 0;
  const std::size_t vertices = obc_correspondence_vertex_count(made);
  std::vector<double> positions(3 * vertices), weights = in.numbers(2);
  std::vector<std::uint32_t> triangles(3 * obc_correspondence_triangle_count(made));
  require(ok([&](obc_error* e) { return obc_correspondence_copy(made, 1, positions.data(), triangles.data(), e); }),
          "a correspondence cannot be copied");
  require_finite(positions, "a position that is not finite");
  require_below(triangles, vertices, "a triangle with a vertex that does not exist");
  ok([&](obc_error* e) { return obc_correspondence_blend(made, weights.data(), 2, positions.data(), e); });
  obc_correspondence_destroy(made);
  return 0;
}
