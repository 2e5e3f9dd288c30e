// The subjects of a study: all surfaces and label images of a folder, or the rows of a table.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/host.h"

namespace orbicube::cli {

struct StudySubject {
  std::string name;  // of its files and rows: the file's name without ending, with a number where that is taken
  std::filesystem::path file;
  std::map<std::string, std::string> values;  // by column of the table, besides `file`
};

// Reads the surfaces and label images of a folder, sorted by name and without those of folders in it, or a table: CSV
// whose first line names the columns, one of them `file` with paths relative to the table. Throws Failure "io",
// "parse", and "invalid-argument" for less than two subjects.
std::vector<StudySubject> read_study_list(const std::filesystem::path& path, const base::Host& host);

// Returns a cell of a table, in quotes where it needs them.
std::string csv_cell(const std::string& text);

}  // namespace orbicube::cli
