#include "video/video_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr const char* kName = "liblippmann_video.so";

/// Of the program, or of the shared library that this is a part of.
fs::path own_file() {
  std::error_code ignored;
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&video_module), &info) != 0 && info.dli_fname) {
    const fs::path file = fs::canonical(info.dli_fname, ignored);
    if (file.filename().string().starts_with("liblippmann.so")) return file;
  }
  return fs::read_symlink("/proc/self/exe", ignored);
}

/// The only place that knows where the module lies: beside the program or library, as they are built, or in lib/lippmann, as it
/// is installed.
std::array<fs::path, 2> module_places() {
  const fs::path folder = own_file().parent_path();
  return {folder / kName, folder.parent_path() / "lib" / "lippmann" / kName};
}

fs::path module_path() {
  const std::array<fs::path, 2> places = module_places();
  std::error_code ignored;
  for (const fs::path& place : places)
    if (fs::exists(place, ignored)) return place;
  throw Error(kName, "videos need this module, and it is not installed",
              fmt::format("{} or {} (package lippmann-video)", places[0].string(), places[1].string()));
}

/// It stays loaded: libraries below FFmpeg do not survive being unloaded.
const VideoModule& load() {
  const fs::path path = module_path();
  const auto failure = [&](const char* reason) {
    return Error(path.string(), fmt::format("videos need this module, and it cannot be loaded ({})", reason),
                 "FFmpeg's libraries of the version that it was built with");
  };
  void* module = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!module) throw failure(dlerror());
  auto* entry = reinterpret_cast<VideoModuleEntry*>(dlsym(module, "lippmann_video_module"));
  const VideoModule* found = entry ? entry(kVideoModuleVersion) : nullptr;
  if (!found) throw failure("it belongs to another version of this program");
  return *found;
}

}  // namespace

const VideoModule& video_module() {
  static const VideoModule& loaded = load();
  return loaded;
}

}  // namespace lippmann
