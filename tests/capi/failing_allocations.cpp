#include "failing_allocations.h"

#include <sys/mman.h>
#include <time.h>
#include <algorithm>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

std::atomic<std::size_t> live_blocks{0};  // allocated and not yet released, by operator new or a host's allocator
std::atomic<std::size_t> allocations{0};  // ... since the program started
std::atomic<bool> wrong_release{false};   // a block was released with another size or alignment

// Shared with child processes, whose allocations are counted, and fail, like those of this one.
struct Shared {
  std::atomic<std::size_t> until_failure{never};  // allocations that still succeed
  std::atomic<bool> failed{false};                // the failure happened
  std::atomic<bool> could_throw{true};            // ... in an allocation that may throw
};

Shared& shared() {
  static Shared* const at = [] {
    void* memory = mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) std::abort();
    return new (memory) Shared;
  }();
  return *at;
}

// Whether the allocation that is being made is the one to fail.
bool fails_now(bool throwing) {
  std::size_t left = shared().until_failure.load();
  while (left != never && !shared().until_failure.compare_exchange_weak(left, left == 0 ? never : left - 1)) {
  }
  if (left != 0) return false;
  shared().could_throw = throwing;
  shared().failed = true;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment, bool throwing) {
  void* pointer = nullptr;
  if (!fails_now(throwing)) {
    alignment = alignment < sizeof(void*) ? sizeof(void*) : alignment;
    // aligned_alloc requires a multiple of the alignment.
    const std::size_t padding = (alignment - size % alignment) % alignment;
    if (size <= never - padding) pointer = std::aligned_alloc(alignment, size + padding + (size == 0 ? alignment : 0));
  }
  if (pointer != nullptr) {
    ++live_blocks;
    ++allocations;
  } else if (throwing) {
    throw std::bad_alloc();
  }
  return pointer;
}

void release(void* pointer) {
  if (pointer == nullptr) return;
  --live_blocks;
  std::free(pointer);
}

// A block of the host's allocator remembers in front of it what was requested.
struct Header {
  std::size_t size;
  std::size_t alignment;
};

std::size_t header_space(std::size_t alignment) {
  return alignment < sizeof(Header) ? sizeof(Header) : alignment;
}

void* host_allocate(std::size_t size, std::size_t alignment, void*) {
  const std::size_t space = header_space(alignment);
  if (size > never - space) return nullptr;
  void* block = allocate(size + space, space, false);
  if (block == nullptr) {
    shared().could_throw = true;  // unlike with nothrow, the library is to return "out of memory"
    return nullptr;
  }
  char* pointer = static_cast<char*>(block) + space;
  new (pointer - sizeof(Header)) Header{size, alignment};
  return pointer;
}

void host_release(void* pointer, std::size_t size, std::size_t alignment, void*) {
  char* bytes = static_cast<char*>(pointer);
  const Header* header = std::launder(reinterpret_cast<Header*>(bytes - sizeof(Header)));
  if (header->size != size || header->alignment != alignment) wrong_release = true;
  release(bytes - header_space(header->alignment));
}

constexpr obc_allocator counting_allocator{host_allocate, host_release, nullptr};

obc_host counting_host() {
  obc_host host{};
  obc_host_init(&host, sizeof host);
  host.thread_count = 1;
  host.allocator = &counting_allocator;
  return host;
}

// What is wrong with a run that returned `status`, or nothing.
std::string problem_of_run(std::size_t run, obc_status status, obc_status expected, std::size_t live_before) {
  const std::size_t live_after = live_blocks.load();
  const std::string where = "run " + std::to_string(run) + ": ";
  if (status != expected) return where + "answered " + obc_status_name(status) + ", not " + obc_status_name(expected);
  if (live_after != live_before) {
    return where + std::to_string(static_cast<std::int64_t>(live_after - live_before)) + " blocks were not released";
  }
  if (wrong_release) return where + "a block was released with another size or alignment";
  return "";
}

// Added to the time that the library reads. A report is passed on when some time has passed since the last one; with
// this clock each is, however fast the machine.
std::atomic<std::int64_t> ahead_nanoseconds{0};
std::atomic<bool> runs_ahead{false};

struct Reports {
  std::size_t until_stop;
  bool stopped = false;
  bool reported_again = false;
  double fraction = 0;
  bool wrong_fraction = false;  // not within 0 and 1
};

std::int32_t count_report(const char*, std::uint64_t, std::uint64_t, double, void* user) {
  auto& reports = *static_cast<Reports*>(user);
  if (reports.stopped) reports.reported_again = true;
  if (!(reports.fraction >= 0 && reports.fraction <= 1)) reports.wrong_fraction = true;
  if (reports.until_stop-- == 0) reports.stopped = true;
  return reports.stopped ? 1 : 0;
}

}  // namespace

namespace orbicube::test {

Outcome fail_each_allocation(const Call& call, std::size_t each_until) {
  Outcome outcome;
  std::size_t failing = 0;
  const obc_host host = counting_host();
  wrong_release = false;
  for (bool disturbed = true; disturbed && outcome.problem.empty(); ++outcome.runs) {
    const std::size_t before = live_blocks.load();
    shared().failed = false;
    shared().until_failure = failing;
    const obc_status status = call(host);
    shared().until_failure = never;
    disturbed = shared().failed;
    const bool unnoticed = disturbed && !shared().could_throw && status == OBC_OK;
    outcome.problem = problem_of_run(failing, status, disturbed && !unnoticed ? OBC_OUT_OF_MEMORY : OBC_OK, before);
    failing += failing < each_until ? 1 : std::max<std::size_t>(7, failing / 64);
  }
  return outcome;
}

Outcome cancel_everywhere(const Call& call, std::size_t max_runs) {
  Outcome outcome;
  obc_host host = counting_host();
  host.progress = count_report;
  wrong_release = false;
  std::size_t stop_at = 0;
  std::size_t step = 1;
  runs_ahead = true;
  for (bool disturbed = true; disturbed && outcome.problem.empty(); ++outcome.runs) {
    Reports reports{stop_at};
    host.progress_user = &reports;
    host.fraction = &reports.fraction;
    const std::size_t before = live_blocks.load();
    const obc_status status = call(host);
    disturbed = reports.stopped;
    outcome.problem = problem_of_run(outcome.runs, status, disturbed ? OBC_CANCELLED : OBC_OK, before);
    if (outcome.problem.empty() && reports.reported_again) {
      outcome.problem = "run " + std::to_string(outcome.runs) + ": reported progress after it was cancelled";
    }
    if (outcome.problem.empty() && reports.wrong_fraction) {
      outcome.problem = "run " + std::to_string(outcome.runs) + ": reported a fraction that is not within 0 and 1";
    }
    if (outcome.runs >= max_runs) step *= 2;
    stop_at += step;
  }
  runs_ahead = false;
  return outcome;
}

std::size_t allocation_count() {
  return allocations.load();
}

}  // namespace orbicube::test

// The clock of the program and of the libraries that it loads.
std::chrono::steady_clock::time_point std::chrono::steady_clock::now() noexcept {
  constexpr std::int64_t between_reports = 30'000'000;  // more than base::Host lets pass
  timespec at{};
  clock_gettime(CLOCK_MONOTONIC, &at);
  const std::int64_t ahead = runs_ahead ? ahead_nanoseconds += between_reports : ahead_nanoseconds.load();
  return time_point(std::chrono::seconds(at.tv_sec) + std::chrono::nanoseconds(at.tv_nsec + ahead));
}

// Every form of operator new and delete of the program.
void* operator new(std::size_t size) {
  return allocate(size, alignof(std::max_align_t), true);
}
void* operator new[](std::size_t size) {
  return allocate(size, alignof(std::max_align_t), true);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment), true);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment), true);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, alignof(std::max_align_t), false);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, alignof(std::max_align_t), false);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, static_cast<std::size_t>(alignment), false);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate(size, static_cast<std::size_t>(alignment), false);
}
void operator delete(void* pointer) noexcept {
  release(pointer);
}
void operator delete[](void* pointer) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::size_t) noexcept {
  release(pointer);
}
void operator delete[](void* pointer, std::size_t) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::align_val_t) noexcept {
  release(pointer);
}
void operator delete[](void* pointer, std::align_val_t) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::size_t, std::align_val_t) noexcept {
  release(pointer);
}
void operator delete[](void* pointer, std::size_t, std::align_val_t) noexcept {
  release(pointer);
}
void operator delete(void* pointer, const std::nothrow_t&) noexcept {
  release(pointer);
}
void operator delete[](void* pointer, const std::nothrow_t&) noexcept {
  release(pointer);
}
void operator delete(void* pointer, std::align_val_t, const std::nothrow_t&) noexcept {
  release(pointer);
}
void operator delete[](void* pointer, std::align_val_t, const std::nothrow_t&) noexcept {
  release(pointer);
}
