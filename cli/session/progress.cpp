#include "session/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace orbicube::cli {
namespace {

// Short runs are over before anybody has read the bar.
constexpr auto quiet_time = std::chrono::milliseconds(200);
constexpr auto between_drawings = std::chrono::milliseconds(80);

std::size_t terminal_width() {
  struct winsize size {};
  constexpr std::size_t usual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

}  // namespace

std::string remaining_text(double seconds) {
  const long whole = std::lround(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s left";
  char text[32];
  std::snprintf(text, sizeof text, "%ld:%02ld left", whole / 60, whole % 60);
  return text;
}

ProgressBar::ProgressBar(bool wanted) : enabled_(wanted && isatty(STDERR_FILENO) == 1), start_(Clock::now()) {}

void ProgressBar::show(const base::Progress& progress) {
  if (!enabled_) return;
  const auto now = Clock::now();
  if (now - start_ < quiet_time || now - last_drawn_ < between_drawings) return;
  last_drawn_ = now;
  std::string text = progress.phase;
  constexpr double enough = 0.02;  // to tell the time by
  if (progress.fraction > enough) {
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    text.append("  ").append(remaining_text(elapsed * (1 - progress.fraction) / progress.fraction));
  }
  draw(progress.fraction, text);
}

void ProgressBar::finish() {
  if (needed_) draw(1, "done");
  clear();
}

void ProgressBar::draw(double fraction, const std::string& text) {
  constexpr std::size_t cells = 24;
  const auto filled = static_cast<std::size_t>(fraction * cells);
  char percent[16];
  std::snprintf(percent, sizeof percent, "] %3d%%  ", static_cast<int>(100 * fraction));
  std::string line = "[";
  line.append(filled, '#').append(cells - filled, '.').append(percent).append(text);
  line.resize(std::min(line.size(), terminal_width() - 1));
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  drawn_ = needed_ = true;
}

void ProgressBar::clear() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

}  // namespace orbicube::cli
