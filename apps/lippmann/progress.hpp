// Shows on stderr how far long work is: a bar with the time left on a terminal, elsewhere a line now and then, or what is asked
// for.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace lippmann::app {

enum class ProgressStyle {
  kBar,       ///< one line that is drawn again and again
  kLines,     ///< a line after the first, the last and, ever less often, some in between, and within what takes long
  kEveryLine  ///< a line each, and within what takes long
};

/// Which of the things that are done get a line, so that a log of hours stays short: the first, the last, and one whenever 30 s
/// and a tenth of the time so far have passed since the line before.
class LineSchedule {
 public:
  /// done: that one included. Notes that a line is printed where it is due.
  bool is_due(int done, int total, double elapsed_s);
  /// The same of what is under way: nobody should wait an hour for the first line.
  bool is_due_within(double elapsed_s);

 private:
  double last_s_ = 0.0;
};

/// How long all of it takes from here, if the rest goes as what is done has. done > 0.
inline double seconds_left(double elapsed_s, double done, double total) { return elapsed_s / done * total - elapsed_s; }

class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// now: tests have a clock of their own.
  Progress(int total, ProgressStyle style, std::function<Clock::time_point()> now = Clock::now);
  /// Leaves the line that the bar stands in.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done; `line` says what, where there is no bar.
  void step(const std::string& line);

  /// Printed once, after the first step, if more than an hour is left then: how to ask for less work.
  void set_advice(const std::string& advice);

  /// What else is known of the whole from now on, such as its size; stands behind the time left.
  void set_note(const std::string& note);

  /// The one under way is done up to `share`, 0 to 1: moves the bar. Any thread.
  void within(double share);

  /// Time has gone by: a line about the one under way, where it takes long. Not all that takes long knows its share.
  void tick();

  /// Whether stderr is a terminal.
  static bool stderr_is_terminal();

 private:
  double elapsed_s() const { return std::chrono::duration<double>(now_() - start_).count(); }
  double share_done() const;
  /// "3:00 left", or "0:30 so far" where nothing is known yet.
  std::string left_text(double elapsed_s) const;
  /// ", files: about 12 MB".
  std::string note() const { return note_.empty() ? note_ : ", " + note_; }
  void draw();
  void advise();

  std::mutex mutex_;  ///< what follows
  int total_, done_ = 0;
  double within_ = 0.0;
  std::string note_, advice_;
  ProgressStyle style_;
  LineSchedule schedule_;
  std::function<Clock::time_point()> now_;
  Clock::time_point start_, drawn_;
};

/// "0:07", "12:34", "3:00:05".
std::string clock_text(double seconds);

/// Calls `beat` every second, in a thread of its own, until it is destroyed.
class Heartbeat {
 public:
  explicit Heartbeat(std::function<void()> beat);

 private:
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;  ///< last: stops before what it uses goes
};

}  // namespace lippmann::app
