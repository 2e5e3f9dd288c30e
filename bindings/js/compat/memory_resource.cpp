// What the experimental memory resources of emscripten 3.1's libc++ declare, and no library of its package defines.
#include <memory_resource>

#if _LIBCPP_VERSION < 16000
namespace {

class NewDelete final : public std::pmr::memory_resource {
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    return ::operator new(size, std::align_val_t(alignment));
  }
  void do_deallocate(void* pointer, std::size_t size, std::size_t alignment) override {
    ::operator delete(pointer, size, std::align_val_t(alignment));
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};

}  // namespace

_LIBCPP_BEGIN_NAMESPACE_LFTS_PMR
memory_resource* new_delete_resource() noexcept {
  static NewDelete resource;
  return &resource;
}
memory_resource* get_default_resource() noexcept {
  return new_delete_resource();
}
_LIBCPP_END_NAMESPACE_LFTS_PMR
#endif
