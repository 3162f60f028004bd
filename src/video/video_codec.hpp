// Video codecs: the codecs that each file ending allows, and its default.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

namespace lippmann {

enum class VideoCodec { kH264, kHevc, kVp9, kAv1, kFfv1 };

/// Names of the codecs, in the order of VideoCodec.
inline constexpr std::array<std::string_view, 5> kVideoCodecNames{"h264", "hevc", "vp9", "av1", "ffv1"};

inline std::string_view name_of(VideoCodec codec) { return kVideoCodecNames[static_cast<std::size_t>(codec)]; }

/// Returns `wanted`, or the default of the file ending: FFV1 for .mkv, VP9 for .webm, and for .mp4 and .mov H.264 up to 4096
/// pixels a side and HEVC above. A size of 0 means unknown and counts as at most 4096 pixels a side. Throws Error naming the
/// file if the ending is unknown, the container does not support the codec, this build of FFmpeg lacks the codec, or the frames
/// are too large for it (the error lists codecs for this size).
VideoCodec choose_codec(const std::filesystem::path& path, std::optional<VideoCodec> wanted, int width, int height);

/// The range and default of a codec's constant rate factor; 0 is the best quality. FFV1 is lossless and has none.
struct CrfRange {
  int highest = 51, standard = 18;
};
std::optional<CrfRange> crf_range(VideoCodec codec);

}  // namespace lippmann
