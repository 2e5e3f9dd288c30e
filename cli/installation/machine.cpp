#include "installation/machine.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

namespace orbicube::cli {
namespace {

// A row of /proc/meminfo, which counts in KiB.
std::uint64_t memory_row(const std::string& wanted) {
  std::ifstream file("/proc/meminfo");
  std::string name, unit;
  for (std::uint64_t value = 0; file >> name >> value && std::getline(file, unit);)
    if (name == wanted) return value * 1024;
  return 0;
}

// A number in a file of the control group (Linux, version 2); `otherwise` where there is none, as for "max".
std::uint64_t group_number(const char* path, std::uint64_t otherwise) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  return file >> value ? value : otherwise;
}

}  // namespace

Machine machine() {
  Machine result;
  result.cores = std::max(1u, std::thread::hardware_concurrency());
  result.memory_bytes = memory_row("MemTotal:");
  result.free_memory_bytes = memory_row("MemAvailable:");
  const std::uint64_t limit = group_number("/sys/fs/cgroup/memory.max", std::numeric_limits<std::uint64_t>::max());
  if (limit < result.memory_bytes) {
    const std::uint64_t used = std::min(group_number("/sys/fs/cgroup/memory.current", 0), limit);
    result.memory_bytes = limit;
    result.free_memory_bytes = std::min(result.free_memory_bytes, limit - used);
  }
  return result;
}

}  // namespace orbicube::cli
