#include "base/files/file.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/files/temporary_name.h"

using namespace orbicube::base;
namespace fs = std::filesystem;

namespace {

struct Folder {
  Folder() {
    std::string name = (fs::temp_directory_path() / "orbicube-test-XXXXXX").string();
    REQUIRE(::mkdtemp(name.data()) != nullptr);
    path = name;
  }
  ~Folder() { fs::remove_all(path); }
  fs::path operator/(const std::string& name) const { return path / name; }
  std::vector<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(path))
      found.insert(entry.path().filename().string());
    return {found.begin(), found.end()};
  }
  fs::path path;
};

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void put(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// A file as a killed program leaves it.
std::string left_over(const Folder& folder, const std::string& name) {
  const std::string temporary = temporary_name(name);
  put(folder / temporary, "half");
  return temporary;
}

}  // namespace

TEST_CASE("temporary names do not repeat, are recognized by the name of their output alone, and fit into a folder") {
  std::set<std::string> names;
  for (int i = 0; i < 10'000; ++i)
    names.insert(temporary_name("map.obj"));
  CHECK(names.size() == 10'000);
  for (const std::string& name : names) {
    REQUIRE(is_temporary_name(name, "map.obj"));
    REQUIRE_FALSE(is_temporary_name(name, "map.ob"));
    REQUIRE_FALSE(is_temporary_name(name + "0", "map.obj"));
    REQUIRE_FALSE(is_temporary_name(name, "other.obj"));
  }
  CHECK_FALSE(is_temporary_name("map.obj.tmp-12-0", "map.obj"));
  CHECK_FALSE(is_temporary_name("map.obj.orbicube-tmp-", "map.obj"));
  const std::string longest(255, 'a');
  const Folder folder;
  OutputFile file(folder / longest);
  file.write("whole");
  file.commit();
  CHECK(folder.names() == std::vector<std::string>{longest});
}

TEST_CASE("every digit of a temporary name varies: 128 bits, none of which is the process's number or a count") {
  std::vector<std::set<char>> seen(26);
  for (int i = 0; i < 2000; ++i) {
    const std::string name = temporary_name("x");
    for (std::size_t k = 0; k < seen.size(); ++k)
      seen[k].insert(name[name.size() - 1 - k]);
  }
  for (const auto& digit : seen)
    CHECK(digit.size() == 32);  // all 32 in 2000 draws, but once in 10^26
}

TEST_CASE("links of the former, predictable scheme are neither followed nor touched") {
  const Folder folder;
  put(folder / "victim", "precious");
  std::vector<std::string> planted{"map.obj", "victim"};
  for (int attempt = 0; attempt < 20; ++attempt) {
    planted.push_back("map.obj.tmp-" + std::to_string(::getpid()) + "-" + std::to_string(attempt));
    fs::create_symlink(folder / "victim", folder / planted.back());
  }
  OutputFile file(folder / "map.obj");
  file.write("new");
  file.commit();
  CHECK(text_of(folder / "victim") == "precious");
  CHECK(text_of(folder / "map.obj") == "new");
  CHECK(folder.names().size() == planted.size());
}

TEST_CASE(
    "the file beside the output is new, for the user alone to remove, and closed when another program is started") {
  const Folder folder;
  put(folder / "map.obj", "old");
  OutputFile file(folder / "map.obj");
  std::string temporary;
  for (const std::string& name : folder.names())
    if (name != "map.obj") temporary = name;
  REQUIRE(is_temporary_name(temporary, "map.obj"));
  CHECK(fs::symlink_status(folder / temporary).type() == fs::file_type::regular);
  // A second exclusive creation under the same name fails, as it does through a link that is there already.
  CHECK(::open((folder / temporary).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, 0666) == -1);
  bool inherited = false;
  for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
    std::error_code gone;
    if (fs::read_symlink(entry.path(), gone).filename() != temporary) continue;
    inherited = (::fcntl(std::stoi(entry.path().filename().string()), F_GETFD) & FD_CLOEXEC) == 0;
  }
  CHECK_FALSE(inherited);
  file.write("new");
  CHECK(text_of(folder / "map.obj") == "old");
  file.commit();
  CHECK(text_of(folder / "map.obj") == "new");
}

TEST_CASE("a new file has the mode of the mask, one that replaces another the other's without set-user-ID") {
  const Folder folder;
  const auto mode = [&](const char* name) {
    struct stat facts {};
    REQUIRE(::stat((folder / name).c_str(), &facts) == 0);
    return facts.st_mode & 07777U;
  };
  put(folder / "old", "old");
  REQUIRE(::chmod((folder / "old").c_str(), 04640) == 0);
  const mode_t mask = ::umask(027);
  for (const char* name : {"old", "new"}) {
    OutputFile file(folder / name);
    file.write("x");
    file.commit();
  }
  ::umask(mask);
  CHECK(mode("old") == 0640U);
  CHECK(mode("new") == 0640U);
}

TEST_CASE("what a killed program left is removed by the next one that writes the same output, and nothing else is") {
  const Folder folder;
  left_over(folder, "map.obj");
  left_over(folder, "map.obj");
  const std::string others = left_over(folder, "other.obj");
  put(folder / "victim", "precious");
  const std::string link = temporary_name("map.obj"), second = temporary_name("map.obj"),
                    locked = temporary_name("map.obj"), tree = temporary_name("map.obj"),
                    open_tree = temporary_name("map.obj");
  fs::create_symlink(folder / "victim", folder / link);
  fs::create_hard_link(folder / "victim", folder / second);
  put(folder / locked, "of a program that runs");
  const int lock = ::open((folder / locked).c_str(), O_RDONLY | O_CLOEXEC);
  REQUIRE(::flock(lock, LOCK_SH) == 0);
  // Folders are the command's, and closed to others; one that is open is not.
  fs::create_directory(folder / tree);
  fs::permissions(folder / tree, fs::perms::owner_all);
  put(folder / tree / "map.obj", "half");
  fs::create_directory(folder / open_tree);
  fs::permissions(folder / open_tree, fs::perms(0755));
  const std::vector<std::string> removed = remove_leftovers(folder / "map.obj");
  CHECK(removed.size() == 3);
  std::vector<std::string> expected{"victim", others, link, second, locked, open_tree};
  std::sort(expected.begin(), expected.end());
  CHECK(folder.names() == expected);
  CHECK(text_of(folder / "victim") == "precious");
  ::close(lock);
  CHECK(remove_leftovers(folder / "map.obj") == std::vector<std::string>{locked});
}

TEST_CASE("two writers of one output do not take each other's file for a leftover") {
  const Folder folder;
  OutputFile first(folder / "map.obj"), second(folder / "map.obj");
  CHECK(folder.names().size() == 2);
  first.write("first");
  second.write("second");
  second.commit();
  CHECK(text_of(folder / "map.obj") == "second");
  first.commit();
  CHECK(text_of(folder / "map.obj") == "first");
  CHECK(folder.names() == std::vector<std::string>{"map.obj"});
}

TEST_CASE("a folder, and a name that is none, are refused at once") {
  const Folder folder;
  CHECK_THROWS_AS(OutputFile(folder.path), Error);
  CHECK_THROWS_AS(OutputFile(folder / "none/x.obj"), Error);
  CHECK_THROWS_AS(OutputFile(fs::path{}), Error);
  CHECK(folder.names().empty());
}
