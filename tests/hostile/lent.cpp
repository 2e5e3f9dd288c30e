#include "lent.h"

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <new>
#include <thread>

namespace hostile {

// The one that may look into a call.
struct Lent {
  static std::int32_t report(const char* phase, std::uint64_t, std::uint64_t, double, void*) {
    Call& c = Call::at_hand();
    c.require(phase != nullptr && *phase != '\0', "a report without a phase");
    c.require(!c.reported_cancel_, "a report after the one that cancelled");
    c.enter_callback();
    const double now = c.seconds();
    if (--c.until_cancel_ >= 0 && now - c.begun_ < c.seconds_to_cancel_) return 0;
    c.reported_cancel_ = true;
    c.cancelled_at_ = now;
    return c.random.one_in(2) ? 1 : -7;
  }
  static void log(const char* line, void*) { Call::at_hand().look_at(line); }
};

namespace {

constexpr std::size_t largest_block = std::size_t{256} << 20;
std::atomic<std::size_t> blocks{0};
std::atomic<std::int64_t> allocations_left{INT64_MAX};

void* allocate(std::size_t size, std::size_t alignment, void*) {
  if (size > largest_block || allocations_left.fetch_sub(1) <= 0) return nullptr;
  void* const block = ::operator new(size, std::align_val_t(alignment), std::nothrow);
  if (block != nullptr) ++blocks;
  return block;
}

void release(void* block, std::size_t, std::size_t alignment, void*) {
  --blocks;
  ::operator delete(block, std::align_val_t(alignment));
}

const obc_allocator allocator = {allocate, release, nullptr};

using Task = void (*)(std::size_t index, void* context);

void backwards(std::size_t count, Task task, void* context, void*) {
  while (count-- > 0)
    task(count, context);
}

void on_threads(std::size_t count, Task task, void* context, void*) {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i; (i = next++) < count;)
      task(i, context);
  };
  // A host that joins threads holds cancellation off, or it is ended here.
  int before = 0;
  pthread_setcancelstate(PTHREAD_CANCEL_DISABLE, &before);
  std::thread other(work);
  work();
  other.join();
  pthread_setcancelstate(before, &before);
}

}  // namespace

void allow_allocations() {
  allocations_left = INT64_MAX;
}

std::size_t blocks_in_use() {
  return blocks;
}

void lend(Random& random, bool limited, obc_host& host) {
  obc_host_init(&host, sizeof host);
  static constexpr std::uint32_t threads[] = {0, 1, 1, 1, 2, 3, 1000000};
  host.thread_count = random.of(threads);
  host.progress = Lent::report;
  if (random.one_in(3)) {
    host.log = Lent::log;
  }
  if (random.one_in(4)) host.parallel_for = random.one_in(2) ? backwards : on_threads;
  if (limited || !random.one_in(4)) host.allocator = &allocator;
  if (random.one_in(6)) allocations_left = static_cast<std::int64_t>(random.below(random.one_in(2) ? 10 : 300));
}

std::string scratch_folder() {
  struct Folder {
    std::string name =
        (std::filesystem::temp_directory_path() / ("orbicube-hostile-" + std::to_string(getpid()))).string();
    Folder() { std::filesystem::create_directories(name); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(name, ignored);
    }
  };
  static const Folder folder;
  return folder.name;
}

}  // namespace hostile
