#include "compare/plot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/atomic_file.hpp"
#include "core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Up to here gnuplot would put marks between frames.
constexpr std::size_t kFewFrames = 20;

/// A string in gnuplot's single quotes, where only the quote itself is special.
std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

/// The number at the end of a frame's name, if there is one: what people call the frame.
std::optional<long> trailing_number(const std::string& name) {
  constexpr std::size_t kMostDigits = 9;
  std::size_t begin = name.size();
  while (begin > 0 && name[begin - 1] >= '0' && name[begin - 1] <= '9') --begin;
  if (begin == name.size() || name.size() - begin > kMostDigits) return std::nullopt;
  return std::stol(name.substr(begin));
}

std::string make_script(const Comparison& comparison, const fs::path& picture) {
  std::string script = "$psnr << EOD\n";
  for (std::size_t i = 0; i < comparison.frames.size(); ++i) {
    const double psnr = comparison.frames[i].metrics.psnr_db;
    const long frame = trailing_number(comparison.frames[i].name).value_or(static_cast<long>(i));
    script += std::isfinite(psnr) ? fmt::format("{} {}\n", frame, psnr) : "\n";
  }
  script += "EOD\nset terminal pngcairo size 960,540 noenhanced font 'sans,11'\n";
  script += fmt::format("set output {}\n", quoted(picture.string()));
  script += "set xlabel 'frame'\nset ylabel 'PSNR, dB'\nset grid\nset offsets graph 0.02, graph 0.02, graph 0.1, graph 0.1\n";
  if (comparison.frames.size() <= kFewFrames) script += "set xtics 1\n";
  const std::string title = comparison.mean_psnr_db ? fmt::format("mean {:.2f} dB", *comparison.mean_psnr_db) : "identical";
  script += fmt::format("plot $psnr using 1:2 with linespoints pointtype 7 pointsize 0.5 title {}\n", quoted(title));
  return script;
}

/// The exit code, 127 if there is no such program.
int run_gnuplot(const fs::path& script) {
  std::string program = "gnuplot", file = script.string();
  char* arguments[] = {program.data(), file.data(), nullptr};
  pid_t process = 0;
  if (posix_spawnp(&process, program.c_str(), nullptr, nullptr, arguments, environ) != 0) return 127;
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128;
}

}  // namespace

void plot_psnr(const Comparison& comparison, const fs::path& path) {
  bool any = false;
  for (const FrameComparison& frame : comparison.frames) any = any || std::isfinite(frame.metrics.psnr_db);
  if (!any) throw Error(path.string(), "there is nothing to plot: every frame is identical");
  AtomicFile picture(path);
  const AtomicFile script(path.string() + ".gnuplot");  // never committed: removed at the end
  const std::string text = make_script(comparison, picture.temporary_path());
  write_file_atomically(script.temporary_path(), std::as_bytes(std::span(text)));
  const int code = run_gnuplot(script.temporary_path());
  if (code == 127) throw Error(path.string(), "drawing it needs the program gnuplot (Debian: apt install gnuplot-nox)");
  if (code != 0 || !fs::exists(picture.temporary_path()))
    throw Error(path.string(), fmt::format("gnuplot failed (exit code {})", code));
  picture.commit();
}

}  // namespace lippmann
