#include "solver_checks.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace orbicube::test {
namespace {

constexpr const char* blob_variable = "ORBICUBE_TEST_BLOB";
constexpr const char* answer_variable = "ORBICUBE_TEST_ANSWER";

Bytes read(const std::string& name) {
  std::ifstream file(name, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(file), {});
}

void write(const std::string& name, const void* data, std::size_t size) {
  std::ofstream(name, std::ios::binary).write(static_cast<const char*>(data), static_cast<std::streamsize>(size));
}

}  // namespace

Bytes in_new_process(const std::string& name, const Bytes& blob) {
  const std::string stem = (std::filesystem::temp_directory_path() /
                            ("orbicube-resume-" + std::to_string(reinterpret_cast<std::uintptr_t>(&blob))))
                               .string();
  const std::string blob_name = stem + ".blob", answer_name = stem + ".answer";
  write(blob_name, blob.data(), blob.size());
  const std::string command = std::string(blob_variable) + "='" + blob_name + "' " + answer_variable + "='" +
                              answer_name + "' '" + std::filesystem::read_symlink("/proc/self/exe").string() +
                              "' --test-case='" + name + "' > /dev/null";
  const bool good = std::system(command.c_str()) == 0;
  const Bytes answer = good ? read(answer_name) : Bytes();
  std::filesystem::remove(blob_name);
  std::filesystem::remove(answer_name);
  return answer;
}

bool in_second_process() {
  return std::getenv(blob_variable) != nullptr;
}

Bytes blob_of_first_process() {
  return read(std::getenv(blob_variable));
}

void answer_first_process(const void* data, std::size_t size) {
  write(std::getenv(answer_variable), data, size);
}

bool names_differ(const char* (*name)(std::int32_t), std::int32_t last) {
  std::set<std::string> names;
  for (std::int32_t stop = 0; stop <= last; ++stop)
    names.insert(name(stop));
  return names.size() == static_cast<std::size_t>(last) + 1 && names.count("unknown") == 0 &&
         std::string(name(99)) == "unknown";
}

}  // namespace orbicube::test
