// The base library's C interface, what every entry point shares (capi/src/entry.h), and the test helpers of this
// folder.
#include <doctest/doctest.h>

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "base/array.h"
#include "capi/src/entry.h"
#include "failing_allocations.h"

using namespace orbicube;

TEST_CASE("A host is filled by its size, whatever the caller's header was") {
  obc_host host;
  std::memset(&host, 0x55, sizeof host);
  CHECK(obc_host_init(&host, sizeof host) == OBC_OK);
  CHECK(host.struct_size == sizeof host);
  CHECK(host.thread_count == 0);
  CHECK_FALSE(static_cast<bool>(host.progress));
  CHECK(host.allocator == nullptr);

  std::array<unsigned char, sizeof(obc_host) + 16> larger;
  larger.fill(0x55);
  CHECK(obc_host_init(reinterpret_cast<obc_host*>(larger.data()), larger.size()) == OBC_OK);
  CHECK(std::all_of(larger.begin() + sizeof(obc_host), larger.end(), [](unsigned char byte) { return byte == 0; }));

  std::array<unsigned char, sizeof(obc_host)> smaller;
  smaller.fill(0x55);
  CHECK(obc_host_init(reinterpret_cast<obc_host*>(smaller.data()), 8) == OBC_OK);
  CHECK(std::all_of(smaller.begin() + 8, smaller.end(), [](unsigned char byte) { return byte == 0x55; }));

  CHECK(obc_host_init(nullptr, sizeof host) == OBC_INVALID_ARGUMENT);
  CHECK(obc_host_init(&host, 3) == OBC_INVALID_ARGUMENT);
}

TEST_CASE("Every status has a name of its own") {
  std::vector<std::string> names;
  for (obc_status status = OBC_INTERNAL; status <= OBC_OK; ++status)
    names.emplace_back(obc_status_name(status));
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  CHECK(obc_status_name(-1000) != nullptr);
  CHECK(obc_status_name(1000) != nullptr);
}

TEST_CASE("Exceptions become a status, with the kind and the message in the caller's error") {
  obc_error error;
  CHECK(capi::guarded(&error, [] { throw base::Error("not-closed", "3 boundary loops"); }) == OBC_NOT_CLOSED);
  CHECK(error.status == OBC_NOT_CLOSED);
  CHECK(std::string(error.kind) == "not-closed");
  CHECK(std::string(error.message) == "3 boundary loops");
  CHECK(capi::guarded(&error, [] { throw std::bad_alloc(); }) == OBC_OUT_OF_MEMORY);
  CHECK(capi::guarded(&error, [] { throw std::runtime_error("x"); }) == OBC_INTERNAL);
  CHECK(capi::guarded(&error, [] { throw 3; }) == OBC_INTERNAL);
  CHECK(capi::guarded(nullptr, [] { throw 3; }) == OBC_INTERNAL);
  CHECK(capi::guarded(&error, [] {}) == OBC_OK);
  CHECK(error.status == OBC_OK);
  CHECK(std::string(error.message).empty());
}

TEST_CASE("A message that is too long is cut between two characters") {
  obc_error error;
  const std::string two_bytes = "\u00e9";
  std::string message = "x";
  while (message.size() < 2 * sizeof error.message)
    message += two_bytes;
  CHECK(capi::guarded(&error, [&] { throw base::Error("internal", message); }) == OBC_INTERNAL);
  const std::string kept = error.message;
  CHECK(kept.size() == sizeof error.message - 1);  // 1 + 239 * 2
  CHECK(kept == message.substr(0, kept.size()));
  CHECK(capi::guarded(&error, [&] { throw base::Error("internal", "x" + message); }) == OBC_INTERNAL);
  CHECK(std::strlen(error.message) == sizeof error.message - 2);
}

TEST_CASE("Members that the caller's header did not have keep their defaults") {
  struct Options {
    std::uint32_t struct_size;
    std::uint32_t old_member;
    double new_member;
  };
  const Options defaults{sizeof(Options), 1, 2.5};
  Options given{8, 7, 100.0};
  const Options copied = capi::copy_versioned(&given, defaults);
  CHECK(copied.old_member == 7);
  CHECK(copied.new_member == 2.5);
  CHECK(capi::copy_versioned<Options>(nullptr, defaults).old_member == 1);
  given.struct_size = 0;
  CHECK_THROWS_AS(capi::copy_versioned(&given, defaults), base::Error);

  Options result{8, 0, 100.0};
  capi::write_versioned(&result, defaults);
  CHECK(result.struct_size == 8);
  CHECK(result.old_member == 1);
  CHECK(result.new_member == 100.0);
}

namespace {

// What a well-behaved entry point does: an array in the host's memory and one outside, with progress.
obc_status allocate_some(const obc_host& given) {
  return capi::guarded(nullptr, [&] {
    const capi::HostAdapter adapter(&given);
    base::Array<double> in_host_memory(100, 1.0, adapter.host().memory);
    adapter.host().report("first", 0, 2);
    std::vector<double> elsewhere(50, 2.0);
    in_host_memory.resize(200);
    adapter.host().report("second", 1, 2, elsewhere.back());
    adapter.host().report("second", 2, 2);
  });
}

}  // namespace

TEST_CASE("Each allocation of a good call fails in turn and nothing is leaked") {
  const test::Outcome outcome = test::fail_each_allocation(allocate_some);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs == 4);  // three allocations and the undisturbed run
}

TEST_CASE("A good call is cancelled at each of its reports") {
  const test::Outcome outcome = test::cancel_everywhere(allocate_some);
  CHECK(outcome.problem == "");
  CHECK(outcome.runs == 4);
  CHECK(test::cancel_everywhere(allocate_some, 1).runs == 3);  // stopped at the reports 0 and 1; 3 is none
}

TEST_CASE("The helpers notice leaks, swallowed failures and releases of another size") {
  std::array<double*, 8> leaked{};
  std::size_t count = 0;
  const auto leak = [&](const obc_host&) {
    leaked[count++] = new double(1.0);
    return OBC_OK;
  };
  // The first run fails to allocate and lets the exception out; the harness sees only statuses.
  const auto leaking = [&](const obc_host& host) { return capi::guarded(nullptr, [&] { leak(host); }); };
  CHECK(test::fail_each_allocation(leaking).problem == "run 1: 1 blocks were not released");
  for (double* pointer : leaked)
    delete pointer;

  const auto swallowing = [](const obc_host& host) {
    capi::guarded(nullptr, [&] { base::Array<double>(10, 1.0, capi::HostAdapter(&host).host().memory); });
    return obc_status{OBC_OK};
  };
  CHECK(test::fail_each_allocation(swallowing).problem == "run 0: answered ok, not out of memory");

  const auto wrong_size = [](const obc_host& host) {
    const obc_allocator& allocator = *host.allocator;
    void* pointer = allocator.allocate(16, 64, allocator.user);
    if (pointer == nullptr) return obc_status{OBC_OUT_OF_MEMORY};
    const bool aligned = reinterpret_cast<std::uintptr_t>(pointer) % 64 == 0;
    allocator.release(pointer, 8, 64, allocator.user);
    return aligned ? obc_status{OBC_OK} : obc_status{OBC_INTERNAL};
  };
  CHECK(test::fail_each_allocation(wrong_size).problem == "run 1: a block was released with another size or alignment");

  const auto deaf = [](const obc_host& host) {
    host.progress("phase", 0, 0, 0.0, host.progress_user);
    return obc_status{OBC_OK};
  };
  CHECK(test::cancel_everywhere(deaf).problem == "run 0: answered ok, not cancelled");
}

TEST_CASE("An allocator needs both of its functions") {
  obc_allocator half{nullptr, [](void*, std::size_t, std::size_t, void*) {}, nullptr};
  obc_host host;
  obc_host_init(&host, sizeof host);
  host.allocator = &half;
  CHECK(capi::guarded(nullptr, [&] { capi::HostAdapter adapter(&host); }) == OBC_INVALID_ARGUMENT);
}
