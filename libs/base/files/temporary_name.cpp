#include "base/files/temporary_name.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <memory>
#include <system_error>
#ifndef __EMSCRIPTEN__
#include <sys/file.h>
#endif

#include "base/error.h"
#include "base/files/descriptor.h"

namespace orbicube::base {
namespace {

constexpr std::string_view mark = ".orbicube-tmp-";
constexpr std::string_view digits = "0123456789abcdefghijklmnopqrstuv";  // 5 bits each
constexpr std::size_t random_digits = 26;                                // 128 bits
constexpr std::size_t longest_name = 255;                                // NAME_MAX of Linux's file systems, in bytes

std::string_view kept_of(std::string_view name) {
  return name.substr(0, longest_name - mark.size() - random_digits);
}

// False where somebody has one, or where that is unknown.
bool takes_lock(int descriptor) {
#ifdef __EMSCRIPTEN__
  static_cast<void>(descriptor);
  return false;
#else
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
#endif
}

struct CloseFolder {
  void operator()(DIR* folder) const { ::closedir(folder); }
};
using Folder = std::unique_ptr<DIR, CloseFolder>;

// The names in it, but at most the given number; the descriptor becomes the folder's.
std::vector<std::string> names_in(Descriptor&& descriptor, std::size_t most) {
  std::vector<std::string> names;
  const Folder folder(::fdopendir(descriptor.get()));
  if (!folder) return names;
  descriptor.release();
  while (names.size() < most) {
    const dirent* entry = ::readdir(folder.get());
    if (entry == nullptr) break;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") names.emplace_back(name);
  }
  return names;
}

Descriptor open_folder(int parent, const char* name) {
  return Descriptor(::openat(parent, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
}

// What a command leaves: a folder that nobody else may enter, with files.
bool remove_folder(int parent, const char* name) {
  const Descriptor folder = open_folder(parent, name);
  struct stat facts {};
  if (folder.get() < 0 || ::fstat(folder.get(), &facts) != 0 || facts.st_uid != ::geteuid()) return false;
  if ((facts.st_mode & 0077U) != 0 || !takes_lock(folder.get())) return false;
  constexpr std::size_t max_files = 1000;
  for (const std::string& file : names_in(open_folder(parent, name), max_files)) {
    struct stat inside {};
    if (::fstatat(folder.get(), file.c_str(), &inside, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(inside.st_mode))
      ::unlinkat(folder.get(), file.c_str(), 0);
  }
  return ::unlinkat(parent, name, AT_REMOVEDIR) == 0;
}

bool remove_file(int parent, const char* name) {
  // To be opened for writing, a file need not be written to; some network file systems lock nothing else.
  const Descriptor file(::openat(parent, name, O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  struct stat facts {};
  if (file.get() < 0 || ::fstat(file.get(), &facts) != 0) return false;
  if (!S_ISREG(facts.st_mode) || facts.st_uid != ::geteuid() || facts.st_nlink != 1) return false;
  return takes_lock(file.get()) && ::unlinkat(parent, name, 0) == 0;
}

}  // namespace

std::string temporary_name(std::string_view name) {
  std::array<std::uint8_t, random_digits> bytes{};
  if (::getentropy(bytes.data(), bytes.size()) != 0)
    throw Error("io", "no random numbers for a name: " + std::generic_category().message(errno));
  std::string result(kept_of(name));
  result += mark;
  for (const std::uint8_t byte : bytes)
    result += digits[byte % digits.size()];
  return result;
}

bool is_temporary_name(std::string_view candidate, std::string_view name) {
  const std::string_view kept = kept_of(name);
  if (candidate.size() != kept.size() + mark.size() + random_digits || !candidate.starts_with(kept)) return false;
  candidate.remove_prefix(kept.size());
  if (!candidate.starts_with(mark)) return false;
  return candidate.find_first_not_of(digits, mark.size()) == std::string_view::npos;
}

bool lock_temporary(int descriptor) {
#ifdef __EMSCRIPTEN__
  static_cast<void>(descriptor);
#else
  // Some network file systems lock nothing that is open for reading alone: there nothing is removed, either.
  if (::flock(descriptor, LOCK_SH | LOCK_NB) != 0) return errno != EWOULDBLOCK;
#endif
  struct stat facts {};
  return ::fstat(descriptor, &facts) == 0 && facts.st_nlink > 0;  // else it was removed before it had its lock
}

std::vector<std::string> remove_leftovers(const std::filesystem::path& target) {
  std::vector<std::string> removed;
  const std::filesystem::path parent = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  const std::string name = target.filename().string();
  const Descriptor folder(::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (folder.get() < 0) return removed;
  constexpr std::size_t max_names = 100'000;
  for (const std::string& candidate :
       names_in(Descriptor(::openat(folder.get(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC)), max_names)) {
    if (!is_temporary_name(candidate, name)) continue;
    if (remove_file(folder.get(), candidate.c_str()) || remove_folder(folder.get(), candidate.c_str()))
      removed.push_back(candidate);
  }
  std::sort(removed.begin(), removed.end());
  return removed;
}

}  // namespace orbicube::base
