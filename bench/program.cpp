#include "bench/program.hpp"

#include <system_error>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::bench {

double cpu_seconds_of(const std::vector<std::string>& program, const std::filesystem::path& folder) {
  std::error_code problem;
  platform::ChildProcess child({.words = program, .folder = folder, .is_silent = true}, problem);
  const int code = problem ? 127 : child.wait();
  if (code >= 127)
    throw Error(program[0], "the program is not installed or was ended", "Debian has it in the package tachyon-bin-nox");
  if (code != 0) throw Error(program[0], "it failed with exit code " + std::to_string(code));
  return child.cpu_seconds();
}

}  // namespace lippmann::bench
