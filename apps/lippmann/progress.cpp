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

bool LineSchedule::is_due(int done, int total, double elapsed_s) {
  constexpr double kShortest_s = 30.0, kShareOfElapsed = 0.1;
  const double interval = std::max(kShortest_s, kShareOfElapsed * elapsed_s);
  const bool due = done == 1 || done == total || elapsed_s - last_s_ >= interval;
  if (due) last_s_ = elapsed_s;
  return due;
}

Progress::Progress(int total, ProgressStyle style) : total_(total), style_(style) {
  if (style_ == ProgressStyle::kBar) draw();
}

Progress::~Progress() {
  if (style_ == ProgressStyle::kBar) fmt::print(stderr, "\n");
}

void Progress::step(const std::string& line) {
  const std::lock_guard lock(mutex_);
  ++done_;
  within_ = 0.0;
  if (style_ == ProgressStyle::kBar) {
    if (done_ == total_ || Clock::now() - drawn_ >= kRedrawInterval) draw();
    return;
  }
  const double elapsed = elapsed_s();
  if (style_ == ProgressStyle::kLines && !schedule_.is_due(done_, total_, elapsed)) return;
  const std::string left = done_ < total_ ? clock_text(seconds_left(elapsed, done_, total_)) + " left" : "done";
  fmt::print(stderr, "[{}/{}] {}; {}{}\n", done_, total_, line, left, note_.empty() ? "" : ", " + note_);
}

void Progress::set_note(const std::string& note) {
  const std::lock_guard lock(mutex_);
  note_ = note;
}

void Progress::within(double share) {
  if (style_ != ProgressStyle::kBar) return;
  const std::lock_guard lock(mutex_);
  within_ = std::max(within_, share < 1.0 ? share : 0.0);  // threads report out of order; a frame that is done counts as such
  if (Clock::now() - drawn_ >= kRedrawInterval) draw();
}

void Progress::draw() {
  drawn_ = Clock::now();
  const double elapsed = elapsed_s();
  const double share = total_ > 0 ? std::min(1.0, (done_ + within_) / total_) : 1.0;
  const int filled = static_cast<int>(share * kBarWidth);
  const std::string rate = done_ == 0 ? "" : fmt::format("{:5.1f} frames/s  ", done_ / elapsed);
  const std::string left = share > 0.0 ? rate + clock_text(seconds_left(elapsed, share, 1.0)) + " left" : rate;
  fmt::print(stderr, "\r[{:#<{}}{:.<{}}] {}/{}  {}{}\x1b[K", "", filled, "", kBarWidth - filled, done_, total_, left,
             note_.empty() ? "" : ", " + note_);
  std::fflush(stderr);
}

bool Progress::stderr_is_terminal() { return isatty(STDERR_FILENO) == 1; }

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace lippmann::app
