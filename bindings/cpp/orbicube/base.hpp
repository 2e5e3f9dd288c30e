// Orbicube for C++17: what the wrappers of all libraries share. Header-only, over the C interface; nothing but the
// standard library. Errors are exceptions, handles release themselves, functions may be anything that can be called.
//
// Each header orbicube/<library>.hpp wraps orbicube/<library>.h, whose comments say what the functions do. Options are
// the C structs with their defaults filled in; reports are the C structs. The C functions can be used beside: handle()
// gives what they take.
//
// All of it is in the inline namespace `api`: the libraries' own C++ has classes of the same names, and in programs
// that link the static libraries the linker must tell the ones from the others.
#ifndef ORBICUBE_BASE_HPP
#define ORBICUBE_BASE_HPP

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>

#if defined(__GLIBCXX__)
#include <cxxabi.h>
#endif

#include <orbicube/base.h>

namespace orbicube {
inline namespace api {
namespace detail {

// Returns body(), or handler() when body throws. A thread that ends inside body (pthread_exit) is unwound by something
// that looks like an exception and must not be swallowed.
template <class Body, class Handler>
auto catch_all(const Body& body, const Handler& handler) -> decltype(body()) {
  try {
    return body();
#if defined(__GLIBCXX__)
  } catch (const abi::__forced_unwind&) {
    throw;
#endif
  } catch (...) {
    return handler();
  }
}

}  // namespace detail

// What a library refused or failed at.
class Error : public std::runtime_error {
 public:
  explicit Error(const obc_error& error)
      : std::runtime_error(std::string(error.kind) + ": " + error.message), status_(error.status), kind_(error.kind) {}
  Error(obc_status status, const std::string& message) : std::runtime_error(message), status_(status) {}

  obc_status status() const noexcept { return status_; }      // OBC_NOT_CLOSED, ...
  const std::string& kind() const noexcept { return kind_; }  // one word, such as "not-closed"

 private:
  obc_status status_;
  std::string kind_;
};

// An array that lies elsewhere: of a vector, an array, or a pointer with a count.
template <class T>
class View {
 public:
  constexpr View() noexcept = default;
  constexpr View(std::nullptr_t) noexcept {}
  constexpr View(T* data, std::size_t size) noexcept : data_(data), size_(size) {}
  template <class C, class = std::enable_if_t<std::is_convertible_v<decltype(std::data(std::declval<C&>())), T*> &&
                                              !std::is_same_v<std::remove_cv_t<std::remove_reference_t<C>>, View>>>
  constexpr View(C&& container) noexcept : data_(std::data(container)), size_(std::size(container)) {}

  constexpr T* data() const noexcept { return data_; }
  constexpr std::size_t size() const noexcept { return size_; }
  constexpr bool empty() const noexcept { return size_ == 0; }
  constexpr T& operator[](std::size_t i) const noexcept { return data_[i]; }
  constexpr T* begin() const noexcept { return data_; }
  constexpr T* end() const noexcept { return data_ + size_; }

 private:
  T* data_ = nullptr;
  std::size_t size_ = 0;
};
using Doubles = View<const double>;
using Indices = View<const std::uint32_t>;

// Where a computation stands.
struct Progress {
  const char* phase;
  std::uint64_t done, total;  // total is 0 where it is not known
  double best;                // NaN where there is none
};

// What the program lends to computations. Not copied, since they point at it; one at a time uses it.
class Host {
 public:
  Host() { obc_host_init(&host_, sizeof host_); }
  Host(const Host&) = delete;
  Host& operator=(const Host&) = delete;

  Host& threads(std::uint32_t count) {
    host_.thread_count = count;
    return *this;
  }
  // Called with a Progress; returns whether to go on. What it throws is thrown again by the function that was called.
  Host& on_progress(std::function<bool(const Progress&)> function) {
    progress_ = std::move(function);
    host_.progress = report;
    host_.progress_user = this;
    return *this;
  }
  // Called with a line for a log. What it throws is thrown again by the function that was called, when that has ended.
  Host& on_log(std::function<void(const char*)> function) {
    log_ = std::move(function);
    host_.log = write;
    host_.log_user = this;
    return *this;
  }

  obc_host& c() noexcept { return host_; }  // for what has no function here: allocator, parallel_for
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  static std::int32_t report(const char* phase, std::uint64_t done, std::uint64_t total, double best, void* user) {
    Host& self = *static_cast<Host*>(user);
    return detail::catch_all(
        [&]() -> std::int32_t {
          return !self.thrown_ && self.progress_(Progress{phase, done, total, best}) ? 0 : 1;
        },
        [&]() -> std::int32_t {
          self.thrown_ = std::current_exception();
          return 1;
        });
  }
  static void write(const char* line, void* user) {
    Host& self = *static_cast<Host*>(user);
    detail::catch_all([&] { self.log_(line); },
                      [&] {
                        if (!self.thrown_) self.thrown_ = std::current_exception();
                      });
  }

  obc_host host_;
  std::function<bool(const Progress&)> progress_;
  std::function<void(const char*)> log_;
  std::exception_ptr thrown_;
};

namespace detail {

inline const obc_host* c(Host* host) noexcept {
  return host == nullptr ? nullptr : &host->c();
}

// Calls f(error), which returns a status.
template <class F>
void call(Host* host, F&& f) {
  obc_error error;
  const obc_status status = f(&error);
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
}

inline void check_size(std::size_t size, std::size_t wanted, const char* what) {
  if (size != wanted)
    throw Error(OBC_INVALID_ARGUMENT,
                std::string(what) + ": " + std::to_string(wanted) + " entries are needed, not " + std::to_string(size));
}
inline std::size_t rows(std::size_t size, std::size_t columns, const char* what) {
  if (size % columns != 0)
    throw Error(OBC_INVALID_ARGUMENT,
                std::string(what) + ": " + std::to_string(size) + " is no multiple of " + std::to_string(columns));
  return size / columns;
}

// What a user's function throws must not pass through C: it is kept, and thrown again on the other side.
class Caught {
 public:
  template <class F>
  std::int32_t guard(F&& f, std::int32_t stop = 1) {
    return catch_all([&]() -> std::int32_t { return f(); },
                     [&]() -> std::int32_t {
                       thrown_ = std::current_exception();
                       return stop;
                     });
  }
  void rethrow() {
    if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  }

 private:
  std::exception_ptr thrown_;
};

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* handle) const noexcept {
    destroy(handle);
  }
};
template <class T, auto destroy>
using Handle = std::unique_ptr<T, Destroy<destroy>>;

// Calls f(&out, error), which returns a status. What it hands out is owned at once: the host's log may have thrown
// while the work went on to its end.
template <class T, auto destroy, class F>
Handle<T, destroy> take(Host* host, F&& f) {
  T* out = nullptr;
  obc_error error;
  const obc_status status = f(&out, &error);
  Handle<T, destroy> owned(out);
  if (host != nullptr) host->rethrow();
  if (status != OBC_OK) throw Error(error);
  return owned;
}

// A C struct with its defaults.
template <class T, auto init>
struct Filled : T {
  Filled() : T() {
    const obc_status status = init(this, sizeof(T));
    if (status != OBC_OK) throw Error(status, "the library does not know this struct");
  }
};

// A C struct that has no function to fill it.
template <class T>
T sized() {
  T result{};
  result.struct_size = sizeof(T);
  return result;
}

}  // namespace detail

// Thrown by a user's function where it has no value: the solver goes on elsewhere.
struct EvaluationFailed {};
// Thrown by a user's function: the run ends as cancelled, with the best point so far; Stop{value} counts the value at
// x, and for residuals what was filled, if all of it was.
struct Stop {
  double value = std::numeric_limits<double>::quiet_NaN();
};

}  // namespace api
}  // namespace orbicube

#endif
