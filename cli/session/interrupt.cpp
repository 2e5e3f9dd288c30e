#include "session/interrupt.h"

#include <csignal>
#include <initializer_list>

namespace orbicube::cli {
namespace {

volatile std::sig_atomic_t came = 0;

extern "C" void remember_interrupt(int) {
  came = 1;
}

}  // namespace

void watch_for_interrupts() {
  struct sigaction action {};
  action.sa_handler = remember_interrupt;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;  // the next one of its kind ends the program
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    // What was started to ignore a signal (nohup) goes on ignoring it.
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) continue;
    sigaction(signal, &action, nullptr);
  }
  action.sa_handler = SIG_IGN;
  action.sa_flags = 0;
  sigaction(SIGPIPE, &action, nullptr);
}

bool interrupted() {
  return came != 0;
}

}  // namespace orbicube::cli
