#include "compare/gnuplot.hpp"

#include <fmt/format.h>

#include <system_error>

#include "core/atomic_file.hpp"
#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Returns the exit code of gnuplot, or 127 if gnuplot is not installed.
int run_gnuplot(const fs::path& script) {
  std::error_code problem;
  platform::ChildProcess process({.words = {"gnuplot", script.string()}}, problem);
  return problem ? 127 : process.wait();
}

}  // namespace

std::string gnuplot_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

void draw_with_gnuplot(const fs::path& path, const std::string& commands) {
  AtomicFile picture(path);
  const AtomicFile script(path.string() + ".gnuplot");
  const std::string text = fmt::format("set terminal pngcairo size 960,540 noenhanced font 'sans,11'\nset output {}\n{}",
                                       gnuplot_quoted(picture.temporary_path().string()), commands);
  write_file_atomically(script.temporary_path(), std::as_bytes(std::span(text)));
  const int code = run_gnuplot(script.temporary_path());
  if (code == 127) throw Error(path.string(), "plots need the program gnuplot (Debian: apt install gnuplot-nox)");
  if (code != 0 || !fs::exists(picture.temporary_path()))
    throw Error(path.string(), fmt::format("gnuplot failed (exit code {})", code));
  picture.commit();
}

}  // namespace lippmann
