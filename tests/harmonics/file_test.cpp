// Files of coefficients: what other programs mean by theirs, round trips, and damage.
#include "harmonics/functions/coefficient_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "harmonics/functions/basis.h"
#include "samples.h"
#include "tests/base/quiet_host.h"

using namespace orbicube;
using namespace orbicube::harmonics;
using std::numbers::pi;
using test::host;

namespace {

Coefficients parsed(const std::string& text, FileFormat format) {
  return parse_coefficients(std::as_bytes(std::span(text)), format, host);
}

struct Angles {
  double theta, phi;
  Vector3 direction;
};

std::vector<Angles> angles(std::uint64_t seed) {
  Samples samples(seed);
  std::vector<Angles> all;
  for (int k = 0; k < 20; ++k) {
    const double theta = pi * samples.uniform(), phi = 2 * pi * samples.uniform();
    all.push_back(
        {theta, phi, Vector3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta))});
  }
  return all;
}

double value_at(const Coefficients& f, const Vector3& d, std::size_t channel) {
  std::vector<double> values(f.channels);
  synthesise(f, std::vector<Vector3>{d}, values, host);
  return values[channel];
}

void kind_is(const std::string& text, FileFormat format, const std::string& kind, const std::string& message) {
  CAPTURE(text);
  try {
    parsed(text, format);
    FAIL("was read");
  } catch (const base::Error& error) {
    CHECK(error.kind() == kind);
    CHECK(std::string(error.what()).find(message) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("SHTOOLS's coefficients mean the sum that its manual gives") {
  // f = sum over l, m of (C cos m phi + S sin m phi) P, with P normalized so that the mean square of a function is 1
  // and without the phase that the standard library's version has.
  const std::string text =
      "# made for this test\n"
      "0, 0, 1.5, 0\n1, 0, -0.5, 0\n1, 1, 0.25, 2\n2, 0, 0.125, 0\n2, 1, 3, -1\n2, 2, 0.75, 1e-1\n";
  const double c[3][3] = {{1.5}, {-0.5, 0.25}, {0.125, 3, 0.75}}, s[3][3] = {{0}, {0, 2}, {0, -1, 0.1}};
  const Coefficients f = parsed(text, FileFormat::shtools);
  REQUIRE(f.degree == 2);
  REQUIRE(f.channels == 1);
  for (const Angles& at : angles(51)) {
    double sum = 0;
    for (unsigned l = 0; l <= 2; ++l) {
      for (unsigned m = 0; m <= l; ++m) {
        const double p = std::sqrt(4 * pi) * (m > 0 ? std::numbers::sqrt2 : 1) * (m % 2 == 0 ? 1 : -1) *
                         std::sph_legendre(l, m, at.theta);
        sum += p * (c[l][m] * std::cos(m * at.phi) + s[l][m] * std::sin(m * at.phi));
      }
    }
    CHECK(std::abs(value_at(f, at.direction, 0) - sum) < 1e-13);
  }
}

TEST_CASE("SPHARM-PDM's coefficients mean the sum that it evaluates") {
  const std::string text =
      "{ 9,{1, 2, 3},{0.5, 0.25, -1},\n{4, 5, 6},\n{-7, 8, 9},\n{0.1, 0.2, 0.3},\n{1, 0, 0},\n{0, 1, 0},{0, 0, 1},{2, "
      "-3, 4}}";
  const double triple[9][3] = {{1, 2, 3}, {0.5, 0.25, -1}, {4, 5, 6}, {-7, 8, 9}, {0.1, 0.2, 0.3},
                               {1, 0, 0}, {0, 1, 0},       {0, 0, 1}, {2, -3, 4}};
  const Coefficients f = parsed(text, FileFormat::spharm_pdm);
  REQUIRE(f.degree == 2);
  REQUIRE(f.channels == 3);
  for (const Angles& at : angles(52)) {
    for (std::size_t coordinate = 0; coordinate < 3; ++coordinate) {
      double sum = 0;
      for (unsigned l = 0; l <= 2; ++l) {
        // The standard library's function has the phase, as SPHARM-PDM's has.
        sum += triple[l * l][coordinate] * std::sph_legendre(l, 0, at.theta);
        for (unsigned m = 1; m <= l; ++m) {
          sum += std::sph_legendre(l, m, at.theta) * (std::cos(m * at.phi) * triple[l * l + 2 * m - 1][coordinate] +
                                                      std::sin(m * at.phi) * triple[l * l + 2 * m][coordinate]);
        }
      }
      CHECK(std::abs(value_at(f, at.direction, coordinate) - sum) < 1e-13);
    }
  }
}

TEST_CASE("What is written is read again, to the last bits, in both formats and at high degree") {
  Samples samples(53);
  for (const std::uint32_t degree : {0U, 1U, 5U, 120U}) {
    for (const FileFormat format : {FileFormat::shtools, FileFormat::spharm_pdm}) {
      Coefficients f = samples.coefficients(degree, 3);
      f.values[0] = 1e-300;
      f.values[1] = -1e200;
      const Coefficients g = parsed(format_coefficients(f, format), format);
      REQUIRE(g.degree == degree);
      REQUIRE(g.channels == 3);
      bool close = true;
      for (std::size_t i = 0; i < f.values.size(); ++i)
        close = close && std::abs(f.values[i] - g.values[i]) <= 4e-16 * std::abs(f.values[i]);
      CHECK(close);
    }
  }
  const Coefficients one = samples.coefficients(3, 1);
  CHECK(max_difference(parsed(format_coefficients(one, FileFormat::shtools), FileFormat::shtools), one) < 1e-15);
  CHECK_THROWS_AS(format_coefficients(one, FileFormat::spharm_pdm), base::Error);
}

TEST_CASE("SHTOOLS files of other programs are read: headers, errors, blanks, Fortran's exponents, from degree 1") {
  const Coefficients f = parsed(
      "0.17380000E+04, 0.49028002E+04, 0.73047000E-05,  1,  1\r\n"
      "1,    0,  0.5D+01,  0.00000000E+00, 0.1E-03, 0.1E-03\r\n\r\n"
      "1,    1,  -2.0000E0,  +0.25d-1, 0.1E-03, 0.1E-03",
      FileFormat::shtools);
  const double root = std::sqrt(4 * pi);
  CHECK(f.degree == 1);
  CHECK(f.at(0, 0, 0) == 0);
  CHECK(f.at(1, 0, 0) == doctest::Approx(5 * root).epsilon(1e-15));
  CHECK(f.at(1, 1, 0) == doctest::Approx(-2 * root).epsilon(1e-15));
  CHECK(f.at(1, -1, 0) == doctest::Approx(0.025 * root).epsilon(1e-15));
  CHECK(parsed("0 0 1 0\n1 0 2 0\n1 1 3 4\n", FileFormat::shtools).at(1, -1, 0) ==
        doctest::Approx(4 * root).epsilon(1e-15));
}

TEST_CASE("Damaged SHTOOLS files are refused with kind and line") {
  const FileFormat format = FileFormat::shtools;
  kind_is("", format, "empty-file", "empty");
  kind_is("# nothing\n", format, "bad-magic", "no coefficients");
  kind_is("one\ntwo\nthree\n", format, "bad-magic", "line 3");
  kind_is("0, 0, 1, 0\n1, 0, 1, 0\n", format, "truncated", "degree 1 end before order 1");
  kind_is("0, 0, 1, 0\n1, 0, 1", format, "truncated", "line 2");
  kind_is("0, 0, 1, 0\n1, 0, 1\n1, 1, 1, 1\n", format, "parse", "line 2");
  kind_is("0, 0, 1, 0\n1, 1, 1, 0\n", format, "parse", "degree 1, order 0 expected, found 1, 1");
  kind_is("0, 0, 1, 0\n1, 0, x, 0\n", format, "parse", "'x'");
  kind_is("0, 0, 1, 0\n1, 0, nan, 0\n", format, "non-finite", "line 2");
  kind_is("0, 0, 1, 0\n1, 0, 1e999, 0\n", format, "non-finite", "1e999");
  kind_is("0, 0, 1, 0\n1.5, 0, 1, 0\n", format, "parse", "whole number");
  kind_is("0, 0, 1, 0\nx, 0, 1, 0\n", format, "parse", "'x'");
  kind_is("0, 0, 1, 0\n1, 0, 1, 0\n1, 1, 0, 0\n0, 0, 1, 0\n", format, "truncated", "block 2");
  kind_is("4000000000, 0, 1, 0\n", format, "unsupported", "degree 4000000000");
  kind_is(std::string("0, 0, 1,\0 0\n", 12), format, "parse", "NUL");
}

TEST_CASE("Damaged SPHARM-PDM files are refused with kind and line") {
  const FileFormat format = FileFormat::spharm_pdm;
  kind_is("", format, "empty-file", "empty");
  kind_is("9,{1,2,3}", format, "bad-magic", "'{'");
  kind_is("{ 2,{1,2,3},{1,2,3}}", format, "parse", "(L + 1)^2");
  kind_is("{ 0}", format, "parse", "(L + 1)^2");
  kind_is("{ 4,{1,2,3},{1,2,3}}", format, "truncated", "too short");
  kind_is("{ 4,{1,2,3},{1,2,3},\n{1,2,3}                }", format, "parse", "line 2: expected ','");
  kind_is("{ 4,{1,2,3},{1,2,3},\n{1,2,3},{1,2", format, "truncated", "line 2");
  kind_is("{ 1,{1,2,x}}", format, "parse", "'x'");
  kind_is("{ 1,{1,inf,3}}", format, "non-finite", "inf");
  kind_is("{ 1,{1,2,3}} more", format, "trailing-data", "more follows");
  kind_is("{ 1,{1,2,3}", format, "truncated", "'}'");
  kind_is("{ 1.5,{1,2,3}}", format, "parse", "whole number");
  kind_is("{ 9000000000000000000,{1,2,3}}", format, "unsupported", "degree");
}

TEST_CASE("Every cut of a file is refused, or is one that ends between two blocks") {
  const Coefficients f = Samples(54).coefficients(2, 3);
  for (const FileFormat format : {FileFormat::shtools, FileFormat::spharm_pdm}) {
    const std::string text = format_coefficients(f, format);
    for (std::size_t length = 0; length + 1 < text.size(); ++length) {
      try {
        const Coefficients g = parsed(text.substr(0, length), format);
        // Fewer or shorter blocks, or the last number without its last digits: nothing else can be told.
        CHECK(format == FileFormat::shtools);
        CHECK(g.degree <= 2);
      } catch (const base::Error& error) {
        CHECK(error.status() == base::Status::malformed_file);
      }
    }
  }
}

TEST_CASE("Files on the disk: the format is that of the ending") {
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "orbicube-coefficient-test";
  std::filesystem::create_directories(folder);
  const Coefficients f = Samples(55).coefficients(4, 3);
  for (const char* name : {"a.sh", "b.SHTOOLS", "c.txt", "d.coef"}) {
    write_coefficients(folder / name, f, FileFormat::by_ending);
    CHECK(max_difference(read_coefficients(folder / name, FileFormat::by_ending, host), f) < 1e-15);
  }
  CHECK_THROWS_AS(write_coefficients(folder / "e.obj", f, FileFormat::by_ending), base::Error);
  CHECK_THROWS_AS(read_coefficients(folder / "missing.sh", FileFormat::by_ending, host), base::Error);
  CHECK_THROWS_AS(read_coefficients(folder / "a.sh", FileFormat::spharm_pdm, host), base::Error);
  std::filesystem::remove_all(folder);
}
