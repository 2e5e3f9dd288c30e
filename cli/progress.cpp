#include "progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace orbicube::cli {
namespace {

// So short phases are over before anybody has read the bar.
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

ProgressBar::ProgressBar(bool wanted) : enabled_(wanted && isatty(STDERR_FILENO) == 1) {}

void ProgressBar::show(const base::Progress& progress) {
  if (!enabled_) return;
  const auto now = Clock::now();
  if (progress.phase != phase_) {
    phase_ = progress.phase;
    phase_start_ = now;
  }
  if (now - phase_start_ < quiet_time || now - last_drawn_ < between_drawings) return;
  last_drawn_ = now;
  std::string line = progress.phase;
  line += ' ';
  if (progress.total > 0) {
    const double part = std::min(1.0, static_cast<double>(progress.done) / static_cast<double>(progress.total));
    constexpr std::size_t cells = 24;
    const auto filled = static_cast<std::size_t>(part * cells);
    char percent[16];
    std::snprintf(percent, sizeof percent, "] %3d%%", static_cast<int>(100 * part));
    line += '[';
    line.append(filled, '#').append(cells - filled, '.').append(percent);
    const double elapsed = std::chrono::duration<double>(now - phase_start_).count();
    if (part > 0.01) line.append("  ").append(remaining_text(elapsed * (1 - part) / part));
  } else {
    line += std::to_string(progress.done);
  }
  line.resize(std::min(line.size(), terminal_width() - 1));
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  drawn_ = true;
}

void ProgressBar::clear() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

}  // namespace orbicube::cli
