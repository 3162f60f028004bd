#include "compare/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>

#include "core/atomic_file.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

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

std::string gnuplot_quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result + "'";
}

void draw_with_gnuplot(const fs::path& path, const std::string& commands) {
  AtomicFile picture(path);
  const AtomicFile script(path.string() + ".gnuplot");  // never committed: removed at the end
  const std::string text = fmt::format("set terminal pngcairo size 960,540 noenhanced font 'sans,11'\nset output {}\n{}",
                                       gnuplot_quoted(picture.temporary_path().string()), commands);
  write_file_atomically(script.temporary_path(), std::as_bytes(std::span(text)));
  const int code = run_gnuplot(script.temporary_path());
  if (code == 127) throw Error(path.string(), "drawing it needs the program gnuplot (Debian: apt install gnuplot-nox)");
  if (code != 0 || !fs::exists(picture.temporary_path()))
    throw Error(path.string(), fmt::format("gnuplot failed (exit code {})", code));
  picture.commit();
}

}  // namespace lippmann
