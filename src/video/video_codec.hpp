// Chooses the video codec for a file ending and a frame size.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>

namespace lippmann {

enum class VideoCodec { kH264, kHevc, kVp9, kAv1, kFfv1 };

inline constexpr std::array<std::string_view, 5> kVideoCodecNames{"h264", "hevc", "vp9", "av1", "ffv1"};

inline std::string_view name_of(VideoCodec codec) { return kVideoCodecNames[static_cast<std::size_t>(codec)]; }

/// Returns `wanted`, or the default codec of the file ending:
///   .mkv        FFV1
///   .webm       VP9
///   .mp4, .mov  H.264 up to 4096 pixels a side or for unknown sizes (0), HEVC for larger frames
/// Throws Error naming the file if the ending is unknown, or if the codec does not suit the container, this build of FFmpeg or
/// the frame size.
VideoCodec choose_codec(const std::filesystem::path& path, std::optional<VideoCodec> wanted, int width, int height);

/// Highest and default constant rate factor (CRF). CRF 0 is the best quality.
struct CrfRange {
  int highest = 51, standard = 18;
};
/// Returns nothing for FFV1, which is lossless.
std::optional<CrfRange> crf_range(VideoCodec codec);

}  // namespace lippmann
