// The tags and texts of an XML file one after the other, as views of its bytes: what the files of VTK and GIFTI need of
// XML, whose blocks of numbers are long and, behind AppendedData of VTK, are no XML. Texts are as they stand there:
// references such as &lt; are not replaced.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/host.h"

namespace orbicube::mesh {

class XmlScanner {
 public:
  enum class Event { start, text, end, end_of_file };

  XmlScanner(std::span<const std::byte> bytes, const base::Host& host)
      : all_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), host_(host) {}

  // Moves to the next start of an element, text that is not blank, or end of an element; comments, declarations and
  // instructions are skipped. Throws Error "parse" where the file is not well-formed, "truncated" where it ends inside
  // an element, "depth-limit", "cancelled".
  Event next();

  // The name of the element at its start or end.
  std::string_view name() const { return name_; }
  // The value of an attribute at the start of an element.
  std::optional<std::string_view> attribute(std::string_view name) const;
  std::string_view text() const { return text_; }
  // Elements that are open: the outermost first, the one at whose start or text this is last.
  const std::vector<std::string_view>& open() const { return open_; }

  // Everything behind the place reached.
  std::string_view rest() const { return all_.substr(at_); }

  [[noreturn]] void fail(const char* kind, const std::string& what) const;

 private:
  Event start();
  Event end();
  void skip_declaration();
  void skip_past(std::string_view end, const char* what);
  std::string_view name_at();
  void skip_space();

  struct Attribute {
    std::string_view name, value;
  };

  std::string_view all_;
  std::size_t at_ = 0;
  std::string_view name_, text_;
  std::vector<Attribute> attributes_;
  std::vector<std::string_view> open_;
  bool empty_element_ = false;  // whether the start was that of <name/>
  bool rooted_ = false;
  const base::Host& host_;
};

}  // namespace orbicube::mesh
