// The files of one subject of a study, and whether they belong to an input and its options.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "session/session.h"
#include "studies/study_subjects.h"

namespace orbicube::cli {

// Returns a hash as a text of 16 digits.
std::string text_of_hash(std::uint64_t hash);

// Returns a hash of positions and a text.
std::string hash_of(std::span<const mesh::Vector3> positions, const std::string& text = {});

// Returns what NAME.json and NAME.ply of the folder hold if they were made from this hash and are as they were written.
std::optional<MappedSubject> kept_subject(const std::filesystem::path& folder, const std::string& name,
                                          const std::string& hash, const base::Host& host);

// Returns the digest of the machine (rounding.h) that made what NAME.json has of this hash.
std::optional<std::string> kept_rounding(const std::filesystem::path& folder, const std::string& name,
                                         const std::string& hash, const base::Host& host);

// Returns why the subject cannot be mapped if NAME.json says it of this hash.
std::optional<FailedSubject> kept_failure(const std::filesystem::path& folder, const std::string& name,
                                          const std::string& hash, const base::Host& host);

// Writes both files, the JSON last and with the digest of this machine. Throws Failure.
void keep_subject(const std::filesystem::path& folder, const std::string& name, const std::string& hash,
                  const MappedSubject& subject, std::span<const mesh::Triangle> triangles, Session& session);

// Writes why it cannot be mapped to NAME.json and removes NAME.ply. Where that is impossible, the next study tries it
// again.
void keep_failure(const std::filesystem::path& folder, const std::string& name, const std::string& hash,
                  const FailedSubject& failed);

}  // namespace orbicube::cli
