// The table of the folder bad/ of ORBICUBE_MODELS, and how its files end.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace orbicube::test {

struct BadFile {
  std::filesystem::path path;
  std::string name, expected, kinds;  // expected: accept, reject, or either; kinds: words

  // Whether the kind is one of those of the row.
  bool has_kind(const std::string& kind) const {
    std::istringstream words(kinds);
    for (std::string word; words >> word;) {
      if (word == kind) return true;
    }
    return false;
  }
};

// Returns the rows of bad.tsv; none, with a message, where ORBICUBE_MODELS is not set.
inline std::vector<BadFile> bad_files() {
  const char* const models = std::getenv("ORBICUBE_MODELS");
  if (models == nullptr) {
    MESSAGE("skipped: ORBICUBE_MODELS is not set");
    return {};
  }
  const std::filesystem::path folder = std::filesystem::path(models) / "bad";
  std::ifstream table(folder / "bad.tsv");
  REQUIRE(table.good());
  std::vector<BadFile> result;
  std::string line;
  std::getline(table, line);  // its heads
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    BadFile& file = result.emplace_back();
    std::getline(cells, file.name, '\t');
    std::getline(cells, file.expected, '\t');
    std::getline(cells, file.kinds, '\t');
    file.path = folder / file.name;
  }
  return result;
}

// Returns what outcome_of(path) does, within two seconds of the processor: the machine may have other things to do.
template <class OutcomeOf>
std::string outcome_in_time(const BadFile& file, const OutcomeOf& outcome_of) {
  const std::clock_t start = std::clock();
  const std::string ended = outcome_of(file.path);
  CHECK(std::clock() - start < 2 * CLOCKS_PER_SEC);
  return ended;
}

}  // namespace orbicube::test
