// A solver's run as bytes: magic with the version of the layout, length, what the run is of, every part of its state,
// and a hash of it all. For machines with the same order of bytes.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

#include "base/error.h"
#include "base/hash.h"

namespace orbicube::base {

// How one library saves its runs. `Description` is plain data that says which problem the run is of and with which
// options: whoever loads makes a solver from it before the state is read. The functions take the state as
// parts(visit), which calls visit(std::span of plain data) for every part, in the same order each time.
template <class Description>
class SavedRun {
  static_assert(std::is_trivially_copyable_v<Description>);

 public:
  // Eight characters, the last of which counts the versions of the layout, and the library's name for messages.
  constexpr SavedRun(const char (&magic)[9], const char* library) : library_(library) {
    for (std::size_t i = 0; i < magic_.size(); ++i)
      magic_[i] = magic[i];
  }

  template <class Parts>
  std::size_t size(const Parts& parts) const {
    std::size_t bytes = sizeof(Header) + sizeof(std::uint64_t);
    parts([&](auto part) { bytes += part.size_bytes(); });
    return bytes;
  }

  // `blob` has size(parts) bytes; throws invalid-argument otherwise.
  template <class Parts>
  void write(std::span<std::byte> blob, const Description& description, const Parts& parts) const {
    require(blob.size() == size(parts), "a saved run needs save_size() bytes");
    std::byte* to = blob.data();
    const auto put = [&](auto part) {
      static_assert(std::is_trivially_copyable_v<typename decltype(part)::value_type>);
      if (!part.empty()) std::memcpy(to, part.data(), part.size_bytes());
      to += part.size_bytes();
    };
    const Header header{magic_, blob.size(), description};
    put(std::span(&header, 1));
    parts(put);
    const std::uint64_t hash = hash_of(blob.first(blob.size() - sizeof hash));
    put(std::span(&hash, 1));
  }

  // What `blob` is a run of. Throws truncated, bad-magic or parse where it is not whole.
  Description description(std::span<const std::byte> blob) const {
    Header header;
    if (blob.size() < sizeof header + sizeof(std::uint64_t)) throw Error("truncated", "a saved run is cut short");
    std::memcpy(&header, blob.data(), sizeof header);
    if (header.magic != magic_) {
      throw Error("bad-magic", std::string("not a saved run of this version of ") + library_);
    }
    if (header.size != blob.size()) throw Error("truncated", "a saved run has another length than it says");
    const std::span<const std::byte> body = blob.first(blob.size() - sizeof(std::uint64_t));
    std::uint64_t hash;
    std::memcpy(&hash, blob.data() + body.size(), sizeof hash);
    if (hash != hash_of(body)) throw Error("parse", "a saved run is damaged");
    return header.description;
  }

  // Fills the parts of a solver that was made for the blob's description; `same_problem` says whether it was. Throws
  // invalid-argument if not.
  template <class Parts>
  void read(std::span<const std::byte> blob, bool same_problem, const Parts& parts) const {
    require(same_problem && blob.size() == size(parts), "a saved run is of another problem");
    const std::byte* from = blob.data() + sizeof(Header);
    parts([&](auto part) {
      if (!part.empty()) std::memcpy(part.data(), from, part.size_bytes());
      from += part.size_bytes();
    });
  }

 private:
  struct Header {
    std::array<char, 8> magic;
    std::uint64_t size;
    Description description;
  };

  static std::uint64_t hash_of(std::span<const std::byte> bytes) {
    Hash hash;
    hash.add(bytes);
    return hash.value();
  }

  std::array<char, 8> magic_{};
  const char* library_;
};

}  // namespace orbicube::base
