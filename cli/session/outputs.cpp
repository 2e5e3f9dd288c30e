#include "session/outputs.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <span>
#include <system_error>

#include "base/files/file.h"
#include "base/files/temporary_name.h"
#include "session/failure.h"

namespace orbicube::cli {
namespace {

// Of what was in the place before, beside the new file, which has the name that the user gave.
std::string old_name(const std::filesystem::path& name) {
  return name == "0" ? "1" : "0";
}

[[noreturn]] void fail(const char* what) {
  throw base::Error("io", what + (": " + std::generic_category().message(errno)));
}

}  // namespace

std::filesystem::path Outputs::stage(const std::filesystem::path& target) {
  Output output;
  output.given = target;
  std::error_code problem;
  output.target = std::filesystem::weakly_canonical(target, problem);
  if (problem) output.target = target;
  struct stat facts {};
  output.existed = ::stat(output.target.c_str(), &facts) == 0;
  output.mode = facts.st_mode & 0777U;
  output.copied = output.existed && !S_ISREG(facts.st_mode);
  about(target, Role::output, [&] {
    if (target.filename().empty()) throw base::Error("io", "cannot write: this is no name of a file");
    if (output.existed && S_ISDIR(facts.st_mode)) throw base::Error("io", "cannot write: this is a folder");
    make_folder(output);
  });
  const auto same = [&](const Output& other) { return !other.copied && other.target == output.target; };
  if (const auto other = std::find_if(all_.begin(), all_.end(), same); other != all_.end()) {
    std::filesystem::remove(output.folder, problem);
    throw Failure(Exit::wrong_input, target.string(), "usage",
                  "two outputs have this one place; give each a file of its own");
  }
  if (!output.copied) {
    for (std::string& name : base::remove_leftovers(output.target))
      leftovers_.push_back(std::move(name));
  }
  all_.push_back(std::move(output));
  return all_.back().file();
}

void Outputs::make_folder(Output& output) {
  const std::filesystem::path beside =
      output.copied ? std::filesystem::temp_directory_path() : output.target.parent_path();
  constexpr int attempts = 100;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    output.folder = beside / base::temporary_name(output.target.filename().string());
    if (::mkdir(output.folder.c_str(), 0700) != 0) {
      if (errno == EEXIST) continue;
      break;
    }
    output.lock = base::Descriptor(::open(output.folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
    if (output.lock.get() >= 0 && base::lock_temporary(output.lock.get())) return;
  }
  fail("cannot create a folder beside it");
}

void Outputs::commit() {
  // First what may fail and cannot be taken back: then nothing else has happened yet.
  for (const Output& output : all_) {
    if (output.copied) about(output.given, Role::output, [&] { copy(output); });
  }
  for (auto output = all_.begin(); output != all_.end(); ++output) {
    if (output->copied) continue;
    try {
      about(output->given, Role::output, [&] { rename(*output); });
    } catch (const Failure&) {
      while (output != all_.begin())
        undo(*--output);
      throw;
    }
  }
  discard();
}

void Outputs::copy(const Output& output) {
  std::ifstream from(output.file(), std::ios::binary);
  base::OutputFile to(output.target);
  std::array<char, 1U << 16U> piece;
  while (from.read(piece.data(), piece.size()) || from.gcount() > 0)
    to.write(std::as_bytes(std::span(piece.data(), static_cast<std::size_t>(from.gcount()))));
  to.commit();
}

void Outputs::rename(Output& output) {
  const std::filesystem::path file = output.file();
  if (output.existed) {
    // Who may read the old file may read the new one; where that cannot be set, the default is right enough.
    static_cast<void>(::chmod(file.c_str(), output.mode));
    const std::filesystem::path old = output.folder / old_name(file.filename());
    // Where a file system has no second names, the new file still comes whole or not at all, but is not taken back.
    if (::link(output.target.c_str(), old.c_str()) == 0) output.kept = old;
  }
  if (std::rename(file.c_str(), output.target.c_str()) != 0) fail("cannot rename the temporary file");
}

void Outputs::undo(const Output& output) {
  if (output.copied) return;
  if (output.kept) {
    static_cast<void>(std::rename(output.kept->c_str(), output.target.c_str()));
  } else if (!output.existed) {
    static_cast<void>(::unlink(output.target.c_str()));
  }
}

void Outputs::discard() {
  std::error_code problem;
  for (const Output& output : all_)
    std::filesystem::remove_all(output.folder, problem);
  all_.clear();
}

}  // namespace orbicube::cli
