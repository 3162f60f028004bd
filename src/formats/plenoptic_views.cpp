#include "formats/plenoptic_views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/plenoptic_cameras.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr int kLobes = 3;
constexpr float kLeastWhite = 0.05f;

double lanczos_weight(double x) {
  if (std::abs(x) < 1e-9) return 1.0;
  if (std::abs(x) >= kLobes) return 0.0;
  const double t = std::numbers::pi * x;
  return kLobes * std::sin(t) * std::sin(t / kLobes) / (t * t);
}

/// The weights of the samples around a position, which sum to 1.
struct SampleTaps {
  int first = 0, count = 0;
  std::array<double, std::size_t{2} * kLobes> weight{};
};

SampleTaps sample_taps(double at, bool lanczos) {
  SampleTaps taps;
  const int reach = lanczos ? kLobes : 1;
  taps.first = static_cast<int>(std::floor(at)) - reach + 1;
  taps.count = 2 * reach;
  double sum = 0.0;
  for (int k = 0; k < taps.count; ++k) {
    const double distance = at - (taps.first + k);
    double& weight = taps.weight[static_cast<std::size_t>(k)];
    weight = lanczos ? lanczos_weight(distance) : std::max(0.0, 1.0 - std::abs(distance));
    sum += weight;
  }
  for (double& weight : taps.weight) weight /= sum;
  return taps;
}

/// Interpolates the light at `place`. Edge pixels are repeated beyond the edges.
Vec3f sample_light(const Image& light, Vec2d place, bool lanczos) {
  const SampleTaps across = sample_taps(place.x - 0.5, lanczos), down = sample_taps(place.y - 0.5, lanczos);
  Vec3f sum(0.0f);
  for (int j = 0; j < down.count; ++j) {
    Vec3f row(0.0f);
    const int y = std::clamp(down.first + j, 0, light.height - 1);
    for (int i = 0; i < across.count; ++i) {
      const float* pixel = light.pixel(std::clamp(across.first + i, 0, light.width - 1), y);
      row += static_cast<float>(across.weight[static_cast<std::size_t>(i)]) * Vec3f(pixel[0], pixel[1], pixel[2]);
    }
    sum += static_cast<float>(down.weight[static_cast<std::size_t>(j)]) * row;
  }
  return sum;
}

/// A range of columns and rows of lenses, both ends included.
struct SampledRange {
  int left, right, top, bottom;
  int columns() const { return right - left + 1; }
  int rows() const { return bottom - top + 1; }
};

/// Finds the largest rectangle of lenses whose samples lie in the picture. Samples are up to `reach` pixels from a lens's
/// centre.
class SampledRangeSearch {
 public:
  SampledRangeSearch(const LensGrid& grid, Vec2d size, Vec2d reach) : grid_(grid), size_(size) {
    constexpr double kSlackPx = 0.25;  // a tolerance for errors of an estimated offset
    const double c = std::abs(std::cos(grid.rotation)), s = std::abs(std::sin(grid.rotation));
    margin_ = Vec2d(c * reach.x + s * reach.y, s * reach.x + c * reach.y) + 0.5 - kSlackPx;
  }

  /// Starts with all lenses. As long as lenses at the four sides lie outside of the picture, removes the row or column at the
  /// side with the largest share of such lenses.
  SampledRange find() const {
    SampledRange range = all();
    while (range.columns() > 0 && range.rows() > 0) {
      const std::array<double, 4> outside{share_outside({range.left, range.top}, {range.left, range.bottom}),
                                          share_outside({range.right, range.top}, {range.right, range.bottom}),
                                          share_outside({range.left, range.top}, {range.right, range.top}),
                                          share_outside({range.left, range.bottom}, {range.right, range.bottom})};
      const auto worst = std::max_element(outside.begin(), outside.end()) - outside.begin();
      if (outside[static_cast<std::size_t>(worst)] == 0.0) break;
      if (worst == 0) ++range.left;
      if (worst == 1) --range.right;
      if (worst == 2) ++range.top;
      if (worst == 3) --range.bottom;
    }
    return range;
  }

 private:
  SampledRange all() const {
    SampledRange range{1 << 28, -(1 << 28), 1 << 28, -(1 << 28)};
    const double c = std::cos(grid_.rotation), s = std::sin(grid_.rotation);
    for (const Vec2d corner : {Vec2d(0.0), Vec2d(size_.x, 0.0), Vec2d(0.0, size_.y), size_}) {
      const Vec2d from = corner - grid_.offset_px;
      const double column = (c * from.x + s * from.y) / grid_.pitch_px, row = (c * from.y - s * from.x) / grid_.row_pitch_px;
      range.left = std::min(range.left, static_cast<int>(std::floor(column)) - 1);
      range.right = std::max(range.right, static_cast<int>(std::ceil(column)));
      range.top = std::min(range.top, static_cast<int>(std::floor(row)));
      range.bottom = std::max(range.bottom, static_cast<int>(std::ceil(row)));
    }
    return range;
  }

  /// Share of the lenses in a row or column whose samples lie outside of the picture.
  double share_outside(Vec2i first, Vec2i last) const {
    int outside = 0, count = 0;
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i, ++count) {
        const Vec2d centre = lens_centre(grid_, i, j);
        outside += glm::any(glm::lessThan(centre, margin_)) || glm::any(glm::greaterThan(centre, size_ - margin_));
      }
    return static_cast<double>(outside) / count;
  }

  const LensGrid& grid_;
  Vec2d size_, margin_;
};

/// Samples views: one sample per lens. Rows of hexagonal grids are then resampled to square pixels.
class ViewSampler {
 public:
  ViewSampler(const Image& light, const LensGrid& grid, const SampledRange& range, bool lanczos)
      : light_(light),
        grid_(grid),
        range_(range),
        lanczos_(lanczos),
        right_(grid.pitch_px * Vec2d(std::cos(grid.rotation), std::sin(grid.rotation))),
        down_(grid.row_pitch_px * Vec2d(-std::sin(grid.rotation), std::cos(grid.rotation))) {}

  Vec2i size() const {
    if (grid_.arrangement == LensArrangement::kSquare) return {range_.columns(), range_.rows()};
    // Use the width that all rows cover: from the first lens of the shifted rows to the last lens of the unshifted rows.
    const double span_px = (range_.columns() - 1.5) * grid_.pitch_px;
    return {static_cast<int>(std::floor(span_px / grid_.row_pitch_px + 1e-9)) + 1, range_.rows()};
  }

  /// Returns which lenses the pixels of a view sample. The rows of the grid must be level.
  SampledLenses lenses() const {
    const bool is_square = grid_.arrangement == LensArrangement::kSquare;
    const Vec2d pitch_px(grid_.pitch_px, grid_.row_pitch_px);
    return {grid_.offset_px + pitch_px * Vec2d(range_.left + (is_square ? 0.0 : 0.5), range_.top),
            {is_square ? grid_.pitch_px : grid_.row_pitch_px, grid_.row_pitch_px}};
  }

  /// Samples a view. `offset_px`: offset from the centre of each lens, along the axes of the grid.
  Image view(Vec2d offset_px) const {
    const Vec2d from = grid_.offset_px + right_ * (offset_px.x / grid_.pitch_px) + down_ * (offset_px.y / grid_.row_pitch_px);
    const Vec2i extent = size();
    Image made(extent.x, extent.y, 3);
    std::vector<Vec3f> row(static_cast<std::size_t>(range_.columns()));
    for (int j = 0; j < extent.y; ++j) {
      const double first = range_.left + shift_of(range_.top + j);
      const Vec2d left = from + right_ * first + down_ * static_cast<double>(range_.top + j);
      for (int i = 0; i < range_.columns(); ++i)
        row[static_cast<std::size_t>(i)] = sample_light(light_, left + right_ * static_cast<double>(i), lanczos_);
      for (int i = 0; i < extent.x; ++i) {
        const Vec3f color = grid_.arrangement == LensArrangement::kSquare ? row[static_cast<std::size_t>(i)]
                                                                          : in_row(row, place_in_row(i, range_.top + j));
        for (const int channel : {0, 1, 2}) made.pixel(i, j)[channel] = std::max(0.0f, color[channel]);
      }
    }
    return made;
  }

  /// Like view(), but takes the nearest pixel of `image`, which has one channel, instead of interpolating.
  Image nearest(const Image& image, Vec2d offset_px) const {
    const Vec2i extent = size(), last(image.width - 1, image.height - 1);
    Image made(extent.x, extent.y, 1);
    for (int j = 0; j < extent.y; ++j)
      for (int i = 0; i < extent.x; ++i) {
        const int row = range_.top + j;
        const bool is_square = grid_.arrangement == LensArrangement::kSquare;
        const int column = range_.left + (is_square ? i : static_cast<int>(std::lround(place_in_row(i, row))));
        const Vec2i at = glm::clamp(Vec2i(glm::floor(lens_centre(grid_, column, row) + offset_px)), Vec2i(0), last);
        *made.pixel(i, j) = *image.pixel(at.x, at.y);
      }
    return made;
  }

 private:
  /// Converts a pixel of a view's row to a position, in lenses, in that row. Pixels are square, as wide as the row pitch.
  double place_in_row(int pixel, int row) const {
    const double from_left = 0.5 + pixel * grid_.row_pitch_px / grid_.pitch_px;
    return from_left - shift_of(row);
  }

  double shift_of(int row) const { return grid_.arrangement == LensArrangement::kHexagonal && row % 2 != 0 ? 0.5 : 0.0; }

  Vec3f in_row(const std::vector<Vec3f>& row, double place) const {
    const SampleTaps taps = sample_taps(place, lanczos_);
    Vec3f sum(0.0f);
    for (int k = 0; k < taps.count; ++k) {
      const int lens = std::clamp(taps.first + k, 0, static_cast<int>(row.size()) - 1);
      sum += static_cast<float>(taps.weight[static_cast<std::size_t>(k)]) * row[static_cast<std::size_t>(lens)];
    }
    return sum;
  }

  const Image& light_;
  const LensGrid& grid_;
  const SampledRange& range_;
  bool lanczos_;
  Vec2d right_, down_;  // vectors in pixels, from a lens to the next lens of its row, and from a row to the next row
};

Image swap_axes(const Image& image) {
  Image swapped(image.height, image.width, image.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) std::copy_n(image.pixel(x, y), image.channels, swapped.pixel(y, x));
  return swapped;
}

/// Sets the cameras and, if `z_mm` is not null, the depth.
void add_cameras(const Optics& optics, const ViewSampler& sampler, const std::vector<Vec2d>& offsets, const Image* z_mm,
                 LightField& field) {
  double lens_mm = 0.0;  // z of the plane that field.cameras are relative to, in the display frame
  if (!sensor_lenses(optics)) {
    field.cameras = microlens_cameras(optics, sampler.lenses(), offsets);
    if (field.cameras) lens_mm = field.cameras->distance_mm;
  } else {
    std::vector<PosedCamera> cameras = plenoptic_cameras(optics, sampler.lenses(), field.view_size, offsets);
    lens_mm = cameras.front().position_mm.z;
    field.cameras = shared_plane(cameras);
    if (!field.cameras) field.poses = std::move(cameras);
  }
  if (!z_mm || !(field.cameras || field.poses)) return;
  field.depth = Image(field.view_size.x, field.view_size.y * field.grid.count(), 1);
  const auto moved = static_cast<float>((field.cameras ? field.cameras->distance_mm : 0.0) - lens_mm);
  for (int view = 0; view < field.grid.count(); ++view) {
    Image depth = sampler.nearest(*z_mm, offsets[static_cast<std::size_t>(view)]);
    for (float& z : depth.data) z += moved;
    set_depth(field, view, depth);
  }
}

void check_views(const ViewGrid& views, const LensGrid& grid, const std::string& where) {
  const int most = static_cast<int>(std::ceil(std::max(grid.pitch_px, grid.row_pitch_px)));
  if (views.columns > most || views.rows > most)
    throw usage_error(
        "views",
        fmt::format("{} has lenses of {:.5g} pixels, too few for {}x{} views", where, grid.pitch_px, views.columns, views.rows),
        fmt::format("up to {}x{}", most, most));
}

}  // namespace

Image white_shares(const Image& light) {
  Image grey(light.width, light.height, 1);
  for (std::size_t i = 0; i < grey.data.size(); ++i)
    grey.data[i] = (light.data[3 * i] + light.data[3 * i + 1] + light.data[3 * i + 2]) / 3.0f;
  std::vector<float> sorted = grey.data;
  const auto bright = sorted.begin() + static_cast<std::ptrdiff_t>(0.995 * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), bright, sorted.end());
  if (*bright > 0.0f)
    for (float& value : grey.data) value /= *bright;
  return grey;
}

void divide_by_white(Image& light, const Image& white, const std::string& where) {
  if (light.width != white.width || light.height != white.height)
    throw Error(
        where,
        fmt::format("has {}x{} pixels, but the white picture has {}x{}", light.width, light.height, white.width, white.height),
        "pictures of the same camera");
  for (std::size_t i = 0; i < white.data.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) light.data[3 * i + c] /= std::max(white.data[i], kLeastWhite);
}

ViewGrid default_plenoptic_views(const LensGrid& grid) {
  const int across = std::max(1, static_cast<int>(std::floor(grid.pitch_px + 1e-6)));
  if (grid.arrangement != LensArrangement::kSquare) return {across, across};
  return {across, std::max(1, static_cast<int>(std::floor(grid.row_pitch_px + 1e-6)))};
}

LightField plenoptic_views(const Image& light, const PlenopticCalibration& calibration, ViewGrid views, const Picture& like,
                           const std::string& where, const Image* z_mm) {
  const bool swaps = calibration.grid->arrangement == LensArrangement::kHexagonalColumns;
  const LensGrid grid = swaps ? transposed(*calibration.grid) : *calibration.grid;
  check_views(views, grid, where);
  const Image swapped = swaps ? swap_axes(light) : Image();
  const Image& picture = swaps ? swapped : light;
  const Vec2d reach(0.5 * (views.columns - 1), 0.5 * (views.rows - 1));
  const SampledRange range =
      SampledRangeSearch(grid, {picture.width, picture.height}, swaps ? Vec2d(reach.y, reach.x) : reach).find();
  if (range.columns() < 2 || range.rows() < 2)
    throw Error(
        where,
        fmt::format("has fewer than 2x2 lenses of {:.5g} pixels in {}x{} pixels", grid.pitch_px, light.width, light.height),
        "the lens pitch and the offset of this picture");
  const ViewSampler sampler(picture, grid, range, calibration.lanczos);
  LightField field;
  field.grid = views;
  field.view_size = swaps ? Vec2i(sampler.size().y, sampler.size().x) : sampler.size();
  const double pixel_width = grid.arrangement == LensArrangement::kSquare ? grid.pitch_px : grid.row_pitch_px;
  field.aspect = swaps ? static_cast<double>(field.view_size.x) / field.view_size.y
                       : field.view_size.x * pixel_width / (field.view_size.y * grid.row_pitch_px);
  field.stack = blank(like, stack_size(field));
  const double sign = calibration.inverted ? -1.0 : 1.0;
  std::vector<Vec2d> offsets;
  for (int view = 0; view < views.count(); ++view) {
    const Vec2d right_down(view % views.columns - reach.x, reach.y - view / views.columns);
    const Vec2d offset = sign * (swaps ? Vec2d(right_down.y, right_down.x) : right_down);
    Image made = sampler.view(offset);
    if (swaps) made = swap_axes(made);
    set_view(field, view, with_samples_like(like, std::move(made)));
    offsets.push_back(offset);
  }
  if (calibration.optics && !swaps && grid.rotation == 0.0 &&
      film_size(*calibration.optics) == Vec2i(light.width, light.height))
    add_cameras(*calibration.optics, sampler, offsets, z_mm, field);
  return field;
}

}  // namespace lippmann
