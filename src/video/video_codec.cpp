#include "video/video_codec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "lippmann/core/error.hpp"
#include "video/container.hpp"
#include "video/video_module.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

struct Container {
  std::string_view ending, muxer;
  std::vector<VideoCodec> codecs;
};

const std::vector<Container>& containers() {
  using enum VideoCodec;
  static const std::vector<Container> all{{".mp4", "mp4", {kH264, kHevc, kVp9, kAv1}},
                                          {".mov", "mov", {kH264, kHevc}},
                                          {".webm", "webm", {kVp9, kAv1}},
                                          {".mkv", "matroska", {kFfv1, kH264, kHevc, kVp9, kAv1}}};
  return all;
}

const Container& container_of(const fs::path& path) {
  std::string known;
  for (const Container& container : containers()) {
    if (path.extension() == container.ending) return container;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", container.ending);
  }
  throw Error(path.string(), "has an unknown ending for a video", known);
}

std::string names(const std::vector<VideoCodec>& codecs) {
  std::string text;
  for (const VideoCodec codec : codecs) text += fmt::format("{}{}", text.empty() ? "" : ", ", name_of(codec));
  return text;
}

/// Returns the longest permitted side in pixels. For H.264 and HEVC, this is the limit of hardware decoders (levels 5.2
/// and 6.2). For VP9 and AV1, it is enough for the largest quilts.
int longest_side(VideoCodec codec) {
  switch (codec) {
    case VideoCodec::kH264:
      return 4096;
    case VideoCodec::kHevc:
      return 8192;
    case VideoCodec::kVp9:
    case VideoCodec::kAv1:
      return 16384;
    case VideoCodec::kFfv1:
      break;
  }
  return 65536;
}

void require_size(const fs::path& path, const Container& container, VideoCodec codec, int side) {
  if (side <= longest_side(codec)) return;
  std::vector<VideoCodec> larger;
  for (const VideoCodec other : container.codecs)
    if (side <= longest_side(other)) larger.push_back(other);
  throw Error(
      path.string(),
      fmt::format("{} holds frames of up to {} pixels a side, and these have {}", name_of(codec), longest_side(codec), side),
      larger.empty() ? "smaller frames" : "smaller frames, or `codec` (render: `video-codec`) " + names(larger));
}

}  // namespace

const char* encoder_name(VideoCodec codec) {
  switch (codec) {
    case VideoCodec::kH264:
      return "libx264";
    case VideoCodec::kHevc:
      return "libx265";
    case VideoCodec::kVp9:
      return "libvpx-vp9";
    case VideoCodec::kAv1:
      return "libaom-av1";
    case VideoCodec::kFfv1:
      break;
  }
  return "ffv1";
}

const char* muxer_name(const fs::path& path) { return container_of(path).muxer.data(); }

VideoCodec choose_codec(const fs::path& path, std::optional<VideoCodec> wanted, int width, int height) {
  const Container& container = container_of(path);
  const auto held = [&](VideoCodec codec) {
    return std::find(container.codecs.begin(), container.codecs.end(), codec) != container.codecs.end();
  };
  if (wanted && !held(*wanted))
    throw Error(path.string(), fmt::format("{} files cannot contain {}", container.ending, name_of(*wanted)),
                names(container.codecs));
  const int side = std::max(width, height);
  VideoCodec codec = wanted.value_or(container.codecs.front());
  if (!wanted && codec == VideoCodec::kH264 && side > longest_side(codec)) codec = VideoCodec::kHevc;
  require_size(path, container, codec, side);
  if (!video_module().has_encoder(encoder_name(codec)))
    throw Error(path.string(), fmt::format("this build of FFmpeg has no encoder {} ({} is only in builds under the GPL)",
                                           encoder_name(codec), "libx264, like libx265,"));
  return codec;
}

std::optional<CrfRange> crf_range(VideoCodec codec) {
  switch (codec) {
    case VideoCodec::kH264:
      return CrfRange{51, 18};
    case VideoCodec::kHevc:
      return CrfRange{51, 20};
    case VideoCodec::kVp9:
    case VideoCodec::kAv1:
      return CrfRange{63, 24};
    case VideoCodec::kFfv1:
      break;
  }
  return std::nullopt;
}

}  // namespace lippmann
