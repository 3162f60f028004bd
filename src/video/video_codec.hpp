// Which codecs videos are written in, what each file ending may hold, and which is taken where nobody says.
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

/// The codec that is asked for; else the ending's own: .mkv FFV1, .webm VP9, .mp4 and .mov H.264 up to 4096 pixels a side and
/// HEVC above. A size of 0: not known yet, taken for small.
/// Throws Error naming the file for an unknown ending, a codec that it does not hold, one that this build of FFmpeg lacks, and
/// frames too large for it (the error says which codecs hold them).
VideoCodec choose_codec(const std::filesystem::path& path, std::optional<VideoCodec> wanted, int width, int height);

/// Constant rate factor: 0 is best. None for FFV1, which loses nothing.
struct CrfRange {
  int highest = 51, standard = 18;
};
std::optional<CrfRange> crf_range(VideoCodec codec);

}  // namespace lippmann
