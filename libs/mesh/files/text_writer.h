// Text with numbers, collected in large pieces on the way to a file.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "base/host.h"
#include "mesh/files/piece_writer.h"
#include "mesh/mesh.h"

namespace orbicube::mesh {

class TextWriter : public PieceWriter<std::string> {
 public:
  // `total` items are going to be written, for progress.
  TextWriter(OutputFile& file, std::uint64_t total, const base::Host& host) : PieceWriter(file, total, host, {}) {
    buffer_.reserve(piece + longest_number);
  }

  TextWriter& operator<<(std::string_view text) {
    buffer_ += text;
    return *this;
  }
  TextWriter& operator<<(char c) {
    buffer_ += c;
    return *this;
  }
  // The shortest text that reads as the same double: at most 17 digits.
  TextWriter& operator<<(double x) { return number(x); }
  TextWriter& operator<<(std::uint64_t x) { return number(x); }
  TextWriter& operator<<(Index x) { return number(x); }
  TextWriter& operator<<(std::int32_t x) { return number(x); }

 private:
  static constexpr std::size_t longest_number = 32;

  template <class Number>
  TextWriter& number(Number x) {
    char text[longest_number];
    const char* end = std::to_chars(text, text + longest_number, x).ptr;
    buffer_.append(text, static_cast<std::size_t>(end - text));
    return *this;
  }
};

// Writes a line a position, and a line a triangle, which begins with its number of corners.
inline void write_positions_and_triangles(const Mesh& mesh, TextWriter& out) {
  for (const Vector3& p : mesh.positions) {
    out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    out.end_item();
  }
  for (const Triangle& t : mesh.triangles) {
    out << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
    out.end_item();
  }
  out.flush();
}

}  // namespace orbicube::mesh
