// Errors of every library: a status (what the caller's program branches on), a kind (the one word that the command
// line prints and scripts match) and a message that says what is wrong and where.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace orbicube::base {

// The values are those of obc_status in <orbicube/base.h>.
enum class Status : std::int32_t {
  ok = 0,
  invalid_argument = -1,
  malformed_file = -2,
  not_closed = -3,
  not_manifold = -4,
  wrong_genus = -5,
  degenerate = -6,
  out_of_memory = -7,
  cancelled = -8,
  io = -9,
  unsupported = -10,
  no_valid_result = -11,
  internal = -12,
};

// Short English name of a status, e.g. "out of memory". Never null.
const char* status_name(Status status);

// The status that a kind word stands for; `internal` for a word that is not in the table of error.cpp.
Status status_of_kind(std::string_view kind);

// What our own code throws. Standard exceptions (bad_alloc, ...) may pass through as well; the C interface turns both
// into a status.
class Error : public std::runtime_error {
 public:
  // `kind` must be a string literal from the table in error.cpp, e.g. "index-range".
  Error(const char* kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}

  const char* kind() const { return kind_; }
  Status status() const { return status_of_kind(kind_); }
  // Whether another attempt is out of the question: the host wants the end, or there is no memory.
  bool must_end() const { return status() == Status::cancelled || status() == Status::out_of_memory; }

 private:
  const char* kind_;
};

// Throws invalid-argument with `message` unless `condition` holds.
inline void require(bool condition, const char* message) {
  if (!condition) throw Error("invalid-argument", message);
}

}  // namespace orbicube::base
