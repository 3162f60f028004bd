#include "apps/lippmann/progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace lippmann::app {
namespace {

constexpr int kBarWidth = 32;
constexpr auto kRedrawInterval = std::chrono::milliseconds(100);

}  // namespace

Progress::Progress(int total, bool terminal) : total_(total), terminal_(terminal) {
  if (terminal_) draw();
}

Progress::~Progress() {
  if (terminal_) fmt::print(stderr, "\n");
}

void Progress::step(const std::string& line) {
  const std::lock_guard lock(mutex_);
  ++done_;
  within_ = 0.0;
  if (!terminal_) {
    fmt::print(stderr, "[{}/{}] {}\n", done_, total_, line);
  } else if (done_ == total_ || Clock::now() - drawn_ >= kRedrawInterval) {
    draw();
  }
}

void Progress::within(double share) {
  if (!terminal_) return;
  const std::lock_guard lock(mutex_);
  within_ = std::max(within_, share < 1.0 ? share : 0.0);  // threads report out of order; a frame that is done counts as such
  if (Clock::now() - drawn_ >= kRedrawInterval) draw();
}

void Progress::draw() {
  drawn_ = Clock::now();
  const double elapsed = std::chrono::duration<double>(drawn_ - start_).count();
  const double share = total_ > 0 ? std::min(1.0, (done_ + within_) / total_) : 1.0;
  const int filled = static_cast<int>(share * kBarWidth);
  const std::string rate = done_ == 0 ? "" : fmt::format("{:5.1f} frames/s  ", done_ / elapsed);
  const std::string left = share > 0.0 ? rate + clock_text(elapsed / share - elapsed) + " left" : rate;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{}  {}\x1b[K", "", filled, "", kBarWidth - filled, done_, total_, left);
  std::fflush(stderr);
}

bool Progress::stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace lippmann::app
