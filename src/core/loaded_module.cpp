#include "core/loaded_module.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

fs::path own_file() {
  const fs::path file = platform::file_of_code(reinterpret_cast<const void*>(&load_module));
  return file.filename().string().find(".so") != std::string::npos ? file : platform::program_file();
}

/// Returns the paths where a module may be: beside the program or library (in the build tree and in wheels), or installed in
/// lib/lippmann. Packages of Debian's Python are two folders below lib.
std::array<fs::path, 2> places_of(const ModuleName& module) {
  const fs::path folder = own_file().parent_path(), parent = folder.parent_path();
  const bool is_python_package = parent.filename() == "dist-packages";
  const fs::path lib = is_python_package ? parent.parent_path().parent_path() : parent / "lib";
  return {folder / module.file, lib / "lippmann" / module.file};
}

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

}  // namespace

bool is_module_installed(const ModuleName& module) {
  const std::array<fs::path, 2> places = places_of(module);
  return std::any_of(places.begin(), places.end(), is_there);
}

const void* load_module(const ModuleName& module, int version) {
  const std::array<fs::path, 2> places = places_of(module);
  const auto path = std::find_if(places.begin(), places.end(), is_there);
  if (path == places.end())
    throw Error(module.file, fmt::format("{} need this module, and it is not installed", module.purpose),
                fmt::format("{} or {} (package {})", places[0].string(), places[1].string(), module.package));
  const auto failure = [&](const std::string& reason) {
    return Error(path->string(), fmt::format("{} need this module, and it cannot be loaded ({})", module.purpose, reason),
                 "libraries of the version that this module was built with");
  };
  std::string problem;
  void* loaded = platform::load_library(*path, problem);
  if (!loaded) throw failure(problem);
  using Entry = const void*(int version);
  auto* entry = reinterpret_cast<Entry*>(platform::find_symbol(loaded, module.entry));
  const void* found = entry ? entry(version) : nullptr;
  if (!found) throw failure("it belongs to another version of this program");
  return found;
}

}  // namespace lippmann
