// Defines the module's only exported function.
#include "video/ffmpeg/decoder.hpp"
#include "video/ffmpeg/encoder.hpp"
#include "video/ffmpeg/ffmpeg.hpp"

namespace lippmann {
namespace {

class FfmpegModule : public VideoModule {
 public:
  bool has_encoder(const char* name) const override { return avcodec_find_encoder_by_name(name) != nullptr; }
  std::unique_ptr<VideoEncoder> encoder(const EncoderSettings& settings) const override { return make_encoder(settings); }
  std::unique_ptr<VideoDecoder> decoder(const std::filesystem::path& path) const override { return make_decoder(path); }
};

}  // namespace
}  // namespace lippmann

extern "C" __attribute__((visibility("default"))) const void* lippmann_video_module(int version) {
  static const lippmann::FfmpegModule module;
  return version == lippmann::kVideoModuleVersion ? &module : nullptr;
}
