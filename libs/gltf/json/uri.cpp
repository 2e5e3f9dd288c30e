#include "gltf/json/uri.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <vector>

#include "base/error.h"
#include "mesh/files/file.h"

namespace orbicube::gltf {

namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool starts_with_ignoring_case(std::string_view text, std::string_view lower_case) {
  return text.size() >= lower_case.size() &&
         std::equal(lower_case.begin(), lower_case.end(), text.begin(),
                    [](char target, char c) { return target == (is_letter(c) ? static_cast<char>(c | 0x20) : c); });
}

std::string percent_decoded(std::string_view uri) {
  std::string result;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      result.push_back(uri[i]);
      continue;
    }
    unsigned char byte = 0;
    const char* const begin = uri.data() + i + 1;
    if (uri.size() - i < 3 || std::from_chars(begin, begin + 2, byte, 16).ptr != begin + 2)
      throw base::Error("parse", "the URI " + in_quotes(uri) + " has a broken percent-encoding");
    result.push_back(static_cast<char>(byte));
    i += 2;
  }
  return result;
}

}  // namespace

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string result = "\"";
  for (const char c : text.substr(0, longest))
    result += c >= ' ' && c < '\x7f' ? c : '?';
  return result + (text.size() > longest ? "...\"" : "\"");
}

std::optional<std::string_view> base64_of_data_uri(std::string_view uri) {
  if (!starts_with_ignoring_case(uri, "data:")) return {};
  constexpr std::string_view encoding = ";base64";
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(encoding))
    throw base::Error("unsupported-uri", "a data URI that is not base64");
  return uri.substr(comma + 1);
}

std::string file_of_uri(std::string_view uri) {
  const auto unsafe = [&](const char* why) {
    throw base::Error("unsafe-path", "the buffer URI " + in_quotes(uri) + ' ' + why);
  };
  if (uri.find_first_of("?#") != std::string_view::npos || uri.empty())
    throw base::Error("unsupported-uri", "the buffer URI " + in_quotes(uri) + " does not name a file");
  const std::string name = percent_decoded(uri);
  // Whatever a colon stands for (a scheme, a drive, a stream), the file is refused; before the first slash only, where
  // RFC 3986 does not allow one in a relative reference.
  const std::string first_segment = name.substr(0, name.find('/'));
  if (first_segment.find(':') != std::string::npos) unsafe("names a scheme or a drive");
  if (name.front() == '/') unsafe("is an absolute path");
  if (name.find('\\') != std::string::npos) unsafe("has a backslash");
  if (std::any_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == 0x7F; }))
    unsafe("has a control character");
  // Dots are resolved as RFC 3986 has it, by the text alone: what lies on the way need not be there.
  std::vector<std::string_view> segments;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string_view segment = std::string_view(name).substr(begin, end - begin);
    if (segment == "..") {
      if (segments.empty()) unsafe("leads out of the file's own folder");
      segments.pop_back();
    } else if (segment != "." && !segment.empty()) {
      segments.push_back(segment);
    }
    begin = end + 1;
  }
  std::string result;
  for (const std::string_view segment : segments)
    result.append(result.empty() ? "" : "/").append(segment);
  if (result.empty())
    throw base::Error("unsupported-uri", "the buffer URI " + in_quotes(uri) + " does not name a file");
  return result;
}

base::Array<std::byte> read_file_below(const std::filesystem::path& folder, const std::string& name,
                                       const base::Host& host) {
  std::error_code problem;
  const std::filesystem::path root = std::filesystem::canonical(folder.empty() ? "." : folder, problem);
  const std::filesystem::path file =
      problem ? std::filesystem::path() : std::filesystem::canonical(root / name, problem);
  if (problem) throw base::Error("io", "cannot open the buffer " + in_quotes(name) + ": " + problem.message());
  if (std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first != root.end())
    throw base::Error("unsafe-path", "the buffer " + in_quotes(name) + " is a link out of the file's own folder");
  // The path has no links any more, so one that appears now is not followed.
  try {
    return mesh::read_file(file, host, mesh::Links::refuse);
  } catch (const base::Error& error) {
    throw base::Error(error.kind(), "the buffer " + in_quotes(name) + ": " + error.what());
  }
}

}  // namespace orbicube::gltf
