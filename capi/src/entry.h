// What each function of the C interface does on its way in and out: options are copied by their size, the host is
// translated, and exceptions become a status. Header-only, so that a library needs nothing but its own C++ part.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory_resource>
#include <new>
#include <string>

#include "base/catch_all.h"
#include "base/error.h"
#include "base/host.h"
#include "base/threads/cancellation.h"
#include "orbicube/base.h"

namespace orbicube::capi {

inline void fill_error(obc_error* error, obc_status status, const char* kind, const char* message) noexcept {
  if (error == nullptr) return;
  error->status = status;
  const auto copy = [](char* to, std::size_t capacity, const char* from) {
    std::size_t length = std::min(std::strlen(from), capacity - 1);
    // Do not cut a UTF-8 character in half.
    while (length > 0 && from[length] != '\0' && (static_cast<unsigned char>(from[length]) & 0xC0U) == 0x80U)
      --length;
    std::memcpy(to, from, length);
    to[length] = '\0';
  };
  copy(error->kind, sizeof error->kind, kind);
  copy(error->message, sizeof error->message, message);
}

// Runs `body` and returns its outcome; no exception leaves. A thread that ends inside a callback of the host is unwound
// through here, so that this is not noexcept: destructors release what the call had, join its threads and leave its
// handles usable.
template <class Body>
obc_status guarded(obc_error* error, const Body& body) {
  const auto outcome = [&]() -> obc_status {
    try {
      body();
      fill_error(error, OBC_OK, "", "");
      return OBC_OK;
    } catch (const base::Error& e) {
      const auto status = static_cast<obc_status>(e.status());
      fill_error(error, status, e.kind(), e.what());
      return status;
    } catch (const std::bad_alloc&) {
      fill_error(error, OBC_OUT_OF_MEMORY, "out-of-memory", "an allocation failed");
      return OBC_OUT_OF_MEMORY;
    } catch (const std::exception& e) {
      fill_error(error, OBC_INTERNAL, "internal", e.what());
      return OBC_INTERNAL;
    }
  };
  return base::catch_all(outcome, [&]() -> obc_status {
    fill_error(error, OBC_INTERNAL, "internal", "an unknown exception");
    return OBC_INTERNAL;
  });
}

using base::require;

// Runs `body`, which works on the file at `path`, with the path in front of what it throws.
template <class Body>
auto on_file(const char* path, const Body& body) {
  require(path != nullptr, "path is NULL");
  try {
    return body();
  } catch (const base::Error& e) {
    throw base::Error(e.kind(), std::string(path) + ": " + e.what());
  }
}

// A copy of the caller's versioned struct: members that the caller's header did not have keep the values of `defaults`.
template <class Struct>
Struct copy_versioned(const Struct* given, const Struct& defaults) {
  Struct result = defaults;
  if (given == nullptr) return result;
  require(given->struct_size >= sizeof(given->struct_size), "struct_size is not set (call the _init function)");
  std::memcpy(&result, given, std::min<std::size_t>(given->struct_size, sizeof result));
  result.struct_size = sizeof result;
  return result;
}

// Writes `value` into the caller's versioned struct, as much of it as the caller's header has.
template <class Struct>
void write_versioned(Struct* to, const Struct& value) {
  if (to == nullptr) return;
  const std::uint32_t size = to->struct_size;
  require(size >= sizeof size, "struct_size of a result is not set");
  std::memcpy(to, &value, std::min<std::size_t>(size, sizeof value));
  to->struct_size = size;
}

// For ..._init functions: writes `defaults` with the caller's size.
template <class Struct>
obc_status init_versioned(Struct* to, std::size_t size, Struct defaults) noexcept {
  if (to == nullptr || size < sizeof defaults.struct_size || size > UINT32_MAX) return OBC_INVALID_ARGUMENT;
  std::memset(to, 0, size);
  defaults.struct_size = static_cast<std::uint32_t>(size);
  std::memcpy(to, &defaults, std::min(size, sizeof defaults));
  return OBC_OK;
}

// The host's allocator as the C++ side takes it.
class AllocatorResource final : public std::pmr::memory_resource {
 public:
  explicit AllocatorResource(const obc_allocator& allocator) : allocator_(allocator) {}

 private:
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    void* pointer = allocator_.allocate(size, alignment, allocator_.user);
    if (pointer == nullptr) throw std::bad_alloc();
    return pointer;
  }
  void do_deallocate(void* pointer, std::size_t size, std::size_t alignment) override {
    allocator_.release(pointer, size, alignment, allocator_.user);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  obc_allocator allocator_;
};

// More threads than any machine of today has cores only cost memory; a count that was never set must not exhaust the
// system.
inline constexpr std::uint32_t max_threads = 1024;

// The caller's obc_host as the C++ side takes it. Keep it alive as long as anything made with host() lives. `host()` is
// a reference into this object, so it is not copied or moved.
class HostAdapter {
 public:
  explicit HostAdapter(const obc_host* given) : resource_(obc_allocator{nullptr, nullptr, nullptr}) {
    obc_host defaults{};
    defaults.struct_size = sizeof defaults;
    const obc_host c = copy_versioned(given, defaults);
    host_.thread_count = std::min(c.thread_count, max_threads);
    if (c.progress != nullptr) {
      host_.on_progress = [call = c.progress, user = c.progress_user, fraction = c.fraction](const base::Progress& p) {
        base::end_thread_if_cancelled();
        if (fraction != nullptr) *fraction = p.fraction;
        return call(p.phase, p.done, p.total, p.best, user) == 0;
      };
    }
    if (c.log != nullptr) {
      host_.on_log = [call = c.log, user = c.log_user](const std::string& line) { call(line.c_str(), user); };
    }
    if (c.parallel_for != nullptr) {
      host_.executor = [call = c.parallel_for, user = c.parallel_for_user](
                           std::size_t count, const std::function<void(std::size_t)>& task) {
        using Task = std::function<void(std::size_t)>;
        call(
            count, [](std::size_t i, void* context) { (*static_cast<const Task*>(context))(i); },
            const_cast<Task*>(&task), user);
      };
    }
    if (c.allocator != nullptr) {
      require(c.allocator->allocate != nullptr && c.allocator->release != nullptr, "an allocator needs both functions");
      resource_ = AllocatorResource(*c.allocator);
      host_.memory = &resource_;
    }
  }
  HostAdapter(const HostAdapter&) = delete;
  HostAdapter& operator=(const HostAdapter&) = delete;

  const base::Host& host() const { return host_; }

 private:
  AllocatorResource resource_;
  base::Host host_;
};

}  // namespace orbicube::capi
