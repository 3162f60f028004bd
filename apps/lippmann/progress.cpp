#include "apps/lippmann/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "apps/lippmann/print.hpp"
#include "core/platform.hpp"
#include "core/printable.hpp"

namespace lippmann::app {
namespace {

constexpr int kBarWidth = 32;
constexpr auto kRedrawInterval = std::chrono::milliseconds(100);

}  // namespace

bool LineSchedule::is_due_within(double elapsed_s) {
  constexpr double kShortest_s = 30.0, kShareOfElapsed = 0.1;
  const bool due = elapsed_s - last_s_ >= std::max(kShortest_s, kShareOfElapsed * elapsed_s);
  if (due) last_s_ = elapsed_s;
  return due;
}

bool LineSchedule::is_due(int done, int total, double elapsed_s) {
  if (done != 1 && done != total) return is_due_within(elapsed_s);
  last_s_ = elapsed_s;
  return true;
}

Progress::Progress(int total, ProgressStyle style, std::function<Clock::time_point()> now)
    : total_(total), style_(style), now_(std::move(now)), start_(now_()) {
  if (style_ == ProgressStyle::kBar) draw();
}

Progress::~Progress() {
  if (style_ == ProgressStyle::kBar) print_error("\n");
}

void Progress::step(const std::string& line) {
  const std::lock_guard lock(mutex_);
  ++done_;
  within_ = 0.0;
  if (style_ == ProgressStyle::kBar) {
    advise();
    if (done_ == total_ || now_() - drawn_ >= kRedrawInterval) draw();
    return;
  }
  const double elapsed = elapsed_s();
  const bool due = schedule_.is_due(done_, total_, elapsed);
  if (style_ == ProgressStyle::kLines && !due) return;
  const std::string left = done_ < total_ ? clock_text(seconds_left(elapsed, done_, total_)) + " left" : "done";
  print_error("[{}/{}] {}; {}{}\n", done_, total_, printable_line(line), left, note());
  advise();
}

void Progress::set_advice(const std::string& advice) {
  const std::lock_guard lock(mutex_);
  advice_ = advice;
}

void Progress::advise() {
  constexpr double kLong_s = 3600.0;
  const double left_s = seconds_left(elapsed_s(), done_, total_);
  if (done_ != 1 || left_s <= kLong_s || advice_.empty()) return;
  const char* clear_bar = style_ == ProgressStyle::kBar ? "\r\x1b[K" : "";
  print_error("{}This will take about {} more. {}\n", clear_bar, clock_text(left_s), advice_);
}

void Progress::set_note(const std::string& note) {
  const std::lock_guard lock(mutex_);
  note_ = note;
}

void Progress::within(double share) {
  const std::lock_guard lock(mutex_);
  within_ = std::max(within_, share < 1.0
                                  // `share` may decrease, because threads report out of order.
                                  ? share
                                  : 0.0);
  if (style_ == ProgressStyle::kBar && now_() - drawn_ >= kRedrawInterval) draw();
}

void Progress::tick() {
  const std::lock_guard lock(mutex_);
  if (done_ == total_) return;
  if (style_ == ProgressStyle::kBar) return draw();
  const double elapsed = elapsed_s();
  if (!schedule_.is_due_within(elapsed)) return;
  const std::string share = within_ > 0.0 ? fmt::format("current frame {:.0f} %; ", 100.0 * within_) : std::string();
  print_error("[{}/{}] {}{}{}\n", done_, total_, share, left_text(elapsed), note());
}

std::string Progress::left_text(double elapsed_s) const {
  const double share = share_done();
  return share > 0.0 ? clock_text(seconds_left(elapsed_s, share, 1.0)) + " left" : clock_text(elapsed_s) + " so far";
}

double Progress::share_done() const { return total_ > 0 ? std::min(1.0, (done_ + within_) / total_) : 1.0; }

void Progress::draw() {
  drawn_ = now_();
  const double elapsed = elapsed_s(), share = share_done();
  const int filled = static_cast<int>(share * kBarWidth);
  const std::string rate = done_ == 0 ? "" : fmt::format("{:5.1f} frames/s  ", done_ / elapsed);
  const std::string left = rate + left_text(elapsed);
  print_error("\r[{:#<{}}{:.<{}}] {}/{}  {}{}\x1b[K", "", filled, "", kBarWidth - filled, done_, total_, left, note());
  std::fflush(stderr);
}

bool Progress::stderr_is_terminal() { return platform::is_stderr_terminal(); }

std::string clock_text(double seconds) {
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

Heartbeat::Heartbeat(std::function<void()> beat)
    : thread_([this, beat = std::move(beat)](const std::stop_token& stop) {
        std::unique_lock lock(mutex_);
        while (!stopped_.wait_for(lock, stop, std::chrono::seconds(1), [&] { return stop.stop_requested(); })) beat();
      }) {}

}  // namespace lippmann::app
