// The table of error kinds: one place that says which words exist and what status each one is.
#include "base/error.h"

#include <array>
#include <utility>

#include "base/known_kind.h"

namespace orbicube::base {
namespace {

constexpr std::array kinds = {
    // files
    std::pair{"empty-file", Status::malformed_file},
    std::pair{"empty-mesh", Status::malformed_file},
    std::pair{"truncated", Status::malformed_file},
    std::pair{"parse", Status::malformed_file},
    std::pair{"bad-magic", Status::malformed_file},
    std::pair{"non-finite", Status::malformed_file},
    std::pair{"index-range", Status::malformed_file},
    std::pair{"accessor-range", Status::malformed_file},
    std::pair{"accessor-type", Status::malformed_file},
    std::pair{"missing-attribute", Status::malformed_file},
    std::pair{"trailing-data", Status::malformed_file},
    std::pair{"depth-limit", Status::malformed_file},
    std::pair{"unsafe-path", Status::malformed_file},
    std::pair{"unsupported-mode", Status::unsupported},
    std::pair{"unsupported-extension", Status::unsupported},
    std::pair{"unsupported-version", Status::unsupported},
    std::pair{"unsupported-uri", Status::unsupported},
    std::pair{"unsupported-format", Status::unsupported},
    std::pair{"unsupported", Status::unsupported},
    std::pair{"io", Status::io},
    // shapes
    std::pair{"not-closed", Status::not_closed},
    std::pair{"non-manifold-edge", Status::not_manifold},
    std::pair{"non-manifold-vertex", Status::not_manifold},
    std::pair{"non-manifold-face", Status::not_manifold},
    std::pair{"inconsistent-orientation", Status::not_manifold},
    std::pair{"non-orientable", Status::not_manifold},
    std::pair{"not-connected", Status::not_manifold},
    std::pair{"duplicate-face", Status::not_manifold},
    std::pair{"duplicate-cell", Status::not_manifold},
    std::pair{"self-intersection", Status::not_manifold},
    std::pair{"no-cells", Status::invalid_argument},
    std::pair{"wrong-genus", Status::wrong_genus},
    std::pair{"degenerate-face", Status::degenerate},
    std::pair{"degenerate-cell", Status::degenerate},
    std::pair{"degenerate-geometry", Status::degenerate},
    std::pair{"inverted-cell", Status::degenerate},
    // work
    std::pair{"usage", Status::invalid_argument},
    std::pair{"invalid-argument", Status::invalid_argument},
    std::pair{"no-valid-result", Status::no_valid_result},
    std::pair{"out-of-memory", Status::out_of_memory},
    std::pair{"cancelled", Status::cancelled},
    std::pair{"time-limit", Status::cancelled},
    std::pair{"internal", Status::internal},
};

}  // namespace

const char* status_name(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::invalid_argument:
      return "invalid argument";
    case Status::malformed_file:
      return "malformed file";
    case Status::not_closed:
      return "not closed";
    case Status::not_manifold:
      return "not manifold";
    case Status::wrong_genus:
      return "wrong genus";
    case Status::degenerate:
      return "degenerate";
    case Status::out_of_memory:
      return "out of memory";
    case Status::cancelled:
      return "cancelled";
    case Status::io:
      return "input or output failed";
    case Status::unsupported:
      return "unsupported";
    case Status::no_valid_result:
      return "no valid result";
    case Status::internal:
      return "internal error";
  }
  return "unknown status";
}

const char* known_kind(std::string_view kind, Status status) {
  for (const auto& entry : kinds) {
    if (entry.first == kind) return entry.first;
  }
  for (const auto& entry : kinds) {
    if (entry.second == status) return entry.first;
  }
  return "internal";
}

Status status_of_kind(std::string_view kind) {
  for (const auto& [word, status] : kinds) {
    if (kind == word) return status;
  }
  return Status::internal;
}

}  // namespace orbicube::base
