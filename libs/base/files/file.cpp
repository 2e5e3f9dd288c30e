#include "base/files/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "base/error.h"
#include "base/files/temporary_name.h"
#include "base/threads/cancellation.h"

namespace orbicube::base {
namespace {

// A folder need not be readable for files to be made in it.
#if defined(O_PATH) && !defined(__EMSCRIPTEN__)
constexpr int folder_flags = O_PATH | O_DIRECTORY | O_CLOEXEC;
#else
constexpr int folder_flags = O_RDONLY | O_DIRECTORY | O_CLOEXEC;
#endif

[[noreturn]] void fail_to_read() {
  throw Error("io", "cannot read: " + std::generic_category().message(errno));
}

}  // namespace

Array<std::byte> read_file(const std::filesystem::path& path, const Host& host, Links links) {
  // Without O_NONBLOCK a pipe that nobody writes to would never open.
  const int no_links = links == Links::refuse ? O_NOFOLLOW : 0;
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | no_links));
  if (file.get() < 0 && errno == ELOOP && links == Links::refuse) throw Error("unsafe-path", "is a link");
  struct stat facts {};
  if (file.get() < 0 || ::fstat(file.get(), &facts) != 0) fail_to_read();
  if (!S_ISREG(facts.st_mode)) {
    throw Error(links == Links::refuse ? "unsafe-path" : "io", "cannot read: not a regular file");
  }
  Array<std::byte> bytes(static_cast<std::size_t>(facts.st_size), host.memory);
  constexpr std::size_t max_at_once = std::size_t{1} << 22U;  // so that a slow disk can be cancelled
  std::size_t done = 0;
  while (done < bytes.size()) {
    host.report("reading file", done, bytes.size());
    const ::ssize_t got = ::read(file.get(), bytes.data() + done, std::min(max_at_once, bytes.size() - done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_to_read();
    if (got == 0) break;  // the file became shorter
    done += static_cast<std::size_t>(got);
  }
  bytes.resize(done);
  return bytes;
}

OutputFile::OutputFile(const std::filesystem::path& path) {
  std::error_code problem;
  std::filesystem::path target = std::filesystem::weakly_canonical(path, problem);
  if (problem) target = path;
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : std::filesystem::path(".");
  name_ = target.filename().string();
  folder_ = Descriptor(::open(folder.c_str(), folder_flags));
  if (name_.empty()) errno = ENOENT;
  if (folder_.get() < 0 || name_.empty()) fail("cannot write");
  struct stat facts {};
  const bool exists = ::fstatat(folder_.get(), name_.c_str(), &facts, 0) == 0;
  if (exists && S_ISDIR(facts.st_mode)) {
    errno = EISDIR;
    fail("cannot write");
  }
  if (exists && !S_ISREG(facts.st_mode)) {
    file_ = Descriptor(::open(target.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (file_.get() < 0) fail("cannot write");
    return;
  }
  remove_leftovers(target);
  create();
  // Who may read the old file may read the new one; where that cannot be set, the default is right enough.
  if (exists) static_cast<void>(::fchmod(file_.get(), facts.st_mode & 0777U));
}

OutputFile::~OutputFile() {
  const CancellationOff off;
  if (file_.get() >= 0 && !temporary_.empty()) ::unlinkat(folder_.get(), temporary_.c_str(), 0);
}

void OutputFile::create() {
  // A name that is taken is another program's or a trap: the next one is as random.
  constexpr int attempts = 100;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    temporary_ = temporary_name(name_);
    file_ = Descriptor(
        ::openat(folder_.get(), temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (file_.get() < 0 && errno != EEXIST) break;
    if (file_.get() >= 0 && lock_temporary(file_.get())) return;
  }
  file_ = Descriptor();
  fail("cannot create a file beside it");
}

void OutputFile::write(std::span<const std::byte> bytes) {
  constexpr std::size_t max_at_once = std::size_t{1} << 30U;  // the system takes no more than 2 GiB
  while (!bytes.empty()) {
    const ::ssize_t written = ::write(file_.get(), bytes.data(), std::min(bytes.size(), max_at_once));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail("cannot write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void OutputFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text.data(), text.size())));
}

void OutputFile::commit() {
  if (temporary_.empty()) {
    if (::close(file_.release()) != 0) fail("cannot write");
    return;
  }
  // Renaming before the bytes are on the disk could, after a power cut, leave neither file.
  if (::fsync(file_.get()) != 0) fail("cannot write");
  if (::renameat(folder_.get(), temporary_.c_str(), folder_.get(), name_.c_str()) != 0)
    fail("cannot rename the temporary file");
  file_ = Descriptor();
}

void OutputFile::fail(const char* what) const {
  throw Error("io", what + (": " + std::generic_category().message(errno)));
}

}  // namespace orbicube::base
