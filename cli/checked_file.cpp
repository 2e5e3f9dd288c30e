#include "checked_file.h"

#include <unistd.h>

#include <array>
#include <fstream>
#include <span>
#include <system_error>

#include "base/error.h"
#include "mesh/file.h"

namespace orbicube::cli {

CheckedFile::CheckedFile(const std::filesystem::path& path) {
  std::error_code problem;
  target_ = std::filesystem::weakly_canonical(path, problem);
  if (problem) target_ = path;
  copied_ = std::filesystem::exists(target_, problem) && !std::filesystem::is_regular_file(target_, problem);
  // A link may have another ending than what it leads to; the format is that of the path that was given.
  const std::filesystem::path folder = copied_ ? std::filesystem::temp_directory_path() : target_.parent_path();
  temporary_ = folder / (target_.stem().string() + ".tmp-" + std::to_string(::getpid()) + path.extension().string());
}

CheckedFile::~CheckedFile() {
  std::error_code problem;
  if (!temporary_.empty()) std::filesystem::remove(temporary_, problem);
}

void CheckedFile::commit() {
  std::error_code problem;
  if (copied_) {
    std::ifstream from(temporary_, std::ios::binary);
    mesh::OutputFile to(target_);
    std::array<char, 1U << 16U> piece;
    while (from.read(piece.data(), piece.size()) || from.gcount() > 0)
      to.write(std::as_bytes(std::span(piece.data(), static_cast<std::size_t>(from.gcount()))));
    to.commit();
    return;
  }
  // Who may read the old file may read the new one; where that cannot be set, the default is right enough.
  const std::filesystem::file_status before = std::filesystem::status(target_, problem);
  if (std::filesystem::exists(before)) std::filesystem::permissions(temporary_, before.permissions(), problem);
  std::filesystem::rename(temporary_, target_, problem);
  if (problem) throw base::Error("io", "cannot rename the temporary file: " + problem.message());
  temporary_.clear();
}

}  // namespace orbicube::cli
