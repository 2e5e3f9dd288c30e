#include "files/vertex_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <span>
#include <string_view>

#include "base/error.h"
#include "mesh/files/file.h"
#include "mesh/files/text_writer.h"
#include "mesh/formats/formats.h"
#include "mesh/formats/ply_header.h"

namespace orbicube::cli {
namespace {

using mesh::Index;
using mesh::PlyType;

[[noreturn]] void refuse(const std::string& what) {
  throw base::Error("unsupported", what);
}

// The words of a line, up to a comment.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> result;
  line = line.substr(0, line.find('#'));
  const auto is_space = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; };
  for (std::size_t at = 0; at < line.size();) {
    if (is_space(line[at])) {
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < line.size() && !is_space(line[at]))
      ++at;
    result.push_back(line.substr(begin, at - begin));
  }
  return result;
}

double number_of(std::string_view word, std::size_t line) {
  double value = 0;
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    throw base::Error("parse",
                      "line " + std::to_string(line) + ": '" + std::string(word.substr(0, 40)) + "' is no number");
  return value;
}

// visit(number of line, its words) for each line.
template <class Visit>
void for_each_line(std::string_view text, const base::Host& host, const Visit& visit) {
  std::size_t line = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (++line % 1024 == 0) host.report("reading values", begin, text.size());
    visit(line, words_of(text.substr(begin, end - begin)));
    begin = end + 1;
  }
}

double binary_number(const std::byte* at, PlyType type, bool swap) {
  std::array<std::byte, 8> bytes{};
  const std::size_t size = size_of(type);
  for (std::size_t i = 0; i < size; ++i)
    bytes[i] = at[swap ? size - 1 - i : i];
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, bytes.data(), sizeof value);
    return static_cast<double>(value);
  };
  switch (type) {
    case PlyType::int8:
      return as(std::int8_t{});
    case PlyType::uint8:
      return as(std::uint8_t{});
    case PlyType::int16:
      return as(std::int16_t{});
    case PlyType::uint16:
      return as(std::uint16_t{});
    case PlyType::int32:
      return as(std::int32_t{});
    case PlyType::uint32:
      return as(std::uint32_t{});
    case PlyType::float32:
      return as(float{});
    case PlyType::float64:
      break;
  }
  return as(double{});
}

VertexValues read_ply_values(std::span<const std::byte> bytes, const base::Host& host) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::string_view last = "end_header";
  const std::size_t end = text.find(last);
  if (end == std::string_view::npos) throw base::Error("truncated", "the header has no end");
  const std::size_t body = std::min(text.find('\n', end), text.size() - 1) + 1;
  mesh::TextScanner scanner(bytes.first(body), 0, host);
  const mesh::PlyHeader header = mesh::read_ply_header(scanner);
  if (header.elements.empty() || header.elements[0].name != "vertex") refuse("vertices are not the first element");
  const mesh::PlyElement& vertex = header.elements[0];
  VertexValues result(host.memory);
  std::vector<bool> taken;
  for (const mesh::PlyProperty& property : vertex.properties) {
    if (property.count_type) refuse("vertices have a list, " + property.name);
    const std::string& name = property.name;
    taken.push_back(name != "x" && name != "y" && name != "z" && name != "nx" && name != "ny" && name != "nz");
    if (!taken.back()) continue;
    result.names.push_back(name);
    result.bytes.push_back(property.type == PlyType::uint8);
  }
  const auto add = [&](std::size_t property, double value) {
    if (taken[property]) result.values.push_back(value);
  };
  if (header.form == mesh::PlyForm::ascii) {
    std::size_t rows = 0;
    for_each_line(text.substr(body), host, [&](std::size_t line, const std::vector<std::string_view>& words) {
      if (words.empty() || rows == vertex.count) return;
      if (words.size() < taken.size()) throw base::Error("truncated", "vertex " + std::to_string(rows));
      for (std::size_t p = 0; p < taken.size(); ++p)
        add(p, taken[p] ? number_of(words[p], line) : 0);
      ++rows;
    });
    return result;
  }
  const bool swap = (header.form == mesh::PlyForm::little_endian) != (std::endian::native == std::endian::little);
  const std::size_t size = vertex.min_size();
  if (size == 0 || vertex.count > (bytes.size() - body) / size) throw base::Error("truncated", "vertices end early");
  for (std::uint64_t v = 0; v < vertex.count; ++v) {
    if (v % 4096 == 0) host.report("reading values", v, vertex.count);
    const std::byte* at = bytes.data() + body + v * size;
    for (std::size_t p = 0; p < taken.size(); ++p) {
      add(p, binary_number(at, vertex.properties[p].type, swap));
      at += size_of(vertex.properties[p].type);
    }
  }
  return result;
}

// The number of a vertex or texture coordinate, which counts from 1, or from the end where it is negative.
Index obj_index(std::string_view word, std::size_t count, std::size_t line) {
  const double value = number_of(word, line);
  const double number = value < 0 ? static_cast<double>(count) + value : value - 1;
  if (!(number >= 0 && number < static_cast<double>(count)))
    throw base::Error("index-range", "line " + std::to_string(line) + ": there is no " + std::string(word));
  return static_cast<Index>(number);
}

struct ObjValues {
  std::vector<std::array<double, 3>> colors;
  std::vector<std::array<double, 2>> coordinates;
  std::vector<std::vector<std::array<Index, 2>>> faces;  // of each corner the vertex and the texture coordinate
  std::size_t vertices = 0;
};

ObjValues read_obj(std::string_view text, const base::Host& host) {
  ObjValues result;
  for_each_line(text, host, [&](std::size_t line, const std::vector<std::string_view>& words) {
    if (words.empty()) return;
    if (words[0] == "v") {
      ++result.vertices;
      if (words.size() < 7) return;
      auto& color = result.colors.emplace_back();
      for (std::size_t k = 0; k < 3; ++k)
        color[k] = number_of(words[4 + k], line);
    } else if (words[0] == "vt" && words.size() > 1) {
      result.coordinates.push_back({number_of(words[1], line), words.size() > 2 ? number_of(words[2], line) : 0});
    } else if (words[0] == "f") {
      auto& face = result.faces.emplace_back();
      for (std::size_t k = 1; k < words.size(); ++k) {
        const std::size_t slash = words[k].find('/');
        const Index v = obj_index(words[k].substr(0, slash), result.vertices, line);
        const std::string_view rest = slash == std::string_view::npos ? "" : words[k].substr(slash + 1);
        const std::string_view of_texture = rest.substr(0, rest.find('/'));
        face.push_back(
            {v, of_texture.empty() ? mesh::no_index : obj_index(of_texture, result.coordinates.size(), line)});
      }
    }
  });
  return result;
}

// A row for each vertex, or where there are texture coordinates for each corner of a triangle.
VertexValues read_obj_values(std::string_view text, const mesh::Mesh& mesh, const base::Host& host) {
  const ObjValues obj = read_obj(text, host);
  VertexValues result(host.memory);
  const bool colors = !obj.colors.empty() && obj.colors.size() == obj.vertices;
  const bool textured = !obj.faces.empty() && std::ranges::all_of(obj.faces, [](const auto& face) {
    return std::ranges::all_of(face, [](const auto& corner) { return corner[1] != mesh::no_index; });
  });
  if (colors) result.names = {"red", "green", "blue"};
  if (textured) result.names.insert(result.names.end(), {"s", "t"});
  result.bytes.assign(result.names.size(), false);
  const auto add_row = [&](Index v, Index texture) {
    if (colors) result.values.insert(result.values.end(), obj.colors[v].begin(), obj.colors[v].end());
    if (textured)
      result.values.insert(result.values.end(), obj.coordinates[texture].begin(), obj.coordinates[texture].end());
  };
  for (Index v = 0; !textured && v < obj.vertices; ++v)
    add_row(v, mesh::no_index);
  if (!textured) return result;
  // A face of n corners became n - 2 triangles.
  std::size_t t = 0;
  for (const auto& face : obj.faces) {
    for (std::size_t k = 2; k < face.size(); ++k, ++t) {
      if (t == mesh.triangles.size()) refuse("the triangles are not those of the file");
      mesh::Triangle& rows = result.corners.emplace_back();
      for (std::size_t c = 0; c < 3; ++c) {
        const auto at = std::ranges::find(face, mesh.triangles[t][c], [](const auto& corner) { return corner[0]; });
        if (at == face.end()) refuse("the triangles are not those of the file");
        rows[c] = static_cast<Index>(3 * t + c);
        add_row((*at)[0], (*at)[1]);
      }
    }
  }
  return result;
}

}  // namespace

VertexValues read_mesh_values(const std::filesystem::path& path, const mesh::Mesh& mesh, const base::Host& host) {
  const auto format = mesh::format_of_path(path);
  if (format != mesh::Format::ply && format != mesh::Format::obj)
    refuse("values of vertices are read from PLY and OBJ; --values has those of other files");
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  VertexValues result = format == mesh::Format::ply
                            ? read_ply_values(bytes, host)
                            : read_obj_values({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, mesh, host);
  if (result.channels() == 0) refuse("the file holds nothing of its vertices but their positions");
  if (result.values.size() !=
      result.channels() * (result.corners.empty() ? mesh.positions.size() : 3 * mesh.triangles.size()))
    refuse("the vertices are not those of the file");
  return result;
}

VertexValues read_value_table(const std::filesystem::path& path, const base::Host& host) {
  const base::Array<std::byte> bytes = mesh::read_file(path, host);
  VertexValues result(host.memory);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for_each_line(text, host, [&](std::size_t line, const std::vector<std::string_view>& words) {
    if (words.empty()) return;
    const char first = words[0][0];
    if (result.names.empty()) {
      const bool named = (first >= 'a' && first <= 'z') || (first >= 'A' && first <= 'Z') || first == '_';
      for (std::size_t k = 0; k < words.size(); ++k)
        result.names.push_back(named ? std::string(words[k]) : "value" + std::to_string(k));
      if (named) return;
    }
    if (words.size() != result.channels())
      throw base::Error("parse", "line " + std::to_string(line) + " has " + std::to_string(words.size()) +
                                     " numbers, not " + std::to_string(result.channels()));
    for (const std::string_view word : words)
      result.values.push_back(number_of(word, line));
  });
  if (result.values.empty()) throw base::Error("parse", "there are no numbers in it");
  result.bytes.assign(result.channels(), false);
  return result;
}

void write_values(const std::filesystem::path& path, const mesh::Mesh& mesh, const VertexValues& values,
                  const base::Host& host) {
  const bool ply = mesh::format_of_path(path) == mesh::Format::ply;
  const char separator = path.extension() == ".csv" ? ',' : ' ';
  mesh::OutputFile file(path);
  mesh::TextWriter out(file, mesh.positions.size() + (ply ? mesh.triangles.size() : 0), host);
  if (ply) {
    out << "ply\nformat ascii 1.0\nelement vertex " << std::uint64_t{mesh.positions.size()}
        << "\nproperty double x\nproperty double y\nproperty double z\n";
    for (std::size_t c = 0; c < values.channels(); ++c)
      out << "property " << (values.bytes[c] ? "uchar " : "double ") << values.names[c].c_str() << '\n';
    out << "element face " << std::uint64_t{mesh.triangles.size()} << "\nproperty list uchar uint vertex_indices\n"
        << "end_header\n";
  } else {
    for (std::size_t c = 0; c < values.channels(); ++c) {
      if (c > 0) out << separator;
      out << values.names[c].c_str();
    }
    out << '\n';
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const mesh::Vector3& p = mesh.positions[v];
    if (ply) out << p.x() << ' ' << p.y() << ' ' << p.z();
    for (std::size_t c = 0; c < values.channels(); ++c) {
      if (ply || c > 0) out << separator;
      const double value = values.values[v * values.channels() + c];
      if (ply && values.bytes[c])
        out << static_cast<std::uint64_t>(std::clamp(std::round(value), 0.0, 255.0));
      else
        out << value;
    }
    out << '\n';
    out.end_item();
  }
  for (std::size_t t = 0; ply && t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    out << "3 " << a << ' ' << b << ' ' << c << '\n';
    out.end_item();
  }
  out.flush();
  file.commit();
}

}  // namespace orbicube::cli
