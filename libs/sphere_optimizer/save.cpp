// A run as bytes: a header (magic, length, shape, options), the state, every array, and a hash.
#include <array>
#include <cstring>
#include <type_traits>

#include "base/error.h"
#include "base/hash.h"
#include "sphere_optimizer/solver.h"

namespace orbicube::sphere_optimizer {
namespace {

// The last character counts the versions of the layout.
constexpr std::array<char, 8> magic = {'O', 'B', 'C', 'S', 'P', 'H', 'R', '1'};

struct Header {
  std::array<char, 8> magic;
  std::uint64_t size, count, dimension;
  Options options;
};
static_assert(std::is_trivially_copyable_v<Header>);

std::uint64_t hash_of(std::span<const std::byte> bytes) {
  base::Hash hash;
  hash.add(bytes);
  return hash.value();
}

Header read_header(std::span<const std::byte> blob) {
  Header header;
  if (blob.size() < sizeof header + sizeof(std::uint64_t)) throw base::Error("truncated", "a saved run is cut short");
  std::memcpy(&header, blob.data(), sizeof header);
  if (header.magic != magic) throw base::Error("bad-magic", "not a saved run of this version of sphere_optimizer");
  if (header.size != blob.size()) throw base::Error("truncated", "a saved run has another length than it says");
  const std::span<const std::byte> body = blob.first(blob.size() - sizeof(std::uint64_t));
  std::uint64_t hash;
  std::memcpy(&hash, blob.data() + body.size(), sizeof hash);
  if (hash != hash_of(body)) throw base::Error("parse", "a saved run is damaged");
  return header;
}

}  // namespace

template <class Self, class Visit>
void Solver::visit_state(Self& self, const Visit& visit) {
  static_assert(std::is_trivially_copyable_v<State>);
  visit(std::span(&self.state_, 1));
  for (auto* array :
       {&self.x_, &self.gradient_, &self.trial_, &self.trial_gradient_, &self.direction_, &self.velocity_, &self.best_,
        &self.radial_, &self.trial_radial_, &self.ambient_, &self.trial_ambient_, &self.last_values_}) {
    visit(std::span(*array));
  }
  LimitedMemory::visit_state(self.memory_, visit);
}

std::size_t Solver::save_size() const {
  std::size_t size = sizeof(Header) + sizeof(std::uint64_t);
  visit_state(*this, [&](auto part) { size += part.size_bytes(); });
  return size;
}

void Solver::save(std::span<std::byte> blob) const {
  if (blob.size() != save_size()) throw base::Error("invalid-argument", "a saved run needs save_size() bytes");
  const Header header{magic, blob.size(), shape_.count, shape_.dimension, options_};
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
  return read_header(blob).options;
}

Shape Solver::shape_of(std::span<const std::byte> blob) {
  const Header header = read_header(blob);
  return {header.count, header.dimension};
}

void Solver::load(std::span<const std::byte> blob) {
  const Header header = read_header(blob);
  if (header.count != shape_.count || header.dimension != shape_.dimension || blob.size() != save_size() ||
      header.options.method != options_.method) {
    throw base::Error("invalid-argument", "a saved run is of another problem");
  }
  options_ = header.options;
  const std::byte* from = blob.data() + sizeof header;
  visit_state(*this, [&](auto part) {
    if (!part.empty()) std::memcpy(part.data(), from, part.size_bytes());
    from += part.size_bytes();
  });
}

}  // namespace orbicube::sphere_optimizer
