// RGB-D pictures: the left half has the colours of one view, the middle one, and the right half has its depth as grey
// (formats/rgbd_side_file.hpp). Pixels without a surface get the farthest depth of the range.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formats/rgbd_name.hpp"
#include "formats/rgbd_picture.hpp"
#include "formats/rgbd_side_file.hpp"
#include "layout/cameras.hpp"
#include "layout/picture_samples.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr double kAssumedHeightMm = 100.0, kAssumedDistanceMm = 300.0;  ///< for views without camera data

template <class Sample>
constexpr double kWhiteCode = std::is_floating_point_v<Sample> ? 1.0 : std::numeric_limits<Sample>::max();

/// Grey values (0 ... 1) in the right half of a picture: the mean of the three channels, which must be about equal.
Image read_greys(const Picture& picture, Vec2i view, const std::string& where) {
  Image greys(view.x, view.y, 1);
  double colour = 0.0;
  std::visit(
      [&](const auto& image) {
        const auto& samples = samples_of(image);
        const double white = kWhiteCode<std::remove_cvref_t<decltype(samples[0])>>;
        for (int y = 0; y < view.y; ++y)
          for (int x = 0; x < view.x; ++x) {
            const auto at = samples.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * 2 * view.x + view.x + x);
            const double r = at[0] / white, g = at[1] / white, b = at[2] / white;
            colour += std::max({r, g, b}) - std::min({r, g, b});
            greys.pixel(x, y)[0] = static_cast<float>((r + g + b) / 3.0);
          }
      },
      picture);
  // Pictures whose channels differ more than this on average are not grey. Lossy compression colours grey pixels slightly.
  constexpr double kMostColour = 0.05;
  if (colour > kMostColour * view.x * view.y)
    throw Error(where, "its right half has colours, so it is not depth", "colours at the left, depth as grey at the right");
  return greys;
}

void require_depth(const Image& greys, const std::string& where) {
  if (std::any_of(greys.data.begin(), greys.data.end(), [](float grey) { return grey > 0.0f; })) return;
  throw Error(where, "its depth is 0 everywhere", "colours at the left, depth as grey at the right");
}

/// Returns the description of an RGB-D picture. Options override the side file, and the side file overrides the defaults.
RgbdSideFile described_rgbd(const fs::path& path, const FormatOptions& options, Vec2i view) {
  RgbdSideFile assumed;
  assumed.distance_mm = kAssumedDistanceMm;
  const int squeeze = has_half_rgbd_name(path) ? 2 : 1;
  assumed.size_mm = {kAssumedHeightMm * view.x * squeeze / view.y, kAssumedHeightMm};
  RgbdSideFile side = read_rgbd_side_file(path).value_or(assumed);
  if (options.depth_range) side.coding.range = *options.depth_range;
  if (options.even_in_depth) side.coding.even_in_depth = *options.even_in_depth;
  if (options.near_black) side.coding.near_black = *options.near_black;
  if (!(side.coding.range.near_mm < side.distance_mm))
    throw usage_error("depth-range",
                      fmt::format("{:g} mm does not lie in front of the eye, which is at {:g} mm", side.coding.range.near_mm,
                                  side.distance_mm),
                      fmt::format("depths below {:g} mm", side.distance_mm));
  return side;
}

LightField read_rgbd(const fs::path& path, const FormatOptions& options) {
  const Picture picture = read_picture(path, options.warn);
  LightField field = light_field_of_rgbd(picture, path, path.string(), options);
  require_depth(read_greys(picture, field.view_size, path.string()), path.string());
  return field;
}

/// The range from the farthest to the nearest surface, slightly extended if all surfaces have one depth.
DepthRange range_of(const Image& depth, double distance_mm) {
  DepthRange range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const float z : depth.data) {
    if (!std::isfinite(z)) continue;
    range.near_mm = std::max(range.near_mm, static_cast<double>(z));
    range.far_mm = std::min(range.far_mm, static_cast<double>(z));
  }
  if (!std::isfinite(range.near_mm)) return {};
  return range_before_eye(range, distance_mm);
}

RgbdSideFile side_of(const LightField& field, int view, const Image& depth, const FormatOptions& options) {
  const ViewCameras& cameras = *field.cameras;
  RgbdSideFile side;
  side.distance_mm = cameras.distance_mm;
  side.size_mm = cameras.pixel_mm * Vec2d(field.view_size);
  // The file has no other origin than the middle of the picture.
  const Vec2d middle_mm = (0.5 * Vec2d(field.view_size) - cameras.centre_px) * Vec2d(1.0, -1.0) * cameras.pixel_mm;
  side.eye_mm = cameras.eyes_mm.at(static_cast<std::size_t>(view)) - middle_mm;
  side.coding.range = options.depth_range.value_or(range_of(depth, cameras.distance_mm));
  side.coding.even_in_depth = options.even_in_depth.value_or(false);
  side.coding.near_black = options.near_black.value_or(false);
  return side;
}

/// Returns a picture with `colours` in the left half and `depth` as grey in the right half.
Picture side_by_side(const Picture& colours, const Image& depth, const RgbdSideFile& side) {
  const Vec2i view = size_of(colours);
  Picture picture = blank(colours, {2 * view.x, view.y});
  std::vector<std::uint32_t> pixels;
  for (int y = 0; y < view.y; ++y)
    for (int x = 0; x < view.x; ++x) pixels.push_back(static_cast<std::uint32_t>(y * 2 * view.x + x));
  move_pixels(colours, {}, picture, pixels);
  std::visit(
      [&](auto& image) {
        auto& samples = samples_of(image);
        using Sample = std::remove_cvref_t<decltype(samples[0])>;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
          const double grey = grey_of_depth(side.coding, side.distance_mm, depth.data[i]) * kWhiteCode<Sample>;
          const Sample code = nearest_sample<Sample>(grey);
          std::fill_n(samples.begin() + 3 * (static_cast<std::ptrdiff_t>(pixels[i]) + view.x), 3, code);
        }
      },
      picture);
  return picture;
}

std::vector<fs::path> write_rgbd(const LightField& field, const fs::path& path, const FormatOptions& options) {
  if (!field.cameras || !(field.depth || field.view_depth))
    throw usage_error("to", field.cameras ? "the views have no depth" : unknown_cameras(field),
                      "a render with `aov` depth, or a format that holds depth");
  const int view = field.depth ? field.grid.rows / 2 * field.grid.columns + field.grid.columns / 2 : field.view_depth->view;
  const Image depth = field.depth ? depth_of(field, view) : field.view_depth->depth;
  const RgbdSideFile side = side_of(field, view, depth, options);
  const fs::path named = with_rgbd_name(path);
  write_picture(named, side_by_side(view_of(field, view), depth, side));
  write_rgbd_side_file(named, side);
  return {named, rgbd_side_path(named)};
}

}  // namespace

LightField light_field_of_rgbd(const Picture& picture, const fs::path& file, const std::string& where,
                               const FormatOptions& options) {
  const Vec2i size = size_of(picture), view(size.x / 2, size.y);
  if (size.x % 2 != 0 || size.x < 2)
    throw Error(where, fmt::format("{} pixels across cannot be divided into colours and depth", size.x),
                "an even width: colours at the left, depth of the same size at the right");
  Picture colours = blank(picture, view);
  std::vector<std::uint32_t> pixels;
  for (int y = 0; y < view.y; ++y)
    for (int x = 0; x < view.x; ++x) pixels.push_back(static_cast<std::uint32_t>(y * size.x + x));
  move_pixels(picture, pixels, colours, {});
  return light_field_of_colours(std::move(colours), read_greys(picture, view, where), file, options);
}

LightField light_field_of_colours(Picture colours, Image greys, const fs::path& file, const FormatOptions& options) {
  const Vec2i view = size_of(colours);
  const RgbdSideFile side = described_rgbd(file, options, view);
  LightField field;
  field.grid = {1, 1}, field.view_size = view, field.aspect = side.size_mm.x / side.size_mm.y;
  field.stack = std::move(colours), field.depth = std::move(greys);
  for (float& z : field.depth->data) z = static_cast<float>(depth_of_grey(side.coding, side.distance_mm, z));
  const Vec2d pixel = side.size_mm / Vec2d(view);
  field.cameras = ViewCameras{side.distance_mm, pixel, 0.5 * Vec2d(view), {side.eye_mm}};
  return field;
}

LightFieldFormat rgbd_format() {
  return {.name = kRgbdFormat,
          .description = "the middle view's colours, with its depth as grey to their right",
          .states_cameras = true,
          .read = read_rgbd,
          .write = write_rgbd,
          .reads = {.depth_coding = true},
          .writes = {.depth_coding = true}};
}

}  // namespace lippmann
