// A JSON text as a flat array of values, for files that nobody vouches for: nlohmann-json reads the text, and what it
// finds is kept without pointers and recursion (16 bytes a value, in the host's memory), so that no nesting can exhaust
// the stack and each value can say where in the document it stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/array.h"
#include "base/host.h"

namespace orbicube::gltf {

class JsonValue;

enum class JsonKind : std::uint8_t { null, boolean, whole_number, number, string, array, object };

class JsonDocument {
 public:
  // Throws Error "parse" (with line and column) when the text is not JSON, has a number that no double can hold, or
  // bytes that are not UTF-8; "depth-limit" beyond `deepest_nesting`; "unsupported" for 2^32 values or more. The text
  // is not kept. O(length of the text).
  JsonDocument(std::string_view text, const base::Host& host);

  JsonValue root() const;
  // Number of values, keys included.
  std::size_t value_count() const { return nodes_.size(); }
  // Bytes of the text.
  std::size_t text_size() const { return text_size_; }

  static constexpr std::size_t deepest_nesting = 512;

 private:
  friend class JsonBuilder;
  friend class JsonValue;

  // A value, or the key of a member, which stands before the member's value.
  struct Node {
    std::uint64_t content;  // of a number or boolean its bits, of a string its place in string_ends_
    std::uint32_t after;    // the node that follows this value and all that it contains
    JsonKind kind;
  };

  std::string_view string_at(std::uint64_t place) const;

  std::size_t text_size_;
  base::Array<Node> nodes_;
  base::Array<char> characters_;          // of all strings, one behind the other
  base::Array<std::size_t> string_ends_;  // in characters_
};

// One value of a document, or none (the result of `member` when there is no such member). Cheap to copy; the document
// must outlive it. Functions that request something that the value is not throw Error "parse" with the path of the
// value, as "accessors[3].count".
class JsonValue {
 public:
  JsonValue() = default;

  explicit operator bool() const { return document_ != nullptr; }
  JsonKind kind() const { return node().kind; }

  // Of an object: its first member of this name, or none. O(number of members).
  JsonValue member(std::string_view name) const;
  // The member, which must be there.
  JsonValue required(std::string_view name) const;

  // Calls visit(JsonValue) for each element of an array.
  template <class Visit>
  void for_each_element(const Visit& visit) const {
    const std::uint32_t end = array_end();
    for (std::uint32_t i = index_ + 1; i < end; i = document_->nodes_[i].after)
      visit(JsonValue(document_, i));
  }

  // Calls visit(std::string_view name, JsonValue) for each member of an object, also for those of one name.
  template <class Visit>
  void for_each_member(const Visit& visit) const {
    const std::uint32_t end = object_end();
    for (std::uint32_t key = index_ + 1; key < end; key = document_->nodes_[key + 1].after)
      visit(document_->string_at(document_->nodes_[key].content), JsonValue(document_, key + 1));
  }

  // Of an array or an object; 0 for other values.
  std::size_t size() const;

  double number() const;
  // A whole number from 0 to 2^64 - 1 (5.0 and 5e0 count as 5).
  std::uint64_t unsigned_integer() const;
  bool boolean() const;
  // With its escapes resolved, as UTF-8; lives as long as the document.
  std::string_view string() const;

  // Where this value stands in the document, for messages. O(size of the document).
  std::string path() const;

 private:
  friend class JsonDocument;
  JsonValue(const JsonDocument* document, std::uint32_t index) : document_(document), index_(index) {}

  const JsonDocument::Node& node() const { return document_->nodes_[index_]; }
  std::uint32_t array_end() const;
  std::uint32_t object_end() const;
  [[noreturn]] void fail(const std::string& what) const;

  const JsonDocument* document_ = nullptr;
  std::uint32_t index_ = 0;
};

}  // namespace orbicube::gltf
