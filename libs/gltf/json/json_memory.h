// Memory for the JSON values of tinygltf. nlohmann-json 3.11 ends the program when an allocation fails while it
// releases a value, and when one fails as a value becomes an object. Values therefore live in blocks that are released
// together, and what a release or a written value needs is set aside beforehand.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::gltf {

// The memory of all JSON values that the calling thread makes while this object exists. Not to be nested.
class JsonMemory {
 public:
  enum class Use { reading, writing };

  // `values`: number of values of a text that is read, 0 where it is not known. Throws std::bad_alloc.
  // For reading, allocations throw std::bad_alloc, and Error "cancelled" when the host wants it. For writing they do
  // not throw: what the host cannot give comes from the system, and `check` reports it.
  JsonMemory(Use use, std::size_t values, const base::Host& host);
  ~JsonMemory();
  JsonMemory(const JsonMemory&) = delete;
  JsonMemory& operator=(const JsonMemory&) = delete;

  // Throws std::bad_alloc if the host's memory was exhausted.
  void check() const;

  static void* allocate(std::size_t size);
  // For the values that a release walks through: from the space set aside, else from the system.
  static void* allocate_for_release(std::size_t size);
  static void release_for_release(void* pointer) noexcept;

 private:
  std::byte* new_block(std::size_t size);

  const base::Host& host_;
  Use use_;
  base::Array<base::Array<std::byte>> blocks_;
  std::vector<void*> from_system_;
  std::byte *next_ = nullptr, *end_ = nullptr;
  base::Array<std::byte> set_aside_;
  std::size_t set_aside_used_ = 0, set_aside_live_ = 0;
  std::uint64_t allocated_ = 0, expected_;
  bool exhausted_ = false;
};

template <class Value>
struct JsonAllocator {
  using value_type = Value;
  JsonAllocator() = default;
  template <class Other>
  JsonAllocator(const JsonAllocator<Other>&) noexcept {}
  Value* allocate(std::size_t count) { return static_cast<Value*>(JsonMemory::allocate(count * sizeof(Value))); }
  void deallocate(Value*, std::size_t) noexcept {}  // with its block
  template <class Other>
  bool operator==(const JsonAllocator<Other>&) const {
    return true;
  }
};

using TinyJson =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, double, JsonAllocator>;

}  // namespace orbicube::gltf

// nlohmann-json releases a value by way of a vector with the standard allocator.
template <>
struct std::allocator<orbicube::gltf::TinyJson> {
  using value_type = orbicube::gltf::TinyJson;
  using size_type = std::size_t;
  using difference_type = std::ptrdiff_t;
  using propagate_on_container_move_assignment = std::true_type;
  using is_always_equal = std::true_type;
  allocator() = default;
  template <class Other>
  allocator(const std::allocator<Other>&) noexcept {}
  value_type* allocate(std::size_t count) {
    return static_cast<value_type*>(orbicube::gltf::JsonMemory::allocate_for_release(count * sizeof(value_type)));
  }
  void deallocate(value_type* pointer, std::size_t) noexcept {
    orbicube::gltf::JsonMemory::release_for_release(pointer);
  }
  template <class Other>
  bool operator==(const std::allocator<Other>&) const noexcept {
    return true;
  }
};
