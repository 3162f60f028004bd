// What the part asks of FFmpeg, and the one way to it: a module (liblippmann_video.so) that is loaded when it is first asked.
//
// FFmpeg maps some hundred shared libraries, which most commands do not need. The rest of the program knows this interface
// alone; src/video/ffmpeg implements it. All functions throw Error naming the file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "lippmann/image/image.hpp"
#include "lippmann/layout/stereo.hpp"
#include "video/video_codec.hpp"

namespace lippmann {

/// What a video is to be, checked and complete.
struct EncoderSettings {
  std::filesystem::path path;  ///< that errors name
  std::string temporary;       ///< the file that is written
  VideoCodec codec = VideoCodec::kH264;
  const char* muxer = nullptr;          ///< FFmpeg's names
  const char* encoder = nullptr;        ///< one that has_encoder() knows
  int width = 0, height = 0;            ///< every frame's, pixels
  int crf = 0;                          ///< ignored by codecs that lose nothing
  int numerator = 25, denominator = 1;  ///< frames per second
  int threads = 1;
  std::optional<StereoLayout> stereo = {};  ///< said to players, as far as the container can say it
};

class VideoEncoder {
 public:
  virtual ~VideoEncoder() = default;
  virtual void add_frame(const Image8& frame) = 0;
  /// Completes and closes the file.
  virtual void finish() = 0;
};

class VideoDecoder {
 public:
  virtual ~VideoDecoder() = default;
  /// The next frame; none after the last one.
  virtual std::optional<Image8> next() = 0;
};

class VideoModule {
 public:
  virtual ~VideoModule() = default;
  virtual bool has_encoder(const char* name) const = 0;
  virtual std::unique_ptr<VideoEncoder> encoder(const EncoderSettings& settings) const = 0;
  virtual std::unique_ptr<VideoDecoder> decoder(const std::filesystem::path& path) const = 0;
};

/// To be raised with every change of this header: a module of another version is refused.
inline constexpr int kVideoModuleVersion = 2;

/// Loads the module on the first call; any thread may call it. Throws Error that names the module and what is missing: the
/// module itself or a library that it needs.
const VideoModule& video_module();

}  // namespace lippmann
