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

TEST_CASE("a host that returns false cancels the work") {
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

TEST_CASE("a report has the fraction of the whole by the parts of nested stages") {
  double fraction = -1;
  Host host;
  host.on_progress = [&](const Progress& p) {
    fraction = p.fraction;
    return true;
  };
  {
    const Stage read(host, 0.25, 1);
    host.report("reading", 1, 1);
    CHECK(fraction == 0.25);
  }
  {
    const Stage compute(host, 2.0 / 3.0);  // to 0.75
    {
      const Stage first(host, 0.5, 1);
      host.report("first", 0, 1);
      CHECK(fraction == 0.25);
      host.report("first", 1, 1);
      CHECK(fraction == 0.5);
    }
    {
      const Stage second(host, 1, 2);
      host.report("even", 1, 1);
      CHECK(fraction == 0.625);
      host.report("odd", 1, 1);
      CHECK(fraction == 0.75);
    }
  }
  const Stage write(host, 1, 1);
  host.report("writing", 1, 1);
  CHECK(fraction == 1);
}

TEST_CASE("the fraction never falls and stays below 1, whatever phases there are") {
  double fraction = 0;
  Host host;
  host.on_progress = [&](const Progress& p) {
    CHECK(p.fraction >= fraction);
    CHECK(p.fraction < 1);
    fraction = p.fraction;
    return true;
  };
  for (int round = 0; round < 200; ++round) {
    for (std::uint64_t i = 0; i <= 10; ++i)
      host.report("bounded", i, 10);
    host.report("unbounded", 0, 0);
    const Stage stage(host, 0.01);
    host.report("inner", 1, 1);
    host.report("inner", 0, 1);
  }
  CHECK(fraction > 0.9);
}

TEST_CASE("without a host nothing is reported and nothing fails") {
  const Host host;
  host.report("work", 1, 2);
  host.log("a line");
}
