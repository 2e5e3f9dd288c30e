#include "base/files/base64.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include "base/error.h"

using namespace orbicube;
using namespace orbicube::base;

TEST_CASE("Base64 of any length is decoded to what was encoded") {
  std::mt19937 random(3);
  for (std::size_t length = 0; length < 70; ++length) {
    std::vector<std::byte> bytes(length);
    for (std::byte& byte : bytes)
      byte = static_cast<std::byte>(random() & 0xFFU);
    std::string text(base64_size(length), '\0');
    encode_base64(bytes, text.data());
    std::string appended = "x";
    append_base64(bytes, appended);
    CHECK(appended == "x" + text);
    std::vector<std::byte> streamed(length);
    Base64Decoder decoder(text);
    CHECK(decoder.read(streamed));
    CHECK(streamed == bytes);
    CHECK(decoder.at_end());
    const Array<std::byte> decoded = decode_base64(text, Host());
    CHECK(std::equal(decoded.begin(), decoded.end(), bytes.begin(), bytes.end()));
    text.resize(text.find_last_not_of('=') + 1);  // padding may be missing
    CHECK(decode_base64(text, Host()).size() == length);
  }
  // RFC 4648, section 10.
  const Array<std::byte> known = decode_base64("Zm9vYmE=", Host());
  CHECK(std::string(reinterpret_cast<const char*>(known.data()), known.size()) == "fooba");
  CHECK_THROWS_AS(decode_base64("Zm9v!mE=", Host()), Error);
  CHECK_THROWS_AS(decode_base64("Zm9vY", Host()), Error);
}
