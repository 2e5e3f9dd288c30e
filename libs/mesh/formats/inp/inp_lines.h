// Lines of Abaqus and CalculiX input files: keywords with parameters, and data separated by commas.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mesh/files/text_scanner.h"

namespace orbicube::mesh {

// A keyword in capital letters without blanks, as "ELEMENTOUTPUT", and its parameters, whose values are capital, too.
struct InpKeyword {
  std::string name;
  std::vector<std::pair<std::string, std::string>> parameters;

  std::optional<std::string> value(std::string_view parameter) const {
    for (const auto& [key, text] : parameters) {
      if (key == parameter) return text;
    }
    return std::nullopt;
  }
};

class InpLines {
 public:
  InpLines(std::span<const std::byte> bytes, const base::Host& host) : scanner_(bytes, 0, host) {}

  // Moves to the next line that is neither empty nor a comment (two asterisks). Returns false at the end of the file.
  bool next();
  // Whether the line is a keyword's, which begins with an asterisk.
  bool at_keyword() const { return line_.starts_with('*'); }
  // Reads the keyword of the line and of those that continue it behind a comma at their end.
  InpKeyword keyword();

  // The next field of the line, up to a comma, without blanks around it; nothing at the end of the line.
  std::optional<std::string_view> field();
  // The next field as a number that is not negative, or as a coordinate, of which an empty one is 0.
  std::uint64_t number(std::string_view field, const char* what) const;
  double coordinate(std::string_view field) const;

  [[noreturn]] void fail(const char* kind, const std::string& what) const { scanner_.fail(kind, what); }

 private:
  TextScanner scanner_;  // at the begin of line_, behind blanks
  std::string_view line_;
  std::string_view fields_;  // what is left of line_
  bool more_fields_ = false;
  bool started_ = false;
};

}  // namespace orbicube::mesh
