#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "base/error.h"

namespace orbicube::base {
namespace {

class Descriptor {
 public:
  explicit Descriptor(int value) : value_(value) {}
  ~Descriptor() {
    if (value_ >= 0) ::close(value_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return value_; }

 private:
  int value_;
};

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
  constexpr std::size_t most_at_once = std::size_t{1} << 22U;  // so that a slow disk can be cancelled
  std::size_t done = 0;
  while (done < bytes.size()) {
    host.report("reading file", done, bytes.size());
    const ::ssize_t got = ::read(file.get(), bytes.data() + done, std::min(most_at_once, bytes.size() - done));
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
  target_ = std::filesystem::weakly_canonical(path, problem);
  if (problem) target_ = path;
  struct stat facts {};
  const bool exists = ::stat(target_.c_str(), &facts) == 0;
  if (exists && S_ISDIR(facts.st_mode)) {
    errno = EISDIR;
    fail("cannot write");
  }
  if (exists && !S_ISREG(facts.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("cannot write");
    return;
  }
  // Names are tried until one is free: the process's number keeps programs apart, the attempt its threads.
  constexpr int attempts = 1000;
  for (int attempt = 0; attempt < attempts && descriptor_ < 0; ++attempt) {
    temporary_ = target_;
    temporary_ += ".tmp-" + std::to_string(::getpid()) + '-' + std::to_string(attempt);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0 && errno != EEXIST) break;
  }
  if (descriptor_ < 0) fail("cannot create a file beside it");
  // Who may read the old file may read the new one; where that cannot be set, the default is right enough.
  if (exists) static_cast<void>(::fchmod(descriptor_, facts.st_mode & 07777U));
}

OutputFile::~OutputFile() {
  if (descriptor_ < 0) return;
  ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::write(std::span<const std::byte> bytes) {
  constexpr std::size_t most_at_once = std::size_t{1} << 30U;  // the system takes no more than 2 GiB
  while (!bytes.empty()) {
    const ::ssize_t written = ::write(descriptor_, bytes.data(), std::min(bytes.size(), most_at_once));
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
    const int descriptor = descriptor_;
    descriptor_ = -1;
    if (::close(descriptor) != 0) fail("cannot write");
    return;
  }
  // Renaming before the bytes are on the disk could, after a power cut, leave neither file.
  if (::fsync(descriptor_) != 0) fail("cannot write");
  if (std::rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot rename the temporary file");
  ::close(descriptor_);
  descriptor_ = -1;
}

void OutputFile::fail(const char* what) const {
  throw Error("io", what + (": " + std::generic_category().message(errno)));
}

}  // namespace orbicube::base
