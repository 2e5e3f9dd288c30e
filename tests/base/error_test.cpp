#include "base/error.h"

#include <doctest/doctest.h>

#include "base/known_kind.h"

using namespace orbicube::base;

TEST_CASE("a kind word decides the status") {
  CHECK(status_of_kind("index-range") == Status::malformed_file);
  CHECK(status_of_kind("wrong-genus") == Status::wrong_genus);
  CHECK(status_of_kind("no such word") == Status::internal);
  CHECK(Error("io", "disk full").status() == Status::io);
}

TEST_CASE("words from elsewhere become words of the table") {
  CHECK(std::string(known_kind(std::string("not-closed"), Status::internal)) == "not-closed");
  CHECK(status_of_kind(known_kind("no such word", Status::cancelled)) == Status::cancelled);
  CHECK(std::string(known_kind("no such word", Status::ok)) == "internal");
}

TEST_CASE("every status has a name of its own") {
  for (std::int32_t a = -12; a <= 0; ++a) {
    CHECK(std::string(status_name(static_cast<Status>(a))) != "unknown status");
    for (std::int32_t b = -12; b < a; ++b) {
      CHECK(std::string(status_name(static_cast<Status>(a))) != status_name(static_cast<Status>(b)));
    }
  }
  CHECK(std::string(status_name(static_cast<Status>(77))) == "unknown status");
}
