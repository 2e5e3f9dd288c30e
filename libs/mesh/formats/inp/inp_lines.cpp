#include "mesh/formats/inp/inp_lines.h"

#include <fast_float/fast_float.h>
#include <algorithm>
#include <charconv>
#include <cmath>

namespace orbicube::mesh {
namespace {

// Keywords and their values are the same in letters of each size and with blanks anywhere.
std::string normal_form(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r') continue;
    result += c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
  }
  return result;
}

}  // namespace

bool InpLines::next() {
  while (true) {
    if (started_) scanner_.next_line();
    started_ = true;
    scanner_.progress();
    if (!scanner_.skip_space()) return false;
    line_ = trimmed(scanner_.line());
    fields_ = line_;
    more_fields_ = true;
    if (!line_.starts_with("**")) return true;
  }
}

std::optional<std::string_view> InpLines::field() {
  if (!more_fields_) return std::nullopt;
  const std::size_t comma = fields_.find(',');
  const std::string_view result = trimmed(fields_.substr(0, comma));
  more_fields_ = comma != std::string_view::npos;
  fields_ = more_fields_ ? fields_.substr(comma + 1) : std::string_view();
  return result;
}

InpKeyword InpLines::keyword() {
  constexpr std::size_t most = 1000;  // parameters; the keywords of these programs have fewer than 20
  InpKeyword result;
  result.name = normal_form(field().value_or("").substr(1));
  while (true) {
    bool ends_with_comma = false;
    while (const auto text = field()) {
      ends_with_comma = text->empty();
      if (text->empty()) continue;
      const std::size_t equals = text->find('=');
      const std::string_view value = equals == std::string_view::npos ? std::string_view() : text->substr(equals + 1);
      result.parameters.emplace_back(normal_form(text->substr(0, equals)), normal_form(value));
      if (result.parameters.size() > most) fail("parse", "a keyword with more than 1000 parameters");
    }
    if (!ends_with_comma) return result;
    if (!next()) fail("truncated", "the file ends inside the keyword " + in_quotes(result.name));
    if (at_keyword()) fail("parse", "the keyword " + in_quotes(result.name) + " ends with a comma");
  }
}

std::uint64_t InpLines::number(std::string_view field, const char* what) const {
  std::uint64_t value = 0;
  const char* const begin = field.data() + field.starts_with('+');
  const auto [end, problem] = std::from_chars(begin, field.data() + field.size(), value);
  if (problem == std::errc::result_out_of_range)
    fail("index-range", std::string(what) + " is out of range: " + in_quotes(field));
  if (problem != std::errc() || end != field.data() + field.size())
    fail("parse", std::string(what) + " expected, found " + in_quotes(field));
  return value;
}

double InpLines::coordinate(std::string_view field) const {
  if (field.empty()) return 0;
  double value = 0;
  const char* const begin = field.data() + (field.starts_with('+') && !field.starts_with("+-"));
  const auto [end, problem] = fast_float::from_chars(begin, field.data() + field.size(), value);
  if (problem == std::errc::invalid_argument || end != field.data() + field.size())
    fail("parse", "a coordinate expected, found " + in_quotes(field));
  if (!std::isfinite(value)) fail("non-finite", "a coordinate is " + in_quotes(field));
  return value;
}

}  // namespace orbicube::mesh
