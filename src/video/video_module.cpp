#include "video/video_module.hpp"

#include "core/loaded_module.hpp"
#include "video/video_module_file.hpp"

namespace lippmann {
namespace {

constexpr ModuleName kVideoModule{"liblippmann_video.so", "lippmann_video_module", "videos", "lippmann-video"};

}  // namespace

const VideoModule& video_module() {
  static const auto& loaded = *static_cast<const VideoModule*>(load_module(kVideoModule, kVideoModuleVersion));
  return loaded;
}

bool is_video_module_installed() { return is_module_installed(kVideoModule); }

}  // namespace lippmann
