#include "base/host.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

#include "base/error.h"

using namespace orbicube::base;

TEST_CASE("the first and the last report of a phase always arrive") {
  std::vector<std::string> seen;
  Host host;
  host.on_progress = [&](const Progress& p) {
    seen.push_back(std::string(p.phase) + " " + std::to_string(p.done));
    return true;
  };
  for (std::uint64_t i = 0; i <= 1000; ++i)
    host.report("one", i, 1000);
  host.report("two", 0, 0);
  REQUIRE(seen.size() >= 3);
  CHECK(seen.front() == "one 0");
  CHECK(seen[seen.size() - 2] == "one 1000");
  CHECK(seen.back() == "two 0");
}

TEST_CASE("a host that answers false cancels the work") {
  Host host;
  host.on_progress = [](const Progress&) { return false; };
  try {
    host.report("work", 1, 2);
    FAIL("not cancelled");
  } catch (const Error& e) {
    CHECK(e.status() == Status::cancelled);
    CHECK(std::string(e.what()) == "stopped during work");
  }
}

TEST_CASE("without a host nothing is reported and nothing fails") {
  const Host host;
  host.report("work", 1, 2);
  host.log("a line");
}
