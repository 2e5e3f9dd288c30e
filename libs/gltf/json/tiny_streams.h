// The streams of tinygltf: it makes its messages with std::stringstream, writes documents to a std::ostream and opens
// files with std::ifstream and std::ofstream. The streams of the standard library bring its locales (100 kB of the
// module for WebAssembly), and files are not to be opened. Names are looked up in the namespace of tinygltf first: a
// `std` there has these streams, and else what the standard library has.
#pragma once

#include <cstddef>
#include <ios>
#include <string>
#include <type_traits>

namespace tinygltf {
namespace std {

using namespace ::std;

struct EndOfLine {};
inline constexpr EndOfLine endl;

// Text in memory.
class ostream {
 public:
  ostream& operator<<(const char* text) { return append(text); }
  ostream& operator<<(const string& text) { return append(text); }
  ostream& operator<<(EndOfLine) { return append("\n"); }
  template <class Number, enable_if_t<is_integral_v<Number>, int> = 0>
  ostream& operator<<(Number number) {
    return append(to_string(number));
  }
  ostream& write(const char* text, streamsize count) {
    text_.append(text, static_cast<size_t>(count));
    return *this;
  }
  const string& str() const { return text_; }

 private:
  template <class Text>
  ostream& append(const Text& text) {
    text_ += text;
    return *this;
  }

  string text_;
};

using stringstream = ostream;

// Files that cannot be opened.
class ofstream : public ostream {
 public:
  explicit ofstream(const char*, ios_base::openmode = ios_base::out) {}
  static bool is_open() { return false; }
  static constexpr ios_base::openmode binary = ios_base::binary;
};

}  // namespace std
}  // namespace tinygltf
