// One reader of mesh files on arbitrary bytes (libFuzzer). Compiled once a format: FUZZED_FORMAT is its name in Format.
// The reader may return with a mesh or with an Error of a known kind; a mesh must be one that the rest of the tree can
// trust, and memory must be bounded by the size of the file whatever counts it claims.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory_resource>
#include <span>

#include "base/error.h"
#include "mesh/files/read.h"

using namespace orbicube;
using namespace orbicube::mesh;

namespace {

// Counts what is in use, and stops the program when that is more than a file of this size can need.
class BoundedMemory final : public std::pmr::memory_resource {
 public:
  explicit BoundedMemory(std::size_t file_size) : most_(file_size * bytes_a_byte + 65536) {}

 private:
  // The densest files: a binary triangle strip of one-byte indices makes a triangle (12 bytes, twice while it is kept
  // as a face, with the room that growing arrays leave) of each byte, and its topology is computed when vertices are
  // joined.
  static constexpr std::size_t uncompressed_bytes_a_byte = 256;
  // zlib makes a thousand bytes of one.
  static constexpr bool compressed = Format::FUZZED_FORMAT >= Format::vtp && Format::FUZZED_FORMAT <= Format::gifti;
  static constexpr std::size_t bytes_a_byte = uncompressed_bytes_a_byte * (compressed ? 64 : 1);

  void* do_allocate(std::size_t bytes, std::size_t alignment) override {
    used_ += bytes;
    if (used_ > most_) {
      std::fprintf(stderr, "%zu bytes of memory in use, where %zu are the most\n", used_, most_);
      std::abort();
    }
    return std::pmr::new_delete_resource()->allocate(bytes, alignment);
  }
  void do_deallocate(void* block, std::size_t bytes, std::size_t alignment) override {
    used_ -= bytes;
    std::pmr::new_delete_resource()->deallocate(block, bytes, alignment);
  }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }

  std::size_t most_;
  std::size_t used_ = 0;
};

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

template <class Cells>
void require_indices_in_range(const Cells& cells, std::size_t vertices) {
  for (const auto& cell : cells) {
    for (const Index v : cell)
      require(v < vertices, "a cell with a vertex that does not exist");
  }
}

void require_sound(const Mesh& mesh) {
  require(!mesh.triangles.empty() || !mesh.tetrahedra.empty() || !mesh.hexahedra.empty(), "a mesh without cells");
  for (const Vector3& p : mesh.positions)
    require(p.allFinite(), "a position that is not finite");
  require_indices_in_range(mesh.triangles, mesh.positions.size());
  require_indices_in_range(mesh.tetrahedra, mesh.positions.size());
  require_indices_in_range(mesh.hexahedra, mesh.positions.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes(reinterpret_cast<const std::byte*>(data), size);
  BoundedMemory memory(size);
  base::Host host;
  host.memory = &memory;
  for (const bool weld : {false, true}) {
    ReadOptions options;
    options.weld_identical = weld;
    try {
      ReadReport report;
      require_sound(read_mesh(Format::FUZZED_FORMAT, bytes, options, host, &report));
      require(!report.format.empty(), "a report without a format");
    } catch (const base::Error& error) {
      require(error.status() != base::Status::internal, "an error of a kind that is in no table");
      require(error.what()[0] != '\0', "an error without a message");
    }
  }
  return 0;
}
