#include "call.h"

#include <pthread.h>
#include <sys/mman.h>
#include <time.h>

#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "lent.h"
#include "meshes.h"

namespace hostile {

std::uint64_t Random::next() {
  std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

namespace {

constexpr std::size_t array_length = 65536;  // of every array of numbers or indices that is not of a mesh
constexpr std::size_t largest_count = 50;    // so that no count times its entries is beyond that

std::map<std::string, std::vector<char>>& saved() {
  static auto& all = *new std::map<std::string, std::vector<char>>;
  return all;
}

}  // namespace

Call::Call(std::uint64_t seed, const Limits& limits, bool may_go_without_host) : random(seed), limits_(limits) {
  static constexpr unsigned levels[] = {0, 0, 0, 40, 40, 20, 20, 8, 3};
  wrong_in_ = random.of(levels);
  no_host_ = may_go_without_host && random.one_in(8);
  no_arrays_ = !no_host_ && random.one_in(12);
  seconds_to_cancel_ = random.one_in(20) ? limits.seconds_of_some : limits.seconds_to_cancel;
  if (random.one_in(5)) until_cancel_ = static_cast<std::int64_t>(random.below(12));
  answers_ = static_cast<int>(random.below(12));
  if (limits.ends_threads && !random.one_in(8)) until_thread_ends_ = static_cast<std::int64_t>(random.below(5));
  if (no_arrays_) note("no arrays");
  new_shape();
  at_hand_ = this;
}

Call* Call::at_hand_ = nullptr;

Call::~Call() {
  at_hand_ = nullptr;
  for (void* block : memory_)
    std::free(block);
}

bool Call::goes_wrong() {
  return wrong_in_ != 0 && random.one_in(wrong_in_);
}

void Call::note(const std::string& what) {
  if (outcome.arguments.size() < 600) outcome.arguments += (outcome.arguments.empty() ? "" : ", ") + what;
}

void Call::require(bool condition, const char* what) {
  if (!condition && outcome.fault.empty()) outcome.fault = what;
}

void* Call::exact(std::size_t size) {
  void* const block = std::malloc(size);
  if (size > 0) std::memset(block, 0x5a, size);
  memory_.push_back(block);
  return block;
}

void* Call::output_buffer() {
  constexpr std::size_t buffers = 10;
  static char* const all = static_cast<char*>(mmap(nullptr, buffers * output_bytes, PROT_READ | PROT_WRITE,
                                                   MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0));
  if (outputs_ > 0 && goes_wrong())
    note("two outputs in one array");
  else
    outputs_ = (outputs_ + 1) % buffers;
  return all + outputs_ * output_bytes;
}

double Call::number() {
  static constexpr double odd[] = {-1,
                                   -1e-300,
                                   1e-300,
                                   1e300,
                                   -1e300,
                                   5e-324,
                                   1e18,
                                   std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::max()};
  static constexpr double plausible[] = {0, 0.1, 0.5, 1, 1, 2, 3.5, 30, 1e-6, -0.5};
  const bool hostile = goes_wrong();
  return noted(hostile ? random.of(odd) : random.of(plausible), hostile);
}

// Arrays of 65536 numbers: positions of the shape, directions, turns, anything; some with a few entries that are odd.
const double* Call::numbers(const char* name) {
  const std::string_view what(name);
  std::size_t kind = random.below(8);
  if (random.one_in(2)) {
    if (what.ends_with("directions")) kind = 3;
    if (what == "polycube" || what.ends_with("positions") || what == "targets") kind = 4;
    if (what == "frames" || what == "rotation" || what.starts_with("matri") || what.ends_with("weights")) kind = 2;
    if (what == "lower") kind = 0;
    if (what == "upper" || what == "scale" || what == "sign") kind = 1;
  }
  auto* const to = static_cast<double*>(exact(array_length * sizeof(double)));
  const std::size_t filled = 4096;  // more than any count reads; the rest is zero
  std::memset(to, 0, array_length * sizeof(double));
  for (std::size_t i = 0; i < filled; ++i) {
    const double any = static_cast<double>(random.below(2001)) / 1000 - 1;
    const double place = last_.empty() ? any : last_[i % last_.size()];
    to[i] = kind == 0 ? 0 : kind == 1 ? 1 : kind == 2 ? (i % 4 == 0) : kind <= 4 ? place : any;
  }
  if (kind == 3 || kind == 5) {  // directions
    for (std::size_t i = 0; i + 3 <= filled; i += 3) {
      const double length = std::hypot(to[i], to[i + 1], to[i + 2]);
      for (std::size_t k = 0; k < 3 && length > 0; ++k)
        to[i + k] /= length;
    }
  }
  if (kind == 6) {
    for (std::size_t i = 0; i < filled; ++i)
      to[i] = std::abs(to[i]);
  }
  if (goes_wrong()) {
    for (int k = 0; k < 3; ++k) {
      const bool rest = std::exchange(wrong_in_, 1u) != 0;
      to[random.below(random.one_in(2) ? 12 : filled)] = number();
      wrong_in_ = rest ? 8 : 0;
    }
  }
  return to;
}

// Indices, bytes, or where lists begin: these do not fall, and end within the arrays that they are about.
const void* Call::indices(const char* name, std::size_t size) {
  const std::string_view what(name);
  const bool begins = size > 1 && (what.ends_with("start") || what.ends_with("starts") || what.ends_with("begin"));
  const std::size_t length = 4096, below = random.one_in(2) ? 1 : 1 + random.below(20);
  auto* const to = static_cast<unsigned char*>(exact(array_length * size));
  std::memset(to, 0, array_length * size);
  std::uint64_t at = 0;
  for (std::size_t i = 0; i < length; ++i) {
    std::uint64_t value = begins ? at : random.below(below);
    if (begins) at += random.below(3);
    if (begins && goes_wrong()) value = random.below(50);  // falls
    if (!begins && goes_wrong()) value = random.one_in(2) ? UINT64_MAX : random.below(100000);
    // Sides of an image, whose labels are an array too: their product is within its length, or overflows.
    if (what == "size" && value > 40) value = UINT64_MAX;
    std::memcpy(to + i * size, &value, size);
  }
  return to;
}

std::uint64_t Call::count_of(const char* name, std::size_t size) {
  const std::string_view what(name);
  if (what == "struct_size") {
    static constexpr std::uint64_t odd[] = {0, 1, 3, SIZE_MAX};
    return goes_wrong() ? random.of(odd) : init_size_;
  }
  if (no_arrays_ && random.one_in(2)) {
    static constexpr std::uint64_t huge[] = {100000,
                                             UINT32_MAX,
                                             UINT64_MAX,
                                             UINT64_MAX / 2,
                                             UINT64_MAX / 8 + 1,
                                             UINT64_MAX / 24,
                                             UINT64_MAX / 24 + 1,
                                             std::uint64_t{1} << 40};
    const std::uint64_t value = random.of(huge);
    note(std::string(name) + " " + std::to_string(value));
    return size == 4 ? value & UINT32_MAX : value;
  }
  if (array_of_structs_ && what.ends_with("count")) return noted(random.below(array_size + 1), true);
  if (what.ends_with("degree")) return random.below(9);
  if (what == "channels" || what == "components" || what == "dimension") return goes_wrong() ? 0 : 1 + random.below(4);
  if (what == "resolution") return random.one_in(2) ? 1u << random.below(4) : random.below(9);
  if (what == "m" || what == "residuals") return random.below(4);
  if (goes_wrong()) return noted(random.below(2), true);
  return 1 + random.below(random.one_in(3) ? largest_count : 6);
}

// ---- meshes

void Call::new_shape() {
  const Mesh& mesh = meshes()[random.below(meshes().size())];
  shape_ = mesh.positions;
  triangles_ = mesh.triangles;
  tetrahedra_ = mesh.tetrahedra;
  if (random.one_in(16)) {
    static constexpr double scales[] = {1e-300, 1e-150, 1e-12, 1e12, 1e150, 1e300};
    const double scale = random.of(scales);
    for (double& x : shape_)
      x *= scale;
    note("scale " + std::to_string(std::log10(scale)));
  }
  while (goes_wrong()) {
    static constexpr double odd[] = {
        0, 1e300, -1e300, 1e-300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()};
    shape_[random.below(shape_.size())] = random.of(odd);
    note("an odd coordinate");
  }
  for (auto* all : {&triangles_, &tetrahedra_}) {
    while (goes_wrong()) {
      (*all)[random.below(all->size())] =
          random.one_in(3) ? UINT32_MAX : static_cast<std::uint32_t>(random.below(shape_.size() / 3 + 1));
      note("an odd index");
    }
  }
}

const void* Call::shape_positions(bool as_floats) {
  if (goes_wrong() || no_arrays_) return missing<void>();
  last_ = shape_;
  const std::size_t n = shape_.size();
  void* const to = exact(n * (as_floats ? sizeof(float) : sizeof(double)));
  for (std::size_t i = 0; i < n; ++i) {
    if (as_floats)
      static_cast<float*>(to)[i] = static_cast<float>(std::clamp(shape_[i], -3e38, 3e38));
    else
      static_cast<double*>(to)[i] = shape_[i];
  }
  return to;
}

const std::uint32_t* Call::cells(int corners) {
  if (goes_wrong() || no_arrays_) return missing<std::uint32_t>();
  const auto& from = corners == 3 ? triangles_ : tetrahedra_;
  auto* const to = static_cast<std::uint32_t*>(exact(from.size() * sizeof(std::uint32_t)));
  std::copy(from.begin(), from.end(), to);
  return to;
}

std::size_t Call::vertex_count() {
  if (no_arrays_) return count<std::size_t>("count");
  const std::size_t all = shape_.size() / 3;
  return goes_wrong() ? noted(random.below(all), true) : all;
}

std::size_t Call::cell_count(int corners) {
  if (no_arrays_) return count<std::size_t>("count");
  const std::size_t all = (corners == 3 ? triangles_ : tetrahedra_).size() / static_cast<std::size_t>(corners);
  if (corners == 8) return random.one_in(3) ? all / 2 : 0;
  return goes_wrong() ? noted(random.below(all), true) : all;
}

// ---- texts, files, saved runs

const void* Call::bytes() {
  std::vector<char> content;
  const auto& examples = files();
  if (!random.one_in(4))
    content = examples[random.below(examples.size())];
  else
    for (std::size_t i = random.below(300); i > 0; --i)
      content.push_back(static_cast<char>(random.next()));
  while (!content.empty() && random.one_in(3))
    content[random.below(content.size())] = static_cast<char>(random.next());
  bytes_size_ = goes_wrong() ? random.below(content.size() + 1) : content.size();
  if (no_arrays_ || goes_wrong()) return missing<void>();
  void* const to = exact(content.size());
  std::copy(content.begin(), content.end(), static_cast<char*>(to));
  return to;
}

const char* Call::path(const char* library) {
  static const char* const endings[] = {".obj", ".off",  ".ply", ".stl", ".mesh", ".vtk", ".glb",          ".gltf",
                                        ".sh",  ".coef", ".png", ".pfm", ".none", "",     "/no/folder.ply"};
  static const auto& usual = *new std::map<std::string, std::vector<std::string>>{
      {"gltf", {".glb", ".gltf"}}, {"harmonics", {".sh", ".coef"}}, {"sphere_map", {".png", ".pfm"}}};
  static const std::string& folder = *new std::string(scratch_folder());
  if (goes_wrong()) return missing<char>();
  std::string path = random.one_in(20) ? folder : folder + "/a" + random.of(endings);
  if (const auto own = usual.find(library); own != usual.end() && !random.one_in(4))
    path = folder + "/a" + own->second[random.below(own->second.size())];
  return std::strcpy(static_cast<char*>(exact(path.size() + 1)), path.c_str());
}

const char* Call::shape() {
  static const char* const names[] = {"sphere", "cube", "torus", "creature", "box", "ellipsoid", "", "no such shape"};
  return goes_wrong() ? missing<char>() : random.of(names);
}

const char* Call::text() {
  static const char* const texts[] = {
      "", "a", "{}", "{\"a\":1}", "{", "\xff\xfe", "surface", "smile", "0123456789abcdef0123456789"};
  return random.one_in(3) ? nullptr : random.of(texts);
}

const void* Call::saved_blob(const char* solver) {
  std::vector<char> content = saved()[solver];
  if (content.empty()) return bytes();
  while (goes_wrong())
    content[random.below(content.size())] = static_cast<char>(random.next());
  bytes_size_ = goes_wrong() ? random.below(content.size() + 1) : content.size();
  if (goes_wrong()) return missing<void>();
  void* const to = exact(content.size());
  return std::memcpy(to, content.data(), content.size());
}

void Call::keep(const char* solver, const void* blob, std::size_t size) {
  const char* const from = static_cast<const char*>(blob);
  if (from != nullptr && size <= output_bytes) saved()[solver].assign(from, from + size);
}

// ---- what is lent, and callbacks

obc_error* Call::error() {
  if (random.one_in(12)) return nullptr;
  std::memset(&error_, 'x', sizeof error_);
  has_error_ = true;
  return &error_;
}

const obc_host* Call::host() {
  if (no_host_) return missing<obc_host>();
  auto* const host = static_cast<obc_host*>(exact(sizeof(obc_host)));
  lend(random, no_arrays_, *host);
  if (goes_wrong()) {
    static constexpr std::uint32_t odd[] = {0, 1, 3};
    host->struct_size = random.of(odd);
    note("struct_size of the host");
  }
  return host;
}

void Call::enter_callback() {
  require(inside_, "a callback outside of the call");
  ++callbacks_;
  if (--until_thread_ends_ >= 0) return;
  if (random.one_in(2)) pthread_exit(nullptr);
  pthread_cancel(pthread_self());  // takes effect at the next report, or in the C library
}

std::int32_t Call::answer() {
  static constexpr std::int32_t odd[] = {-1, 3, 12345, INT32_MIN, INT32_MAX};
  if (callbacks_ > 3000 || seconds() - begun_ > seconds_to_cancel_) return 1;
  if (answers_ == 0 && random.one_in(10)) return 2;
  if (answers_ == 1 && random.one_in(20)) return 1;
  if (answers_ == 2 && random.one_in(20)) return random.of(odd);
  return 0;
}

void Call::write_answer(double* to, std::size_t length, const double* x, std::size_t dimension) {
  static constexpr double odd[] = {
      1e300, -1e300, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0, 5e-324};
  if (to == nullptr) return;
  double sum = 0;
  for (std::size_t i = 0; x != nullptr && i < dimension; ++i)
    sum += (x[i] - 1) * (x[i] - 1);
  for (std::size_t i = 0; i < length; ++i) {
    to[i] = length == 1 ? sum : x != nullptr && i < dimension ? 2 * (x[i] - 1) : 0;
    if (answers_ == 3 && random.one_in(10)) to[i] = random.of(odd);
    if (answers_ == 4) to[i] = -to[i];
  }
}

// ---- the call

double Call::seconds() const {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void Call::start() {
  inside_ = true;
  begun_ = seconds();
}

void Call::end() {
  const double now = seconds();
  outcome.seconds = now - begun_;
  inside_ = false;
  outcome.succeeded = true;  // unless check() says otherwise
  allow_allocations();
  if (reported_cancel_) outcome.after_cancel = now - cancelled_at_;
  require(outcome.after_cancel <= limits_.after_cancel, "goes on for too long after a cancel");
  require(outcome.seconds <= seconds_to_cancel_ + limits_.seconds,
          "takes too long without a report that could stop it");
}

void Call::check(obc_status status, bool reported) {
  outcome.succeeded = status == OBC_OK;
  require(status <= OBC_OK && status >= OBC_INTERNAL, "a status that there is not");
  require(status != OBC_INTERNAL, "a defect of the library");
  if (harvest_ != nullptr) harvest_(*this, status == OBC_OK);
  if (keep_ != nullptr && status == OBC_OK) keep_(*this, to_keep_);
  if (!reported || !has_error_) return;
  const auto ends = [](const char* of, std::size_t size) { return std::memchr(of, 0, size) != nullptr; };
  require(error_.status == status, "the error has another status than the function");
  if (!ends(error_.kind, sizeof error_.kind) || !ends(error_.message, sizeof error_.message)) {
    require(false, "a text of an error does not end");
    return;
  }
  const bool filled = error_.kind[0] != '\0' && error_.message[0] != '\0';
  require(status == OBC_OK ? error_.kind[0] == '\0' && error_.message[0] == '\0' : filled,
          "the error is filled where there is none, or has no kind or message where there is one");
  outcome.message = error_.message;
}

void Call::look_at(const char* text) {
  if (text != nullptr) require(std::strlen(text) < 100000, "a text without an end");
}

}  // namespace hostile
