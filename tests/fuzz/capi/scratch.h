// A file for functions that want one: what is in it, and that it is gone in the end.
#pragma once

#include <filesystem>
#include <fstream>
#include <span>
#include <string>

#include <unistd.h>

namespace fuzz {

class Scratch {
 public:
  explicit Scratch(const char* ending)
      : path_((std::filesystem::temp_directory_path() / ("orbicube-fuzz-" + std::to_string(getpid()) + ending))
                  .string()) {}
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  const char* path() const { return path_.c_str(); }
  void write(std::span<const std::uint8_t> bytes) const {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

 private:
  std::string path_;
};

}  // namespace fuzz
