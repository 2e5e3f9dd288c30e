// A run as bytes: a header (magic, length, the problem's fingerprint), the options, the state, every array, and a hash.
#include <array>
#include <cstring>
#include <type_traits>

#include "base/error.h"
#include "base/hash.h"
#include "trust_region/solver.h"

namespace orbicube::trust_region {
namespace {

// The last character counts the versions of the layout.
constexpr std::array<char, 8> magic = {'O', 'B', 'C', 'T', 'R', 'G', 'N', '1'};

struct Header {
  std::array<char, 8> magic;
  std::uint64_t size, fingerprint;
  Options options;
};
static_assert(std::is_trivially_copyable_v<Header>);

Header read_header(std::span<const std::byte> blob) {
  Header header;
  if (blob.size() < sizeof header + sizeof(std::uint64_t)) throw base::Error("truncated", "a saved run is cut short");
  std::memcpy(&header, blob.data(), sizeof header);
  if (header.magic != magic) throw base::Error("bad-magic", "not a saved run of this version of trust_region");
  if (header.size != blob.size()) throw base::Error("truncated", "a saved run has another length than it says");
  return header;
}

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  base::Hash hash;
  hash.add(bytes);
  return hash.value();
}

}  // namespace

template <class Self, class Visit>
void Solver::visit_state(Self& self, const Visit& visit) {
  static_assert(std::has_unique_object_representations_v<Phase> && std::is_trivially_copyable_v<State>);
  visit(std::span(&self.state_, 1));
  for (auto* array : {&self.best_, &self.best_outputs_, &self.values_, &self.start_, &self.design_, &self.requests_,
                      &self.told_, &self.step_})
    visit(std::span(*array));
  visit(std::span(self.axes_));
  Interpolation::visit_state(self.interpolation_, visit);
  Models::visit_state(self.models_, visit);
}

std::size_t Solver::save_size() const {
  std::size_t size = sizeof(Header) + sizeof(std::uint64_t);
  visit_state(*this, [&](auto part) { size += part.size_bytes(); });
  return size;
}

void Solver::save(std::span<std::byte> blob) const {
  if (blob.size() != save_size()) throw base::Error("invalid-argument", "a saved run needs save_size() bytes");
  const Header header{magic, blob.size(), variables_.fingerprint(), options_};
  std::byte* to = blob.data();
  const auto write = [&](auto part) {
    if (!part.empty()) std::memcpy(to, part.data(), part.size_bytes());
    to += part.size_bytes();
  };
  write(std::span(&header, 1));
  visit_state(*this, write);
  const std::uint64_t hash = hash_of(blob.first(blob.size() - sizeof hash));
  write(std::span(&hash, 1));
}

Options Solver::options_of(std::span<const std::byte> blob) {
  const Header header = read_header(blob);
  const std::span<const std::byte> body = blob.first(blob.size() - sizeof(std::uint64_t));
  std::uint64_t hash;
  std::memcpy(&hash, blob.data() + body.size(), sizeof hash);
  if (hash != hash_of(body)) throw base::Error("parse", "a saved run is damaged");
  return header.options;
}

void Solver::load(std::span<const std::byte> blob) {
  const Options saved = options_of(blob);
  const Header header = read_header(blob);
  if (header.fingerprint != variables_.fingerprint() || blob.size() != save_size()) {
    throw base::Error("invalid-argument", "a saved run is of another problem");
  }
  options_ = saved;
  const std::byte* from = blob.data() + sizeof header;
  visit_state(*this, [&](auto part) {
    if (!part.empty()) std::memcpy(part.data(), from, part.size_bytes());
    from += part.size_bytes();
  });
}

}  // namespace orbicube::trust_region
