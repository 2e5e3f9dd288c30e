#include "harmonics/functions/coefficient_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/counted.h"
#include "base/files/file.h"
#include "harmonics/functions/field_scanner.h"

namespace orbicube::harmonics {
namespace {

const double four_pi_root = std::sqrt(4 * std::numbers::pi);

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

void require_readable_degree(const FieldScanner& scanner, std::uint64_t degree) {
  if (degree > largest_degree)
    scanner.fail("unsupported",
                 "degree " + std::to_string(degree) + "; the highest is " + std::to_string(largest_degree));
}

// SHTOOLS

// One function of a file.
struct Block {
  std::uint32_t first = 0;                     // degree
  std::vector<std::array<double, 2>> entries;  // C and S of first, 0; first + 1, 0; first + 1, 1; ...
  std::uint32_t l = 0, m = 0;                  // the pair that comes next

  bool incomplete() const { return m != 0; }
  void add(const std::array<double, 2>& entry) {
    entries.push_back(entry);
    m = m == l ? 0 : m + 1;
    if (m == 0) ++l;
  }
};

class ShtoolsReader {
 public:
  explicit ShtoolsReader(std::span<const std::byte> bytes) : scanner_(bytes) {}

  Coefficients read(const base::Host& host) {
    std::uint64_t lines = 0;
    while (!scanner_.at_end()) {
      if (++lines % 1024 == 0) host.report("reading", lines, 0);
      if (!scanner_.at_end_of_line() && !scanner_.starts_with('#')) read_line();
      scanner_.next_line();
    }
    if (blocks_.empty()) scanner_.fail("bad-magic", "there are no coefficients");
    if (const Block& last = blocks_.back(); last.incomplete()) {
      scanner_.fail("truncated", "the coefficients of degree " + std::to_string(last.l) + " end before order " +
                                     std::to_string(last.m));
    }
    return coefficients(host);
  }

 private:
  // A line of degree, order, C and S, or a header before the first of them.
  void read_line() {
    const auto l = scanner_.whole_number();
    if (!l) {
      if (!blocks_.empty()) scanner_.number("a degree");  // says what is there, if it is no number
      if (!blocks_.empty()) scanner_.fail("parse", "a degree is a whole number");
      constexpr int max_headers = 2;
      if (++headers_ > max_headers)
        scanner_.fail("bad-magic", "no line of degree, order, C and S, as SHTOOLS writes them");
      return;
    }
    scanner_.skip_separator();
    const auto m = scanner_.whole_number();
    if (!m) scanner_.number("an order");
    if (!m) scanner_.fail("parse", "an order is a whole number");
    require_readable_degree(scanner_, *l);
    block_of(*l, *m).add(read_entry());
  }

  // The block that the next line belongs to: a block ends where this line is the first one of a block again.
  Block& block_of(std::uint64_t l, std::uint64_t m) {
    if (blocks_.empty() ||
        (m == 0 && l == blocks_.front().first && !blocks_.back().incomplete() && l != blocks_.back().l)) {
      const auto degree = static_cast<std::uint32_t>(l);
      if (m != 0) scanner_.fail("parse", "the first line is of order " + std::to_string(m) + ", not 0");
      blocks_.push_back({degree, {}, degree, 0});
    }
    Block& block = blocks_.back();
    if (l != block.l || m != block.m) {
      scanner_.fail("parse", "degree " + std::to_string(block.l) + ", order " + std::to_string(block.m) +
                                 " expected, found " + std::to_string(l) + ", " + std::to_string(m));
    }
    return block;
  }

  std::array<double, 2> read_entry() {
    std::array<double, 2> entry;
    for (double& number : entry) {
      scanner_.skip_separator();
      if (scanner_.at_end_of_line())
        scanner_.fail(scanner_.at_end() ? "truncated" : "parse", "a line of degree, order, C and S ends early");
      number = scanner_.number("a coefficient");
    }
    return entry;
  }

  Coefficients coefficients(const base::Host& host) const {
    const std::uint32_t degree = blocks_.front().l - 1;
    Coefficients result(degree, blocks_.size(), host.memory);
    for (std::size_t c = 0; c < blocks_.size(); ++c) {
      if (blocks_[c].l != blocks_.front().l) {
        scanner_.fail("truncated", "block " + std::to_string(c + 1) + " goes to degree " +
                                       std::to_string(blocks_[c].l - 1) + ", the first one to " +
                                       std::to_string(degree));
      }
      const std::array<double, 2>* entry = blocks_[c].entries.data();
      for (std::uint32_t l = blocks_[c].first; l <= degree; ++l) {
        for (std::int32_t m = 0; m <= static_cast<std::int32_t>(l); ++m, ++entry) {
          result.at(l, m, c) = (*entry)[0] * four_pi_root;
          if (m > 0) result.at(l, -m, c) = (*entry)[1] * four_pi_root;
        }
      }
    }
    return result;
  }

  FieldScanner scanner_;
  std::vector<Block> blocks_;
  int headers_ = 0;
};

std::string format_shtools(const Coefficients& coefficients) {
  std::string text =
      "# Real spherical harmonics as SHTOOLS has them: 4 pi normalized, no Condon-Shortley phase.\n"
      "# degree, order, C, S\n";
  for (std::size_t c = 0; c < coefficients.channels; ++c) {
    if (coefficients.channels > 1)
      text += "# function " + std::to_string(c + 1) + " of " + std::to_string(coefficients.channels) + "\n";
    for (std::uint32_t l = 0; l <= coefficients.degree; ++l) {
      for (std::int32_t m = 0; m <= static_cast<std::int32_t>(l); ++m) {
        text += std::to_string(l) + ", " + std::to_string(m) + ", ";
        append(text, coefficients.at(l, m, c) / four_pi_root);
        text += ", ";
        append(text, m > 0 ? coefficients.at(l, -m, c) / four_pi_root : 0);
        text += '\n';
      }
    }
  }
  return text;
}

// SPHARM-PDM

constexpr std::size_t coordinates = 3;

double spharm_factor(std::int32_t m) {
  return m == 0 ? 1 : m % 2 == 0 ? std::numbers::sqrt2 : -std::numbers::sqrt2;
}

// The order of the triples: m of the k-th one of a degree.
std::int32_t spharm_order(std::size_t k) {
  const auto m = static_cast<std::int32_t>((k + 1) / 2);
  return k % 2 == 0 ? -m : m;
}

Coefficients parse_spharm(std::span<const std::byte> bytes, const base::Host& host) {
  FieldScanner scanner(bytes);
  scanner.skip_space();
  if (!scanner.starts_with('{')) scanner.fail("bad-magic", "SPHARM-PDM's files start with '{'");
  scanner.expect('{');
  scanner.skip_space();
  const auto count = scanner.whole_number();
  if (!count) scanner.number("the number of coefficients");
  if (!count) scanner.fail("parse", "the number of coefficients is a whole number");
  const auto side = static_cast<std::uint64_t>(std::llround(std::sqrt(static_cast<double>(*count))));
  if (side > 0) require_readable_degree(scanner, side - 1);
  if (side == 0 || side * side != *count)
    scanner.fail("parse", base::counted(*count, "coefficient") + ", which is not (L + 1)^2 for any degree L");
  // Each triple takes at least the six characters {0,0,0} has less one.
  if (*count > bytes.size() / 6)
    scanner.fail("truncated",
                 "the file says that it has " + base::counted(*count, "coefficient") + " and is too short");
  Coefficients coefficients(static_cast<std::uint32_t>(side - 1), coordinates, host.memory);
  for (std::uint32_t l = 0; l <= coefficients.degree; ++l) {
    host.report("reading", l, side);
    for (std::size_t k = 0; k < 2 * std::size_t{l} + 1; ++k) {
      const std::int32_t m = spharm_order(k);
      scanner.expect(',');
      scanner.expect('{');
      for (std::size_t c = 0; c < coordinates; ++c) {
        if (c > 0) scanner.expect(',');
        scanner.skip_space();
        coefficients.at(l, m, c) = scanner.number("a coefficient") / spharm_factor(m);
      }
      scanner.expect('}');
    }
  }
  scanner.expect('}');
  scanner.skip_space();
  if (!scanner.at_end()) scanner.fail("trailing-data", "more follows after the last coefficient");
  return coefficients;
}

std::string format_spharm(const Coefficients& coefficients) {
  if (coefficients.channels != coordinates) {
    throw base::Error("unsupported",
                      "SPHARM-PDM's files hold three functions, not " + std::to_string(coefficients.channels));
  }
  std::string text = "{ " + std::to_string(basis_size(coefficients.degree));
  for (std::uint32_t l = 0; l <= coefficients.degree; ++l) {
    for (std::size_t k = 0; k < 2 * std::size_t{l} + 1; ++k) {
      const std::int32_t m = spharm_order(k);
      text += l == 0 ? ",{" : ",\n{";
      for (std::size_t c = 0; c < coordinates; ++c) {
        if (c > 0) text += ", ";
        append(text, coefficients.at(l, m, c) * spharm_factor(m));
      }
      text += '}';
    }
  }
  return text + "}\n";
}

}  // namespace

FileFormat format_of_path(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".coef") return FileFormat::spharm_pdm;
  if (ending == ".sh" || ending == ".shtools" || ending == ".txt") return FileFormat::shtools;
  throw base::Error("unsupported-format", (ending.empty() ? std::string("no ending") : "'" + ending + "'") +
                                              "; coefficients are .sh, .shtools, .txt (SHTOOLS) or .coef (SPHARM-PDM)");
}

Coefficients parse_coefficients(std::span<const std::byte> bytes, FileFormat format, const base::Host& host) {
  return format == FileFormat::spharm_pdm ? parse_spharm(bytes, host) : ShtoolsReader(bytes).read(host);
}

std::string format_coefficients(const Coefficients& coefficients, FileFormat format) {
  return format == FileFormat::spharm_pdm ? format_spharm(coefficients) : format_shtools(coefficients);
}

Coefficients read_coefficients(const std::filesystem::path& path, FileFormat format, const base::Host& host) {
  const FileFormat known = format == FileFormat::by_ending ? format_of_path(path) : format;
  return parse_coefficients(base::read_file(path, host), known, host);
}

void write_coefficients(const std::filesystem::path& path, const Coefficients& coefficients, FileFormat format) {
  const FileFormat known = format == FileFormat::by_ending ? format_of_path(path) : format;
  const std::string text = format_coefficients(coefficients, known);
  base::OutputFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace orbicube::harmonics
