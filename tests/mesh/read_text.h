// What the tests of readers share: reading from a string, how reading ended, and changes of a text.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"
#include "mesh/files/read.h"

namespace orbicube::mesh {

inline Mesh read_text(Format format, std::string_view text, const ReadOptions& options = {},
                      ReadReport* report = nullptr) {
  return read_mesh(format, std::as_bytes(std::span(text)), options, base::Host(), report);
}

// "kind: message" of the error, or "accept".
inline std::string outcome(Format format, std::string_view text) {
  try {
    read_text(format, text);
    return "accept";
  } catch (const base::Error& error) {
    return std::string(error.kind()) + ": " + error.what();
  }
}

// Whether the outcome has this kind, and a message with this text.
inline bool ends_as(Format format, std::string_view text, std::string_view kind, std::string_view message = "") {
  const std::string ended = outcome(format, text);
  return ended.starts_with(std::string(kind) + ":") && ended.find(message) != std::string::npos;
}

// Everywhere in the text.
inline std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
  return text;
}

}  // namespace orbicube::mesh
