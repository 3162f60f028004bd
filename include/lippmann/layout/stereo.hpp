// Stereo pictures: the views of a left and a right eye in one picture, for eye-tracking panels, headsets and 3D players.
//
// The packings are side by side, over-under, and row by row. The `half` packings squeeze each view to half its width or
// height, so that the picture is as large as one view.
//
// Views are off-axis through the display's rectangle, without toe-in. A point at distance d behind the display (z = -d) has the
// disparity ipd d / (distance + d), where ipd is the distance between the eyes and `distance` is their distance from the
// display. The disparity is the point's position on the display for the right eye minus that for the left eye. The disparity is
// 0 in the display plane and negative in front of it.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

enum class StereoPacking { kSideBySide, kHalfSideBySide, kOverUnder, kHalfOverUnder, kRows };

/// in the order of the enum
inline constexpr std::array<std::string_view, 5> kStereoPackingNames{"sbs", "half-sbs", "over-under", "half-over-under",
                                                                     "rows"};

struct StereoLayout {
  StereoPacking packing = StereoPacking::kSideBySide;
  bool right_first = false;  ///< true: the right eye's view is at the left, on top, or in the first row
  bool operator==(const StereoLayout&) const = default;
};

inline constexpr double kDefaultIpdMm = 63.0;  ///< typical distance between an adult's pupils

/// Factor by which a packing reduces a view: (2, 1), (1, 2) or (1, 1).
inline Vec2i stereo_squeeze(StereoPacking packing) {
  return {packing == StereoPacking::kHalfSideBySide ? 2 : 1, packing == StereoPacking::kHalfOverUnder ? 2 : 1};
}

/// Returns the size of the picture that packs two views. `stored` is the size of a squeezed view; for kRows, it is the size of
/// a whole view.
Vec2i stereo_picture_size(StereoPacking packing, Vec2i stored);

/// The inverse of stereo_picture_size(). Throws Error naming `where` if the packing must halve an odd side of the picture.
Vec2i stored_view_size(StereoPacking packing, Vec2i picture, const std::string& where);

/// For writing: returns, for each pixel of the stereo picture, the index of its source pixel in a stack of two views of size
/// `stored`. The left view is above the right view.
std::vector<std::uint32_t> stereo_pixels(const StereoLayout& layout, Vec2i stored);

/// For reading: returns for each pixel of the stack the index of its source in the picture, which holds two views of size
/// `stored`. For kRows, views in the stack have half the height of `stored`, because the picture holds only every second row of
/// each view.
std::vector<std::uint32_t> pixels_of_stereo(const StereoLayout& layout, Vec2i stored);

/// Returns the stereo part of a file name: _2x1 or _half_2x1 (side by side, as in Leia's programs), _ou or _half_ou
/// (over-under, as in headset players), or _rows. If the right eye is first, _rl follows.
std::string stereo_ending(const StereoLayout& layout);

/// Returns the layout that a file name states, or none if the name has no stereo part.
std::optional<StereoLayout> parse_stereo_name(const std::filesystem::path& path);

/// without_stereo_name() removes the stereo part of a file name. with_stereo_name() replaces that part by
/// stereo_ending(layout), or adds stereo_ending(layout) to a name without one.
std::filesystem::path without_stereo_name(const std::filesystem::path& path);
std::filesystem::path with_stereo_name(const std::filesystem::path& path, const StereoLayout& layout);

}  // namespace lippmann
