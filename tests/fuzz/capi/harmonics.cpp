// Spherical harmonics: directions, weights, values, coefficients and degrees of any kind, and files of any bytes.
#include <algorithm>

#include "orbicube/harmonics.h"
#include "scratch.h"
#include "shapes.h"

using namespace fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input in(data, size);
  Host host(in);
  const std::size_t n = in.below(24), channels = in.below(4);
  const auto degree = static_cast<std::uint32_t>(in.below(7)), other = static_cast<std::uint32_t>(in.below(7));
  const std::size_t length = obc_harmonics_size(degree) * channels, other_length = obc_harmonics_size(other) * channels;
  const auto directions = in.one_in(3) ? in.numbers(3 * n) : in.moderates(3 * n);
  const auto values = in.one_in(3) ? in.numbers(n * channels) : in.moderates(n * channels), weights = in.numbers(n);
  const auto f = in.one_in(3) ? in.numbers(length) : in.moderates(length), g = in.moderates(other_length);
  const auto matrix = in.one_in(2) ? in.numbers(9) : std::vector<double>{0, -1, 0, 1, 0, 0, 0, 0, 1};
  std::vector<double> rows(n * obc_harmonics_size(degree)), found(length), sampled(n * channels),
      slopes(3 * n * channels), norms(degree + 1);

  ok([&](obc_error* e) { return obc_harmonics_evaluate(directions.data(), n, degree, host.c(), rows.data(), e); });
  // Degrees that no array has room for are refused before one is touched.
  require(!ok([&](obc_error* e) {
    return obc_harmonics_evaluate(directions.data(), n, UINT32_MAX - in.byte(), host.c(), rows.data(), e);
  }),
          "a degree of four thousand millions");
  obc_harmonics_fit_options options;
  obc_harmonics_fit_options_init(&options, sizeof options);
  options.degree = degree;
  options.method = in.choice(3);
  options.regularization = in.one_in(3) ? in.number() : 0;
  obc_harmonics_fit_report report;
  obc_harmonics_fit_report_init(&report, sizeof report);
  ok([&](obc_error* e) {
    return obc_harmonics_fit(directions.data(), in.one_in(2) ? weights.data() : nullptr, values.data(), n, channels,
                             &options, host.c(), found.data(), &report, e);
  });
  ok([&](obc_error* e) {
    return obc_harmonics_synthesize(f.data(), degree, channels, directions.data(), n, host.c(), sampled.data(),
                                    slopes.data(), e);
  });
  ok([&](obc_error* e) {
    return obc_harmonics_analyze(directions.data(), in.one_in(2) ? weights.data() : nullptr, values.data(), n, channels,
                                 degree, host.c(), found.data(), e);
  });
  ok([&](obc_error* e) { return obc_harmonics_degree_norms(f.data(), degree, channels, norms.data(), e); });
  double distance = 0;
  ok([&](obc_error* e) {
    return obc_harmonics_shape_distance(f.data(), degree, g.data(), other, channels, in.index(8), in.index(8),
                                        &distance, e);
  });
  auto filtered = f;
  ok([&](obc_error* e) {
    return obc_harmonics_filter(filtered.data(), degree, channels, in.index(8), in.index(8), in.index(8), in.choice(2),
                                e);
  });
  ok([&](obc_error* e) {
    return obc_harmonics_rotate(f.data(), degree, channels, matrix.data(), host.c(), found.data(), e);
  });
  std::vector<std::uint32_t> triangles(3 * in.below(8));
  for (std::uint32_t& index : triangles)
    index = in.index(static_cast<std::uint32_t>(n + 1));
  auto moved = directions;
  obc_harmonics_refinement_report refinement;
  obc_harmonics_refinement_report_init(&refinement, sizeof refinement);
  ok([&](obc_error* e) {
    return obc_harmonics_refine_map(in.moderates(3 * n).data(), n, triangles.data(), triangles.size() / 3, nullptr,
                                    &options, static_cast<std::uint32_t>(in.below(4)), host.c(), moved.data(),
                                    &refinement, e);
  });
  obc_harmonics_align_options aligning;
  obc_harmonics_align_options_init(&aligning, sizeof aligning);
  aligning.turn_values = in.choice(2);
  aligning.search_degree = in.one_in(9) ? in.index(80) : 1 + static_cast<std::uint32_t>(in.below(6));
  if (aligning.search_degree > 8 && aligning.search_degree <= 64)
    aligning.search_degree = 8;  // its fourth power is time
  obc_harmonics_alignment alignment;
  obc_harmonics_alignment_init(&alignment, sizeof alignment);
  if (ok([&](obc_error* e) {
        return obc_harmonics_align(f.data(), degree, g.data(), other, channels, &aligning, host.c(), &alignment, e);
      }))
    require_finite(alignment.rotation, "a rotation that is not finite");
  if (!in.one_in(4)) return 0;
  const Scratch file(in.one_in(2) ? ".coef" : in.one_in(2) ? ".shtools" : ".txt");
  if (in.one_in(2)) {
    std::vector<std::uint8_t> text;
    for (const std::uint8_t byte : in.rest())
      text.push_back(static_cast<std::uint8_t>(" \n0123456789.,{}-+eE#"[byte % 21]));
    file.write(text);
  } else if (!ok([&](obc_error* e) {
               return obc_harmonics_write(file.path(), in.choice(3), f.data(), degree, channels, e);
             })) {
    file.write(in.rest());
  }
  obc_harmonics_coefficients* read = nullptr;
  if (ok([&](obc_error* e) { return obc_harmonics_read(file.path(), in.choice(3), host.c(), &read, e); })) {
    std::vector<double> copied(obc_harmonics_size(obc_harmonics_coefficients_degree(read)) *
                               obc_harmonics_coefficients_channels(read));
    require(ok([&](obc_error* e) { return obc_harmonics_coefficients_copy(read, copied.data(), e); }),
            "coefficients cannot be copied");
    require_finite(copied, "a coefficient that is not finite");
    obc_harmonics_coefficients_destroy(read);
  }
  return 0;
}
