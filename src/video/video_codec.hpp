// Video codecs: the codecs that each file ending allows, and its default.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

namespace lippmann {

enum class VideoCodec { kH264, kHevc, kVp9, kAv1, kFfv1 };

/// In the order of the enum.
inline constexpr std::array<std::string_view, 5> kVideoCodecNames{"h264", "hevc", "vp9", "av1", "ffv1"};

inline std::string_view name_of(VideoCodec codec) { return kVideoCodecNames[static_cast<std::size_t>(codec)]; }

/// Returns `wanted`, or the default of the file ending: FFV1 for .mkv, VP9 for .webm, and for .mp4 and .mov H.264 up to 4096
/// pixels a side and HEVC above. A size of 0 is unknown and counts as small. Throws Error naming the file if the ending is
/// unknown, the container does not support the codec, this build of FFmpeg lacks the codec, or the frames are too large for it
/// (the error lists codecs for this size).
VideoCodec choose_codec(const std::filesystem::path& path, std::optional<VideoCodec> wanted, int width, int height);

/// Constant rate factor: 0 is best. FFV1 has none, because it is lossless.
struct CrfRange {
  int highest = 51, standard = 18;
};
std::optional<CrfRange> crf_range(VideoCodec codec);

}  // namespace lippmann
