// Stereo pictures: the views of a left and a right eye in one picture, as panels that track eyes, headsets and 3D players take
// it.
//
// The packings: side by side, one above the other, or row by row; `half` ones are as large as one view, and squeeze each to
// half its width or height. A view is off-axis through the display's rectangle, never turned towards the other (no toe-in): a
// point at depth z behind the display (d behind it: d = -z) has the disparity ipd d / (distance + d) on it, right eye minus
// left eye; 0 in its plane, negative in front.
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

/// In the order of the enum.
inline constexpr std::array<std::string_view, 5> kStereoPackingNames{"sbs", "half-sbs", "over-under", "half-over-under",
                                                                     "rows"};

struct StereoLayout {
  StereoPacking packing = StereoPacking::kSideBySide;
  bool right_first = false;  ///< the right eye's view at the left, on top, or in the first row
  bool operator==(const StereoLayout&) const = default;
};

inline constexpr double kUsualIpdMm = 63.0;  ///< between the pupils of an adult, about

/// What a whole view is divided by, across and down, before it goes into the picture: (2, 1), (1, 2) or (1, 1).
inline Vec2i stereo_squeeze(StereoPacking packing) {
  return {packing == StereoPacking::kHalfSideBySide ? 2 : 1, packing == StereoPacking::kHalfOverUnder ? 2 : 1};
}

/// The size of the picture. `stored`: that of a view as it lies in the picture, squeezed; for rows that of a whole view, of
/// which every other row is taken.
Vec2i stereo_picture_size(StereoPacking packing, Vec2i stored);

/// The inverse. Throws Error naming `where` for sides that cannot be halved.
Vec2i stored_view_size(StereoPacking packing, Vec2i picture, const std::string& where);

/// Writing: entry i is the pixel of a stack of the left view and below it the right view, each of the size `stored`, that pixel
/// i of the picture shows.
std::vector<std::uint32_t> stereo_pixels(const StereoLayout& layout, Vec2i stored);

/// Reading: entry i is the pixel of a picture of two views `stored` that pixel i of a stack of the views shows. A view that is
/// read has the size `stored`, but for rows half its height: those rows that are there.
std::vector<std::uint32_t> pixels_of_stereo(const StereoLayout& layout, Vec2i stored);

/// What stands at the end of a picture's or video's name: _2x1 and _half_2x1 (side by side, as Leia's programs name them), _ou
/// and _half_ou (over and under, as headsets' players do), _rows; and _rl after it where the right eye is first.
std::string stereo_ending(const StereoLayout& layout);

/// The inverse, of a whole path; none if its name says nothing.
std::optional<StereoLayout> parse_stereo_name(const std::filesystem::path& path);

/// The path without that in its name, and with that of another layout in its place.
std::filesystem::path without_stereo_name(const std::filesystem::path& path);
std::filesystem::path with_stereo_name(const std::filesystem::path& path, const StereoLayout& layout);

}  // namespace lippmann
