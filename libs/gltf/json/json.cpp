#include "gltf/json/json.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/counted.h"
#include "base/error.h"

namespace orbicube::gltf {

namespace {

// The characters of the text for nlohmann-json. Reports to the host on the way: a base64 buffer is one value of any
// length.
class ReportedCharacters {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = char;

  ReportedCharacters(const std::string_view& text, std::size_t at, const base::Host& host)
      : text_(&text), at_(at), host_(&host) {}

  char operator*() const { return (*text_)[at_]; }
  ReportedCharacters& operator++() {
    constexpr std::size_t characters_between_reports = std::size_t{1} << 18U;
    if (at_++ % characters_between_reports == 0) host_->report("reading JSON", at_, text_->size());
    return *this;
  }
  bool operator==(const ReportedCharacters& other) const { return at_ == other.at_; }

 private:
  const std::string_view* text_;
  std::size_t at_;
  const base::Host* host_;
};

// What the reader says of a text that is not JSON, without the text itself, which may be of any length and content.
std::string place_and_reason(std::string_view message) {
  for (const std::string_view before : {"] ", "parse error at "}) {
    const std::size_t at = message.find(before);
    if (at != std::string_view::npos) message.remove_prefix(at + before.size());
  }
  constexpr std::size_t longest = 160;
  message = message.substr(0, std::min({message.find("; last read"), message.find(" parsing '"), longest}));
  return std::string(message);
}

}  // namespace

// Takes what nlohmann-json reads, in the order of the text (its SAX interface), into a document.
class JsonBuilder {
 public:
  JsonBuilder(JsonDocument& document, const base::Host& host) : to_(document), open_(host.memory) {}

  bool null() { return add(JsonKind::null, 0); }
  bool boolean(bool value) { return add(JsonKind::boolean, value ? 1 : 0); }
  bool number_unsigned(std::uint64_t value) { return add(JsonKind::whole_number, value); }
  bool number_integer(std::int64_t value) { return number_float(static_cast<double>(value), {}); }
  bool number_float(double value, const std::string&) {
    return add(JsonKind::number, std::bit_cast<std::uint64_t>(value));
  }
  bool string(std::string& text) {
    const std::uint64_t place = to_.string_ends_.size();
    to_.characters_.insert(to_.characters_.end(), text.begin(), text.end());
    to_.string_ends_.push_back(to_.characters_.size());
    return add(JsonKind::string, place);
  }
  bool key(std::string& text) { return string(text); }
  bool binary(std::vector<std::uint8_t>&) { return false; }  // of other formats than JSON
  bool start_object(std::size_t) { return open(JsonKind::object); }
  bool start_array(std::size_t) { return open(JsonKind::array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  [[noreturn]] bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& problem) {
    throw base::Error("parse", "JSON, byte " + std::to_string(position) + ": " + place_and_reason(problem.what()));
  }

 private:
  bool add(JsonKind kind, std::uint64_t content) {
    const std::size_t after = to_.nodes_.size() + 1;
    if (after == std::numeric_limits<std::uint32_t>::max())
      throw base::Error("unsupported", "JSON of 4294967295 values or more");
    to_.nodes_.push_back({content, static_cast<std::uint32_t>(after), kind});
    return true;
  }

  bool open(JsonKind kind) {
    if (open_.size() == JsonDocument::deepest_nesting) {
      throw base::Error("depth-limit",
                        "JSON nested deeper than " + base::counted(JsonDocument::deepest_nesting, "level"));
    }
    open_.push_back(static_cast<std::uint32_t>(to_.nodes_.size()));
    return add(kind, 0);
  }

  bool close() {
    to_.nodes_[open_.back()].after = static_cast<std::uint32_t>(to_.nodes_.size());
    open_.pop_back();
    return true;
  }

  JsonDocument& to_;
  base::Array<std::uint32_t> open_;  // nodes of the arrays and objects that have not ended
};

JsonDocument::JsonDocument(std::string_view text, const base::Host& host)
    : text_size_(text.size()), nodes_(host.memory), characters_(host.memory), string_ends_(host.memory) {
  JsonBuilder builder(*this, host);
  nlohmann::json::sax_parse(ReportedCharacters(text, 0, host), ReportedCharacters(text, text.size(), host), &builder);
}

JsonValue JsonDocument::root() const {
  return {this, 0};
}

std::string_view JsonDocument::string_at(std::uint64_t place) const {
  const std::size_t begin = place == 0 ? 0 : string_ends_[static_cast<std::size_t>(place - 1)];
  return {characters_.data() + begin, string_ends_[static_cast<std::size_t>(place)] - begin};
}

JsonValue JsonValue::member(std::string_view name) const {
  if (kind() != JsonKind::object) fail("is not an object");
  const auto& nodes = document_->nodes_;
  for (std::uint32_t key = index_ + 1; key < node().after; key = nodes[key + 1].after) {
    if (document_->string_at(nodes[key].content) == name) return {document_, key + 1};
  }
  return {};
}

JsonValue JsonValue::required(std::string_view name) const {
  const JsonValue value = member(name);
  if (!value) fail("has no " + std::string(name));
  return value;
}

std::uint32_t JsonValue::array_end() const {
  if (kind() != JsonKind::array) fail("is not an array");
  return node().after;
}

std::uint32_t JsonValue::object_end() const {
  if (kind() != JsonKind::object) fail("is not an object");
  return node().after;
}

std::size_t JsonValue::size() const {
  std::size_t count = 0;
  if (kind() == JsonKind::array) for_each_element([&](JsonValue) { ++count; });
  if (kind() == JsonKind::object) for_each_member([&](std::string_view, JsonValue) { ++count; });
  return count;
}

double JsonValue::number() const {
  if (kind() == JsonKind::whole_number) return static_cast<double>(node().content);
  if (kind() != JsonKind::number) fail("is not a number");
  return std::bit_cast<double>(node().content);
}

std::uint64_t JsonValue::unsigned_integer() const {
  if (kind() == JsonKind::whole_number) return node().content;
  const double value = number();
  // 2^53: up to there a double holds every whole number.
  if (!(value >= 0 && value <= 9007199254740992.0 && value == std::floor(value)))
    fail("is not a whole number from 0 to 2^64 - 1");
  return static_cast<std::uint64_t>(value);
}

bool JsonValue::boolean() const {
  if (kind() != JsonKind::boolean) fail("is not true or false");
  return node().content != 0;
}

std::string_view JsonValue::string() const {
  if (kind() != JsonKind::string) fail("is not a string");
  return document_->string_at(node().content);
}

std::string JsonValue::path() const {
  const auto& nodes = document_->nodes_;
  std::string result;
  // Goes down from the root into the child that holds the value.
  for (std::uint32_t at = 0; at != index_;) {
    std::uint32_t child = at + 1;
    if (nodes[at].kind == JsonKind::object) {
      while (nodes[child + 1].after <= index_)
        child = nodes[child + 1].after;
      if (!result.empty()) result += '.';
      result += document_->string_at(nodes[child].content);
      ++child;
    } else {
      std::size_t position = 0;
      for (; nodes[child].after <= index_; child = nodes[child].after)
        ++position;
      result += '[' + std::to_string(position) + ']';
    }
    at = child;
  }
  return result.empty() ? "the document" : result;
}

void JsonValue::fail(const std::string& what) const {
  throw base::Error("parse", path() + " " + what);
}

}  // namespace orbicube::gltf
