// Shows the progress of long work on stderr: a bar with the time left on a terminal, otherwise a line from time to time.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace lippmann::app {

enum class ProgressStyle {
  kBar,
  kLines,     ///< prints the lines that LineSchedule chooses
  kEveryLine  ///< prints a line after every step, and within long steps
};

/// Limits the number of lines in logs of long work. A line is due after the first step and after the last step. Any other line
/// is due if at least 30 s, and at least a tenth of the elapsed time, have passed since the previous line.
class LineSchedule {
 public:
  /// Returns whether the line for step `done`, counted from 1, is due. If so, counts it as printed.
  bool is_due(int done, int total, double elapsed_s);
  /// Like is_due(), but for calls during a step. A single step may take an hour.
  bool is_due_within(double elapsed_s);

 private:
  double last_s_ = 0.0;
};

/// Assumes a constant rate. Requires done > 0.
inline double seconds_left(double elapsed_s, double done, double total) { return elapsed_s / done * total - elapsed_s; }

class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// now: returns the time; replaced in tests.
  Progress(int total, ProgressStyle style, std::function<Clock::time_point()> now = Clock::now);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts one step as done. Without a bar, prints `line`.
  void step(const std::string& line);

  /// Sets advice on how to reduce the work, which is printed after the first step if more than an hour is left.
  void set_advice(const std::string& advice);

  /// Sets a note that is shown after the time left, such as the total size.
  void set_note(const std::string& note);

  /// Sets the share of the current step that is done, from 0 to 1. Thread-safe.
  void within(double share);

  /// Redraws the bar, or prints a line if the current step takes long. Call regularly, since a step may not call within().
  void tick();

  static bool stderr_is_terminal();
  /// Returns kBar if stderr is a terminal, otherwise kLines.
  static ProgressStyle usual_style() { return stderr_is_terminal() ? ProgressStyle::kBar : ProgressStyle::kLines; }

 private:
  double elapsed_s() const { return std::chrono::duration<double>(now_() - start_).count(); }
  double share_done() const;
  /// Returns the time left, as "3:00 left". While nothing is done, returns the elapsed time, as "0:30 so far".
  std::string left_text(double elapsed_s) const;
  std::string note() const { return note_.empty() ? note_ : ", " + note_; }
  void draw();
  void advise();

  std::mutex mutex_;
  int total_, done_ = 0;
  double within_ = 0.0;
  std::string note_, advice_;
  ProgressStyle style_;
  LineSchedule schedule_;
  std::function<Clock::time_point()> now_;
  Clock::time_point start_, drawn_;
};

/// Formats a duration: "0:07", "12:34", "3:00:05".
std::string clock_text(double seconds);

class Heartbeat {
 public:
  explicit Heartbeat(std::function<void()> beat);

 private:
  std::mutex mutex_;
  std::condition_variable_any stopped_;
  std::jthread thread_;  ///< declared last, so that it stops before the members that it uses are destroyed
};

}  // namespace lippmann::app
