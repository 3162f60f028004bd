#include "apps/lippmann/interrupt.hpp"

#include <csignal>

namespace lippmann::app {
namespace {

// A signal handler can only use global state.
std::atomic<std::atomic<bool>*> g_cancelled{nullptr};
std::atomic<int> g_signal{0};

extern "C" void on_signal(int signal) {
  g_signal = signal;
  if (std::atomic<bool>* cancelled = g_cancelled.load()) cancelled->store(true);
  std::signal(signal, SIG_DFL);
}

}  // namespace

InterruptGuard::InterruptGuard(std::atomic<bool>& cancelled) {
  g_signal = 0;
  g_cancelled = &cancelled;
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

InterruptGuard::~InterruptGuard() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  g_cancelled = nullptr;
}

int InterruptGuard::exit_code() { return g_signal == 0 ? 0 : 128 + g_signal; }

}  // namespace lippmann::app
