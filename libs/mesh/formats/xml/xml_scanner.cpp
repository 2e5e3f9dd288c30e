#include "mesh/formats/xml/xml_scanner.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/files/text_scanner.h"

namespace orbicube::mesh {
namespace {

constexpr std::string_view space = " \t\r\n";
constexpr std::size_t deepest = 64;            // open elements; files of VTK and GIFTI have fewer than 10
constexpr std::size_t most_attributes = 1000;  // of one element

bool ends_name(char c) {
  return space.find(c) != std::string_view::npos || c == '>' || c == '/' || c == '=' || c == '<' || c == '"' ||
         c == '\'';
}

}  // namespace

void XmlScanner::fail(const char* kind, const std::string& what) const {
  throw base::Error(kind, "byte " + std::to_string(at_) + ": " + what);
}

std::optional<std::string_view> XmlScanner::attribute(std::string_view name) const {
  for (const Attribute& attribute : attributes_) {
    if (attribute.name == name) return attribute.value;
  }
  return std::nullopt;
}

void XmlScanner::skip_space() {
  at_ = std::min(all_.find_first_not_of(space, at_), all_.size());
}

void XmlScanner::skip_past(std::string_view end, const char* what) {
  const std::size_t found = all_.find(end, at_);
  if (found == std::string_view::npos) fail("truncated", std::string("the file ends inside ") + what);
  at_ = found + end.size();
}

XmlScanner::Event XmlScanner::next() {
  if (empty_element_) return end();
  while (true) {
    host_.report("reading", at_, all_.size());
    const std::size_t begin = at_;
    constexpr std::string_view cdata = "<![CDATA[", cdata_end = "]]>";
    if (all_.substr(at_).starts_with(cdata)) {
      skip_past(cdata_end, "CDATA");
      text_ = all_.substr(begin + cdata.size(), at_ - begin - cdata.size() - cdata_end.size());
      if (!open_.empty()) return Event::text;
      fail("parse", "text outside of the elements");
    }
    at_ = std::min(all_.find('<', at_), all_.size());
    text_ = trimmed(all_.substr(begin, at_ - begin));
    if (text_.starts_with("\xEF\xBB\xBF") && begin == 0) text_.remove_prefix(3);
    if (!text_.empty()) {
      if (!open_.empty()) return Event::text;
      fail(rooted_ ? "parse" : "bad-magic", "an XML file starts with < and has no text outside of its elements");
    }
    if (at_ == all_.size()) {
      if (!open_.empty()) fail("truncated", "the file ends inside the element " + in_quotes(open_.back()));
      if (!rooted_) fail("truncated", "the file ends before its first element");
      return Event::end_of_file;
    }
    const std::string_view tag = all_.substr(at_);
    if (tag.starts_with("<!--"))
      skip_past("-->", "a comment");
    else if (tag.starts_with("<?"))
      skip_past("?>", "an instruction");
    else if (tag.starts_with("<!") && !tag.starts_with(cdata))
      skip_declaration();
    else if (tag.starts_with("</"))
      return end();
    else if (!tag.starts_with("<!"))
      return start();
  }
}

// <!DOCTYPE ...>, of which the definitions in brackets are skipped as well.
void XmlScanner::skip_declaration() {
  const std::size_t found = all_.find_first_of(">[", at_);
  if (found != std::string_view::npos && all_[found] == '[') {
    at_ = found;
    skip_past("]", "a declaration");
  }
  skip_past(">", "a declaration");
}

std::string_view XmlScanner::name_at() {
  const std::size_t begin = at_;
  while (at_ < all_.size() && !ends_name(all_[at_]))
    ++at_;
  if (at_ == all_.size()) fail("truncated", "the file ends inside a tag");
  if (at_ == begin) fail("parse", "a name expected, found " + in_quotes(all_.substr(at_, 1)));
  return all_.substr(begin, at_ - begin);
}

XmlScanner::Event XmlScanner::start() {
  if (open_.empty() && rooted_) fail("parse", "a second element behind the outermost one");
  ++at_;
  name_ = name_at();
  attributes_.clear();
  while (true) {
    skip_space();
    if (at_ == all_.size()) fail("truncated", "the file ends inside the tag " + in_quotes(name_));
    if (all_[at_] == '>' || all_[at_] == '/') break;
    Attribute attribute;
    attribute.name = name_at();
    skip_space();
    if (at_ == all_.size()) fail("truncated", "the file ends inside the tag " + in_quotes(name_));
    if (all_[at_] != '=') fail("parse", "= expected behind the attribute " + in_quotes(attribute.name));
    ++at_;
    skip_space();
    const char quote = at_ < all_.size() ? all_[at_] : '"';
    if (quote != '"' && quote != '\'') fail("parse", "a value in quotes expected");
    const std::size_t begin = ++at_;
    skip_past({&quote, 1}, "a value in quotes");
    attribute.value = all_.substr(begin, at_ - begin - 1);
    if (attributes_.size() == most_attributes) fail("parse", "an element with more than 1000 attributes");
    attributes_.push_back(attribute);
  }
  empty_element_ = all_[at_] == '/';
  at_ += empty_element_;
  if (at_ == all_.size()) fail("truncated", "the file ends inside the tag " + in_quotes(name_));
  if (all_[at_] != '>') fail("parse", "> expected behind /");
  ++at_;
  if (open_.size() == deepest) fail("depth-limit", "more than 64 elements inside each other");
  open_.push_back(name_);
  rooted_ = true;
  return Event::start;
}

XmlScanner::Event XmlScanner::end() {
  if (!empty_element_) {
    at_ += 2;
    name_ = name_at();
    if (open_.empty() || open_.back() != name_) fail("parse", "the end of " + in_quotes(name_) + ", which is not open");
    skip_past(">", "a tag");
  }
  empty_element_ = false;
  name_ = open_.back();
  open_.pop_back();
  return Event::end;
}

}  // namespace orbicube::mesh
