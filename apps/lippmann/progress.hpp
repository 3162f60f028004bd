// Shows on stderr how far a render is: a bar with the time left on a terminal, one line per frame elsewhere.
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace lippmann::app {

class Progress {
 public:
  Progress(int total, bool terminal);
  /// Leaves the line that the bar stands in.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more is done; `line` says what, where there is no bar.
  void step(const std::string& line);

  /// The one under way is done up to `share`, 0 to 1: moves the bar. Any thread.
  void within(double share);

  /// Whether stderr is a terminal.
  static bool stderr_is_terminal();

 private:
  using Clock = std::chrono::steady_clock;
  void draw();

  std::mutex mutex_;  ///< what follows
  int total_, done_ = 0;
  double within_ = 0.0;
  bool terminal_;
  Clock::time_point start_ = Clock::now(), drawn_;
};

/// "0:07", "12:34", "3:00:05".
std::string clock_text(double seconds);

}  // namespace lippmann::app
