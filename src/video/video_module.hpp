// The interface of the module liblippmann_video.so, which encodes and decodes videos with FFmpeg (src/video/ffmpeg).
//
// FFmpeg links about a hundred shared libraries, which most commands do not need. Therefore the module is loaded only on first
// use. All functions throw Error naming the video file.
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

/// Checked and complete settings of a video encoder.
struct EncoderSettings {
  std::filesystem::path path;  ///< final path of the video, for error messages
  std::string temporary;       ///< path of the temporary file to write
  VideoCodec codec = VideoCodec::kH264;
  const char* muxer = nullptr;          ///< FFmpeg's name of the container
  const char* encoder = nullptr;        ///< FFmpeg's name of the encoder, accepted by has_encoder()
  int width = 0, height = 0;            ///< size of every frame, in pixels
  int crf = 0;                          ///< constant rate factor; ignored by lossless codecs
  int numerator = 25, denominator = 1;  ///< frames per second
  int threads = 1;
  std::optional<StereoLayout> stereo = {};  ///< written as metadata if the container supports it
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
  /// Returns the next frame, or nothing after the last frame.
  virtual std::optional<Image8> next() = 0;
};

class VideoModule {
 public:
  virtual ~VideoModule() = default;
  virtual bool has_encoder(const char* name) const = 0;
  virtual std::unique_ptr<VideoEncoder> encoder(const EncoderSettings& settings) const = 0;
  virtual std::unique_ptr<VideoDecoder> decoder(const std::filesystem::path& path) const = 0;
};

/// Version of this interface. Increment it with every change of this header. Modules of another version are rejected.
inline constexpr int kVideoModuleVersion = 2;

/// Returns the module. Loads it on the first call. Thread-safe. Throws Error if the module or one of its libraries is missing.
const VideoModule& video_module();

}  // namespace lippmann
