// One hostile call of a C function: draws every argument by its kind, from a seed, and checks what comes back. The
// table of functions is written by generate.py from api.json.
//
// What a caller has to keep is kept: arrays have the lengths that their counts say, handles are live or NULL, callbacks
// return. All else may happen: NULL anywhere, numbers that are not finite, indices out of range, structs of any
// declared size, memory that ends, work that is cancelled, callbacks that fail.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "orbicube/base.h"

namespace hostile {

class Call;

struct Function {
  const char* name;
  void (*call)(Call&);
  bool cancels;  // it takes a host, so that a report can stop it
};
const std::vector<Function>& functions();
void release_handles();

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();  // splitmix64
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
  bool one_in(std::size_t n) { return below(n) == 0; }
  template <class T, std::size_t n>
  T of(const T (&choices)[n]) {
    return choices[below(n)];
  }

 private:
  std::uint64_t state_;
};

// What a call came to, for the driver.
struct Outcome {
  std::string fault;        // empty where all is well
  std::string arguments;    // what was drawn
  std::string message;      // of the error
  bool succeeded = false;   // OBC_OK, or nothing to fail at
  double seconds = 0;       // of the processor, in the thread of the call
  double after_cancel = 0;  // the same, since a report was cancelled
};

// What the driver lets a call take.
struct Limits {
  double seconds_to_cancel = 0.1;  // then reports are cancelled
  double seconds_of_some = 3;      // the same for one call in twenty
  double after_cancel = 0.5;       // and the call must end within this time
  double seconds = 3;              // of a call that reports nothing
  bool ends_threads = false;  // callbacks end the thread that calls (pthread_exit or pthread_cancel), in most calls
};

class Call {
 public:
  Call(std::uint64_t seed, const Limits& limits, bool may_go_without_host);
  ~Call();
  Call(const Call&) = delete;
  Call& operator=(const Call&) = delete;

  Outcome outcome;

  // The one that callbacks are of: handles keep them for longer than the call that gave them.
  static Call& at_hand() { return *at_hand_; }

  // ---- kinds of arguments
  double number();
  template <class Integer>
  Integer wish() {
    static constexpr std::int64_t plausible[] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 3, 4, 6, 10, 100};
    static constexpr std::int64_t odd[] = {-1,        -2,        7,         1000,      100000,
                                           INT32_MAX, INT32_MIN, INT64_MAX, INT64_MIN, UINT32_MAX};
    const bool hostile = goes_wrong();
    return noted(static_cast<Integer>(hostile ? random.of(odd) : random.of(plausible)), hostile);
  }
  template <class Integer>
  Integer count(const char* name) {
    return static_cast<Integer>(count_of(name, sizeof(Integer)));
  }
  template <class T>
  const T* input(const char* name) {
    if (goes_wrong() || no_arrays_) return missing<T>();
    if constexpr (std::is_same_v<T, double> || std::is_same_v<T, float>) {
      return numbers_as<T>(name);
    } else {
      return static_cast<const T*>(indices(name, sizeof(T)));
    }
  }
  template <class T>
  T* output() {
    // Some are read as well, so that no count may be beyond them.
    if (random.one_in(12) || goes_wrong() || no_arrays_) return const_cast<T*>(missing<T>());
    return static_cast<T*>(output_buffer());
  }
  template <class T>
  const T** shown() {
    static const T* place;
    return goes_wrong() ? nullptr : &place;
  }
  template <class T>
  const T* positions() {
    return static_cast<const T*>(shape_positions(sizeof(T) == sizeof(float)));
  }
  const std::uint32_t* cells(int corners);
  std::uint32_t* cells_in_place(int corners) { return const_cast<std::uint32_t*>(cells(corners)); }
  std::size_t vertex_count();
  std::size_t cell_count(int corners);
  const void* bytes();
  std::size_t bytes_size() const { return bytes_size_; }
  const char* path(const char* library);
  const char* shape();
  const char* text();
  obc_error* error();
  const obc_host* host();
  template <class F>
  F* optional(F* function) {
    if (!random.one_in(8) && !goes_wrong()) return function;
    note("no callback");
    return nullptr;
  }
  bool changes() { return !no_host_ && random.one_in(8); }  // whether a number of a struct leaves its default
  bool spared() { return random.one_in(2); }                // whether an array of a struct is not there

  // ---- structs
  template <class S>
  S* uninitialized() {
    init_size_ = random.one_in(4) ? random.below(4096) : sizeof(S);
    return goes_wrong() ? nullptr : static_cast<S*>(exact(init_size_));
  }
  template <class S, class Fill>
  const S* given(obc_status (*init)(S*, std::size_t), bool versioned, const Fill& fill) {
    const bool optional_struct = versioned && random.one_in(no_host_ ? 2 : 6);
    if (optional_struct || goes_wrong()) return missing<S>();
    if (!versioned && random.one_in(3)) new_shape();
    S value;
    start(value, init, versioned);
    fill(*this, value);
    return sized(value, versioned);
  }
  template <class S>
  static const S*& kept_problem() {
    static const S* kept = nullptr;
    return kept;
  }
  template <class S, class Fill>
  const S* problem(obc_status (*init)(S*, std::size_t), bool versioned, const Fill& fill) {
    const S*& kept = kept_problem<S>();
    if (kept != nullptr && !random.one_in(3)) return kept;
    const S* const made = given(init, versioned, fill);
    if (kept == nullptr && made != nullptr) {
      keep_ = [](Call& c, const void* one) {
        kept_problem<S>() = static_cast<const S*>(one);
        // With all that it points at, until the process ends.
        static auto& blocks = *new std::vector<std::vector<void*>>;
        blocks.push_back(std::exchange(c.memory_, {}));
      };
      to_keep_ = made;
    }
    return made;
  }
  template <class S>
  S* result(obc_status (*init)(S*, std::size_t), bool versioned) {
    if (random.one_in(6) || goes_wrong()) return const_cast<S*>(missing<S>());
    S value;
    start(value, init, versioned);
    return sized(value, versioned);
  }
  template <class S, class Fill>
  const S* structs(const Fill& fill) {
    array_of_structs_ = true;
    if (goes_wrong() || no_arrays_) return missing<S>();
    S* const all = static_cast<S*>(exact(array_size * sizeof(S)));
    for (std::size_t i = 0; i < array_size; ++i) {
      std::memset(&all[i], 0, sizeof(S));
      new_shape();
      fill(*this, all[i]);
    }
    return all;
  }

  // ---- handles
  template <class H>
  static std::vector<H*>& pool() {
    static auto& all = *new std::vector<H*>;  // also in use while the process ends
    return all;
  }
  template <class H>
  H* handle() {
    auto& all = pool<H>();
    if (all.empty() || goes_wrong()) return const_cast<H*>(missing<H>());
    return all[random.below(all.size())];
  }
  template <class H>
  H* take_handle() {
    auto& all = pool<H>();
    // The last two stay, for the functions that need one.
    if (all.size() < 3 || random.one_in(8)) return nullptr;
    std::swap(all[random.below(all.size())], all.back());
    H* const taken = all.back();
    all.pop_back();
    return taken;
  }
  template <class H>
  H** handles() {
    array_of_structs_ = true;
    if (goes_wrong() || no_arrays_) return const_cast<H**>(missing<H*>());
    H** const all = static_cast<H**>(exact(array_size * sizeof(H*)));
    H* const one = handle<H>();
    for (std::size_t i = 0; i < array_size; ++i)
      all[i] = random.one_in(2) ? one : handle<H>();
    return all;
  }
  template <class H>
  H** handle_out() {
    if (goes_wrong()) return const_cast<H**>(missing<H*>());
    H** const out = static_cast<H**>(exact(array_size * sizeof(H*)));
    std::fill_n(out, array_size, reinterpret_cast<H*>(this));  // no handle
    handle_out_ = out;
    harvest_ = [](Call& c, bool succeeded) {
      H** const made = static_cast<H**>(c.handle_out_);
      for (std::size_t i = 0; i < array_size; ++i) {
        if (made[i] == reinterpret_cast<H*>(&c) || made[i] == nullptr) continue;
        c.require(succeeded, "a handle was handed out by a function that failed");
        pool<H>().push_back(made[i]);
      }
      c.require(!succeeded || (made[0] != nullptr && made[0] != reinterpret_cast<H*>(&c)), "success without a handle");
    };
    return out;
  }

  // ---- saved runs
  const void* saved_blob(const char* solver);
  std::size_t saved_size(const char*) const { return bytes_size_; }
  std::size_t capacity(std::size_t wanted) {
    return goes_wrong() ? random.below(wanted + 1) : std::min<std::size_t>(wanted, output_bytes);
  }
  void keep(const char* solver, const void* blob, std::size_t size);

  // ---- callbacks
  void enter_callback();  // may not return
  std::int32_t answer();
  void write_answer(double* to, std::size_t length, const double* x, std::size_t dimension);

  // ---- the call and its end
  void start();
  void end();
  void check(obc_status status, bool reported);
  void look_at(const char* text);
  void require(bool condition, const char* what);

 private:
  friend struct Lent;
  static constexpr std::size_t array_size = 4;            // of arrays of structs and handles
  static constexpr std::size_t output_bytes = 64u << 20;  // of each array that a function may fill

  bool goes_wrong();
  void note(const std::string& what);
  template <class T>
  T noted(T value, bool hostile) {
    if (hostile) note(std::to_string(value));
    return value;
  }
  template <class T>
  const T* missing() {
    note("NULL");
    return nullptr;
  }
  void* exact(std::size_t size);  // of this size to the byte, until the call has ended
  void* output_buffer();
  const void* indices(const char* name, std::size_t size);
  const double* numbers(const char* name);
  template <class T>
  const T* numbers_as(const char* name) {
    const double* const from = numbers(name);
    if constexpr (std::is_same_v<T, double>) {
      return from;
    } else {
      constexpr std::size_t length = 4096;
      T* const copy = static_cast<T*>(exact(length * sizeof(T)));
      for (std::size_t i = 0; i < length; ++i)
        copy[i] = static_cast<T>(std::clamp(from[i], -3e38, 3e38));
      return copy;
    }
  }
  const void* shape_positions(bool as_floats);
  std::uint64_t count_of(const char* name, std::size_t size);
  void new_shape();
  template <class S>
  void start(S& value, obc_status (*init)(S*, std::size_t), bool versioned) {
    std::memset(&value, 0, sizeof value);
    if (init != nullptr) require(init(&value, sizeof value) == OBC_OK, "an _init function failed");
    if (versioned) {
      const std::uint32_t size = sizeof value;
      std::memcpy(&value, &size, sizeof size);
    }
  }
  // The struct in memory of the size that it says, which may be that of another header.
  template <class S>
  S* sized(S& value, bool versioned) {
    std::size_t size = sizeof value;
    if (versioned && goes_wrong()) {
      static constexpr std::size_t odd[] = {0, 1, 3, 4, 8, sizeof(S) - 1, sizeof(S) + 1, sizeof(S) + 200};
      size = random.of(odd);
      const auto told = static_cast<std::uint32_t>(size);
      std::memcpy(&value, &told, sizeof told);
      note("struct_size " + std::to_string(size));
    }
    auto* const to = static_cast<S*>(exact(std::max<std::size_t>(size, 4)));
    if (size > sizeof value) std::memset(static_cast<void*>(to), 0, size);
    std::memcpy(static_cast<void*>(to), &value, std::min(std::max<std::size_t>(size, 4), sizeof value));
    return to;
  }
  double seconds() const;

  static Call* at_hand_;
  Random random;
  const Limits& limits_;
  unsigned wrong_in_ = 0;   // one argument in so many goes wrong; 0: none
  bool no_host_ = false;    // and so small work, which nothing can stop
  bool no_arrays_ = false;  // no arrays, and so counts of any size
  bool array_of_structs_ = false;

  std::vector<double> shape_;  // positions
  std::vector<std::uint32_t> triangles_, tetrahedra_;
  std::vector<double> last_;  // positions that were given last, for maps of them
  std::vector<void*> memory_;
  std::size_t outputs_ = 0, init_size_ = 0, bytes_size_ = 0;
  obc_error error_{};
  bool has_error_ = false;
  void* handle_out_ = nullptr;
  void (*harvest_)(Call&, bool) = nullptr;
  void (*keep_)(Call&, const void*) = nullptr;
  const void* to_keep_ = nullptr;

  std::int64_t until_cancel_ = INT64_MAX;  // reports
  double seconds_to_cancel_ = 0;
  std::uint64_t callbacks_ = 0;
  bool reported_cancel_ = false;
  std::int64_t until_thread_ends_ = INT64_MAX;  // callbacks
  bool inside_ = false;  // of the call; its time does not tell, as a thread's clock may begin at zero
  double begun_ = 0, cancelled_at_ = 0;
  int answers_ = 0;
};

}  // namespace hostile
