#include "gltf/json/json_memory.h"

#include <algorithm>
#include <cstdlib>
#include <new>

namespace orbicube::gltf {

namespace {

thread_local JsonMemory* current = nullptr;

constexpr std::size_t alignment = alignof(std::max_align_t);
constexpr std::size_t first_block = std::size_t{1} << 12U, longest_block = std::size_t{1} << 18U;  // bytes

std::size_t aligned(std::size_t size) {
  return (size + alignment - 1) / alignment * alignment;
}

}  // namespace

// A release needs at most a vector of all values, which grows by doubling: less than four of that length in all.
JsonMemory::JsonMemory(Use use, std::size_t values, const base::Host& host)
    : host_(host),
      use_(use),
      blocks_(host.memory),
      set_aside_(4 * sizeof(TinyJson) * (values + 64), host.memory),
      expected_(128 * std::uint64_t{values}) {
  current = this;
}

JsonMemory::~JsonMemory() {
  current = nullptr;
  for (void* const block : from_system_)
    std::free(block);
}

void JsonMemory::check() const {
  if (exhausted_) throw std::bad_alloc();
}

std::byte* JsonMemory::new_block(std::size_t size) {
  if (use_ == Use::reading) {
    host_.report("reading glTF", std::min(allocated_, expected_), expected_ + 1);
    return blocks_.emplace_back(size).data();
  }
  try {
    return blocks_.emplace_back(size).data();
  } catch (const std::bad_alloc&) {
    exhausted_ = true;
  }
  void* const block = std::malloc(size);
  if (block == nullptr) throw std::bad_alloc();
  try {
    from_system_.push_back(block);
  } catch (const std::bad_alloc&) {
    // Kept until the program ends: at most one block, where memory is exhausted twice.
  }
  return static_cast<std::byte*>(block);
}

void* JsonMemory::allocate(std::size_t size) {
  JsonMemory& memory = *current;
  size = aligned(size);
  if (static_cast<std::size_t>(memory.end_ - memory.next_) < size) {
    const auto grown =
        static_cast<std::size_t>(std::clamp<std::uint64_t>(memory.allocated_, first_block, longest_block));
    const std::size_t block = std::max(size, grown);
    memory.next_ = memory.new_block(block);
    memory.end_ = memory.next_ + block;
    memory.allocated_ += block;
  }
  void* const pointer = memory.next_;
  memory.next_ += size;
  return pointer;
}

void* JsonMemory::allocate_for_release(std::size_t size) {
  JsonMemory& memory = *current;
  size = aligned(size);
  if (size <= memory.set_aside_.size() - memory.set_aside_used_) {
    std::byte* const pointer = memory.set_aside_.data() + memory.set_aside_used_;
    memory.set_aside_used_ += size;
    ++memory.set_aside_live_;
    return pointer;
  }
  void* const pointer = std::malloc(size);
  if (pointer == nullptr) throw std::bad_alloc();
  return pointer;
}

void JsonMemory::release_for_release(void* pointer) noexcept {
  JsonMemory& memory = *current;
  const auto* const byte = static_cast<const std::byte*>(pointer);
  const std::byte* const begin = memory.set_aside_.data();
  if (std::less<>()(byte, begin) || !std::less<>()(byte, begin + memory.set_aside_.size())) {
    std::free(pointer);
  } else if (--memory.set_aside_live_ == 0) {
    memory.set_aside_used_ = 0;
  }
}

}  // namespace orbicube::gltf
