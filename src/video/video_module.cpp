#include "video/video_module.hpp"

#include "core/loaded_module.hpp"

namespace lippmann {

const VideoModule& video_module() {
  static const auto& loaded = *static_cast<const VideoModule*>(
      load_module({"liblippmann_video.so", "lippmann_video_module", "videos", "lippmann-video"}, kVideoModuleVersion));
  return loaded;
}

}  // namespace lippmann
