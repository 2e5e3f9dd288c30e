#include "studies/kept_subject.h"

#include <array>
#include <charconv>
#include <utility>

#include "base/files/file.h"
#include "base/hash.h"
#include "files/surface_file.h"
#include "mesh/files/read.h"
#include "studies/rounding.h"

namespace orbicube::cli {
namespace {

// Names that are not UTF-8 must not keep the figures from being written.
std::string dumped(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::filesystem::path beside(const std::filesystem::path& folder, const std::string& name, const char* ending) {
  return folder / (name + ending);
}

// The object that NAME.json has of this hash, or an empty one.
Json json_of(const std::filesystem::path& folder, const std::string& name, const std::string& hash,
             const base::Host& host) {
  const base::Array<std::byte> bytes = base::read_file(beside(folder, name, ".json"), host);
  const char* text = reinterpret_cast<const char*>(bytes.data());
  Json json = Json::parse(text, text + bytes.size(), nullptr, false);
  return json.is_object() && json.value("hash", Json()) == Json(hash) ? json : Json::object();
}

// Calls it; what cannot be read does not exist.
template <class Read>
auto read_or_nothing(const Read& read) -> decltype(read()) {
  try {
    return read();
  } catch (const base::Error& error) {
    if (std::string(error.kind()) == "cancelled") throw;
    return std::nullopt;
  }
}

// The file of a subject's surface, which keeps vertices and doubles.
std::filesystem::path surface_of(const std::filesystem::path& folder, const std::string& name) {
  return beside(folder, name, mesh::row_of(mesh::Format::ply).ending);
}

}  // namespace

std::string text_of_hash(std::uint64_t hash) {
  std::array<char, 16> digits;
  const char* end = std::to_chars(digits.data(), digits.data() + digits.size(), hash, 16).ptr;
  const std::string text(digits.data(), static_cast<std::size_t>(end - digits.data()));
  return std::string(digits.size() - text.size(), '0') + text;
}

std::string hash_of(std::span<const mesh::Vector3> positions, const std::string& text) {
  base::Hash hash;
  hash.add(std::as_bytes(positions));
  hash.add(std::as_bytes(std::span(text.data(), text.size())));
  return text_of_hash(hash.value());
}

std::optional<MappedSubject> kept_subject(const std::filesystem::path& folder, const std::string& name,
                                          const std::string& hash, const base::Host& host) {
  return read_or_nothing([&]() -> std::optional<MappedSubject> {
    Json json = json_of(folder, name, hash, host);
    if (!json.contains("figures")) return std::nullopt;
    mesh::Mesh mesh = mesh::read_mesh(surface_of(folder, name), {}, host);
    if (json.value("result_hash", Json()) !=
        Json(hash_of(mesh.positions, dumped(json["figures"]) + dumped(json.value("functions", Json())))))
      return std::nullopt;
    return MappedSubject{
        0, std::move(mesh.positions), std::move(json["figures"]), json.value("functions", Json()), true, 0};
  });
}

std::optional<std::string> kept_rounding(const std::filesystem::path& folder, const std::string& name,
                                         const std::string& hash, const base::Host& host) {
  return read_or_nothing([&]() -> std::optional<std::string> {
    const Json json = json_of(folder, name, hash, host);
    if (json.empty()) return std::nullopt;
    const Json rounding = json.value("rounding", Json());
    return rounding.is_string() ? rounding.get<std::string>() : "none";
  });
}

std::optional<FailedSubject> kept_failure(const std::filesystem::path& folder, const std::string& name,
                                          const std::string& hash, const base::Host& host) {
  return read_or_nothing([&]() -> std::optional<FailedSubject> {
    const Json json = json_of(folder, name, hash, host);
    const Json failed = json.value("failed", Json());
    if (!failed.is_object() || json.value("result_hash", Json()) != Json(hash_of({}, dumped(failed))))
      return std::nullopt;
    return FailedSubject{0, failed.value("kind", ""), failed.value("message", "")};
  });
}

void keep_subject(const std::filesystem::path& folder, const std::string& name, const std::string& hash,
                  const MappedSubject& subject, std::span<const mesh::Triangle> triangles, Session& session) {
  mesh::Mesh mesh(session.host().memory);
  mesh.positions = subject.positions;
  mesh.triangles.assign(triangles.begin(), triangles.end());
  write_output(surface_of(folder, name), mesh, true, session);
  const std::filesystem::path json = beside(folder, name, ".json");
  Json content = {{"hash", hash},
                  {"rounding", rounding_digest()},
                  {"result_hash", hash_of(subject.positions, dumped(subject.figures) + dumped(subject.functions))},
                  {"figures", subject.figures}};
  if (!subject.functions.is_null()) content["functions"] = subject.functions;
  about(json, Role::output, [&] {
    base::OutputFile file(session.stage(json));
    file.write(dumped(content) + "\n");
    file.commit();
  });
  session.keep();
}

void keep_failure(const std::filesystem::path& folder, const std::string& name, const std::string& hash,
                  const FailedSubject& failed) {
  try {
    const Json why = {{"kind", failed.kind}, {"message", failed.text}};
    base::OutputFile file(beside(folder, name, ".json"));
    const Json content = {
        {"hash", hash}, {"rounding", rounding_digest()}, {"result_hash", hash_of({}, dumped(why))}, {"failed", why}};
    file.write(dumped(content) + "\n");
    file.commit();
    std::error_code problem;
    std::filesystem::remove(surface_of(folder, name), problem);
  } catch (const base::Error&) {
    // The disk may be full, or the folder gone.
  }
}

}  // namespace orbicube::cli
