// What the fuzz targets of the C interface have in common: bytes become numbers, small shapes with faults, and a host;
// and what every call must keep. A target is LLVMFuzzerTestOneInput in NAME.cpp; libFuzzer drives it, or
// seeded_main.cpp.
#pragma once

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <span>
#include <vector>

#include "orbicube/base.h"

namespace fuzz {

inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

// Takes values from the bytes of an input, zeros when they are used up.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : left_(data, size) {}

  std::uint8_t byte() {
    if (left_.empty()) return 0;
    const std::uint8_t result = left_.front();
    left_ = left_.subspan(1);
    return result;
  }
  bool one_in(unsigned n) { return byte() % n == 1; }
  std::size_t below(std::size_t n) { return n == 0 ? 0 : byte() % n; }
  std::uint64_t bits() {
    std::uint64_t result = 0;
    for (int i = 0; i < 8; ++i)
      result = result << 8 | byte();
    return result;
  }
  // Mostly of common size, at times one of those that go wrong.
  double number() {
    static constexpr double special[] = {0,
                                         -0.0,
                                         1,
                                         -1,
                                         std::numeric_limits<double>::quiet_NaN(),
                                         std::numeric_limits<double>::infinity(),
                                         -std::numeric_limits<double>::infinity(),
                                         1.7976931348623157e308,
                                         -1.7976931348623157e308,
                                         5e-324,
                                         2.2250738585072014e-308,
                                         1e154,
                                         1e-154,
                                         1e18,
                                         1e-17,
                                         3.4e38};
    const std::uint8_t kind = byte();
    if (kind < std::size(special)) return special[kind];
    if (kind == 16) {
      const std::uint64_t pattern = bits();
      double result;
      std::memcpy(&result, &pattern, sizeof result);
      return result;
    }
    return (kind - 128) / 37.0 + byte() / 9000.0;
  }
  // The same without NaN and infinities, of moderate size.
  double moderate() { return (byte() - 128) / 37.0 + byte() / 9000.0; }
  std::int32_t choice(std::int32_t kinds) {  // of an enumeration, at times none of it
    const std::uint8_t from = byte();
    return from > 250 ? static_cast<std::int32_t>(bits()) : from % kinds;
  }
  std::vector<double> numbers(std::size_t count) {
    std::vector<double> result(count);
    for (double& x : result)
      x = number();
    return result;
  }
  std::vector<double> moderates(std::size_t count) {
    std::vector<double> result(count);
    for (double& x : result)
      x = moderate();
    return result;
  }
  std::vector<std::uint32_t> indices(std::size_t count, std::size_t below_mostly) {
    std::vector<std::uint32_t> result(count);
    for (std::uint32_t& x : result)
      x = index(below_mostly);
    return result;
  }
  std::uint32_t index(std::size_t below_mostly) {
    const std::uint8_t from = byte();
    if (from == 255) return UINT32_MAX;
    if (from == 254) return static_cast<std::uint32_t>(below_mostly);
    if (from == 253) return static_cast<std::uint32_t>(bits());
    return static_cast<std::uint32_t>(below_mostly == 0 ? 0 : from % below_mostly);
  }
  std::span<const std::uint8_t> rest() const { return left_; }

 private:
  std::span<const std::uint8_t> left_;
};

// Memory that ends, and a run that may be cancelled: a host for one input. Every block must have come back in the end.
// Searches that have gone on for some seconds are cancelled: only code that does not check for it takes long then.
class Host {
 public:
  explicit Host(Input& input, std::size_t most = std::size_t{256} << 20)
      : most_(most), until_(input.one_in(8) ? input.byte() : 1u << 30) {
    obc_host_init(&host_, sizeof host_);
    host_.thread_count = 1;
    host_.progress = [](const char* phase, std::uint64_t, std::uint64_t, double, void* user) -> std::int32_t {
      Host& self = *static_cast<Host*>(user);
      require(phase != nullptr && *phase != '\0', "progress without a phase");
      require(!self.stopped_, "a report after the one that stopped the work");
      self.stopped_ = self.until_-- == 0 || std::chrono::steady_clock::now() > self.last_;
      return self.stopped_ ? 1 : 0;
    };
    host_.progress_user = this;
    host_.allocator = &allocator_;
  }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;
  ~Host() { require(used_ == 0, "memory of the host was not released"); }

  // For a call: whatever the last one did is forgotten.
  const obc_host* c() {
    constexpr std::chrono::seconds longest{5};
    stopped_ = false;
    last_ = std::chrono::steady_clock::now() + longest;
    return &host_;
  }

 private:
  static void* allocate(std::size_t size, std::size_t alignment, void* user) {
    Host& self = *static_cast<Host*>(user);
    if (size > self.most_ - self.used_) return nullptr;
    self.used_ += size;
    return ::operator new(size, std::align_val_t(alignment), std::nothrow);
  }
  static void release(void* pointer, std::size_t size, std::size_t alignment, void* user) {
    static_cast<Host*>(user)->used_ -= size;
    ::operator delete(pointer, std::align_val_t(alignment));
  }

  obc_host host_;
  obc_allocator allocator_ = {allocate, release, this};
  std::size_t most_, used_ = 0;
  std::uint32_t until_;
  std::chrono::steady_clock::time_point last_;
  bool stopped_ = false;
};

// Calls f(&error), which returns a status, and returns whether that is OBC_OK. Never a defect of the library, nor an
// error without a kind and a message, nor one that is filled when all went well.
template <class F>
bool ok(const F& f) {
  obc_error error;
  std::memset(&error, 'x', sizeof error);
  const obc_status status = f(&error);
  require(error.status == status, "the error has another status than the function");
  require(std::memchr(error.kind, 0, sizeof error.kind) != nullptr &&
              std::memchr(error.message, 0, sizeof error.message) != nullptr,
          "a text of an error does not end");
  if (status == OBC_OK) {
    require(error.kind[0] == '\0' && error.message[0] == '\0', "an error is filled where there is none");
    return true;
  }
  if (status == OBC_INTERNAL) std::fprintf(stderr, "%s: %s\n", error.kind, error.message);
  require(status < 0 && status != OBC_INTERNAL, "a defect of the library, or no status");
  require(error.kind[0] != '\0' && error.message[0] != '\0', "an error without a kind or a message");
  return false;
}

inline void require_finite(std::span<const double> numbers, const char* what) {
  for (const double x : numbers)
    require(std::isfinite(x), what);
}

inline void require_below(std::span<const std::uint32_t> indices, std::size_t count, const char* what) {
  for (const std::uint32_t i : indices)
    require(i < count, what);
}

}  // namespace fuzz
