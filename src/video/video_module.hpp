// The interface of the module liblippmann_video.so, which encodes and decodes videos with FFmpeg (src/video/ffmpeg). It is
// loaded on first use, because FFmpeg links about a hundred libraries. All functions throw Error naming the video file.
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

struct EncoderSettings {
  std::filesystem::path path;  ///< final path, for error messages
  std::string temporary;
  VideoCodec codec = VideoCodec::kH264;
  const char* muxer = nullptr;
  const char* encoder = nullptr;  ///< FFmpeg's name of the encoder
  int width = 0, height = 0;
  int crf = 0;  ///< constant rate factor; lossless codecs ignore it
  int numerator = 25, denominator = 1;
  int threads = 1;
  std::optional<StereoLayout> stereo = {};  ///< written as metadata if the container supports it
};

class VideoEncoder {
 public:
  virtual ~VideoEncoder() = default;
  virtual void add_frame(const Image8& frame) = 0;
  virtual void finish() = 0;
};

class VideoDecoder {
 public:
  virtual ~VideoDecoder() = default;
  virtual std::optional<Image8> next() = 0;
};

class VideoModule {
 public:
  virtual ~VideoModule() = default;
  virtual bool has_encoder(const char* name) const = 0;
  virtual std::unique_ptr<VideoEncoder> encoder(const EncoderSettings& settings) const = 0;
  virtual std::unique_ptr<VideoDecoder> decoder(const std::filesystem::path& path) const = 0;
};

/// Increment this with every change of this header. Modules of another version are rejected.
inline constexpr int kVideoModuleVersion = 2;

/// Loads the module on the first call. Thread-safe. Throws Error if the module or one of its libraries is missing.
const VideoModule& video_module();

}  // namespace lippmann
