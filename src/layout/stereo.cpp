#include "lippmann/layout/stereo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "core/text_pattern.hpp"
#include "layout/copy_mark.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 5> kStereoEndings{"_2x1", "_half_2x1", "_ou", "_half_ou", "_rows"};

/// Returns how often the area of a stored view fits into the picture, across and down.
Vec2i views_in_picture(StereoPacking packing) {
  switch (packing) {
    case StereoPacking::kSideBySide:
    case StereoPacking::kHalfSideBySide:
      return {2, 1};
    case StereoPacking::kOverUnder:
    case StereoPacking::kHalfOverUnder:
      return {1, 2};
    case StereoPacking::kRows:
      break;
  }
  return {1, 1};
}

/// The view that a pixel of the picture belongs to. `place`: 0 for the first view, 1 for the second view. `pixel`: position in
/// that view as stored.
struct StereoPlace {
  int place;
  Vec2i pixel;
};

StereoPlace place_of_pixel(StereoPacking packing, Vec2i stored, Vec2i pixel) {
  if (packing == StereoPacking::kRows) return {pixel.y % 2, pixel};
  const Vec2i view = pixel / stored;
  return {view.x + view.y, pixel - view * stored};
}

std::optional<PatternMatch> stereo_name(const fs::path& path) {
  static const TextPattern name("(.*?)(_2x1|_half_2x1|_ou|_half_ou|_rows)(_rl)?(" + std::string(kCopyMark) + ")?",
                                TextPattern::Letters::kEitherCase);
  return name.match(path.stem().string());
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace

Vec2i stereo_picture_size(StereoPacking packing, Vec2i stored) { return stored * views_in_picture(packing); }

Vec2i stored_view_size(StereoPacking packing, Vec2i picture, const std::string& where) {
  const Vec2i parts = packing == StereoPacking::kRows ? Vec2i(1, 2) : views_in_picture(packing);
  if (picture.x < parts.x || picture.y < parts.y || picture % parts != Vec2i(0))
    throw Error(where,
                fmt::format("{}x{} pixels do not hold two views ({})", picture.x, picture.y,
                            kStereoPackingNames[static_cast<std::size_t>(packing)]),
                fmt::format("an even {}", parts.x == 2 ? "width" : "height"));
  return picture / views_in_picture(packing);
}

std::vector<std::uint32_t> stereo_pixels(const StereoLayout& layout, Vec2i stored) {
  const Vec2i size = stereo_picture_size(layout.packing, stored);
  std::vector<std::uint32_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const StereoPlace at = place_of_pixel(layout.packing, stored, {x, y});
      const int eye = layout.right_first ? 1 - at.place : at.place;
      pixels.push_back(static_cast<std::uint32_t>((eye * stored.y + at.pixel.y) * stored.x + at.pixel.x));
    }
  return pixels;
}

std::vector<std::uint32_t> pixels_of_stereo(const StereoLayout& layout, Vec2i stored) {
  const bool rows = layout.packing == StereoPacking::kRows;
  const Vec2i size = stereo_picture_size(layout.packing, stored),
              step = rows ? Vec2i(0, 1) : views_in_picture(layout.packing) - 1;
  std::vector<std::uint32_t> pixels;
  for (int eye = 0; eye < 2; ++eye) {
    const int place = layout.right_first ? 1 - eye : eye;
    const Vec2i corner = place * step * (rows ? Vec2i(1) : stored);
    for (int y = corner.y; y < (rows ? size.y : corner.y + stored.y); y += rows ? 2 : 1)
      for (int x = 0; x < stored.x; ++x) pixels.push_back(static_cast<std::uint32_t>(y * size.x + corner.x + x));
  }
  return pixels;
}

std::string stereo_ending(const StereoLayout& layout) {
  return fmt::format("{}{}", kStereoEndings[static_cast<std::size_t>(layout.packing)], layout.right_first ? "_rl" : "");
}

std::optional<StereoLayout> parse_stereo_name(const fs::path& path) {
  const std::optional<PatternMatch> found = stereo_name(path);
  if (!found) return std::nullopt;
  StereoLayout layout;
  for (std::size_t i = 0; i < kStereoEndings.size(); ++i)
    if (lower_case(found->groups[2]) == kStereoEndings[i]) layout.packing = static_cast<StereoPacking>(i);
  layout.right_first = !found->groups[3].empty();
  return layout;
}

fs::path without_stereo_name(const fs::path& path) {
  const std::optional<PatternMatch> found = stereo_name(path);
  if (!found) return path;
  return path.parent_path() / (found->groups[1] + found->groups[4] + path.extension().string());
}

fs::path with_stereo_name(const fs::path& path, const StereoLayout& layout) {
  const fs::path bare = without_stereo_name(path);
  return bare.parent_path() / (bare.stem().string() + stereo_ending(layout) + bare.extension().string());
}

}  // namespace lippmann
