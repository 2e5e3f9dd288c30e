// Processors and memory that the system lends to the command.
#pragma once

#include <cstdint>

namespace orbicube::cli {

struct Machine {
  unsigned cores = 1;                   // that the command uses by default
  std::uint64_t memory_bytes = 0;       // of the machine, or of the container where that is less; 0: unknown
  std::uint64_t free_memory_bytes = 0;  // of it, what is not in use; 0: unknown
};

Machine machine();

}  // namespace orbicube::cli
