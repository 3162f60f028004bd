#include "lippmann/replay/refocus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"
#include "optics/ray_generator.hpp"

namespace lippmann {
namespace {

constexpr int kBandRows = 16;

/// The points where the rays of the panel's pixels meet the plane of focus, in pixels of the refocused image.
struct Arrivals {
  int width, height;
  std::vector<float> x, y;
  std::vector<float> lowest_y, highest_y;

  Arrivals(int w, int h)
      : width(w),
        height(h),
        x(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)),
        y(x.size()),
        lowest_y(static_cast<std::size_t>(h)),
        highest_y(static_cast<std::size_t>(h)) {}
};

class RayRow {
 public:
  explicit RayRow(int width) : px_(n(width)), py_(n(width)) {
    for (std::vector<float>& v : v_) v.resize(n(width));
    for (std::size_t i = 0; i < px_.size(); ++i) px_[i] = static_cast<float>(i) + 0.5f;
  }
  void trace(const RayGenerator& generator, int row) {
    std::fill(py_.begin(), py_.end(), static_cast<float>(row) + 0.5f);
    generator.rays(px_.data(), py_.data(), static_cast<int>(px_.size()),
                   {v_[0].data(), v_[1].data(), v_[2].data(), v_[3].data(), v_[4].data(), v_[5].data()});
  }
  Vec3d origin(std::size_t i) const { return {v_[0][i], v_[1][i], v_[2][i]}; }
  Vec3d direction(std::size_t i) const { return {v_[3][i], v_[4][i], v_[5][i]}; }

 private:
  static std::size_t n(int width) { return static_cast<std::size_t>(width); }
  std::vector<float> px_, py_, v_[6];
};

Arrivals find_arrivals(const Optics& optics, double z, Vec2i size, const ThreadPool& pool, const Context& context) {
  const RayGenerator generator(optics);
  const Viewer viewer = design_viewer(optics);
  const Window window = display_window(optics);
  Arrivals arrivals(film_size(optics).x, film_size(optics).y);
  pool.for_each(static_cast<std::size_t>(arrivals.height), [&](std::size_t row) {
    if (context.cancelled) return;
    RayRow rays(arrivals.width);
    rays.trace(generator, static_cast<int>(row));
    float lowest = kInfinity, highest = -kInfinity;
    for (std::size_t i = 0; i < static_cast<std::size_t>(arrivals.width); ++i) {
      const Vec3d origin = rays.origin(i), direction = rays.direction(i);
      const Vec2d slope = Vec2d(direction) / direction.z, crossing = Vec2d(origin) - slope * origin.z;
      const Vec2d s = (crossing + (slope - viewer.slope_at_centre) * z) / (1.0 - viewer.vergence * z);
      const Vec2f at(window.pixel_at(s, size));
      const std::size_t pixel = row * static_cast<std::size_t>(arrivals.width) + i;
      arrivals.x[pixel] = at.x, arrivals.y[pixel] = at.y;
      lowest = std::min(lowest, at.y), highest = std::max(highest, at.y);
    }
    arrivals.lowest_y[row] = lowest, arrivals.highest_y[row] = highest;
  });
  return arrivals;
}

struct TentSum {
  Image& picture;
  Vec2f half_width;     ///< half the width of the tent, in pixels
  Image* disagreement;  ///< receives the variance of the colours in each pixel; may be null
};

class Band {
 public:
  Band(const TentSum& sum, int first, int end)
      : picture_(sum.picture),
        first_(first),
        end_(end),
        half_(sum.half_width),
        squares_(sum.disagreement),
        weights_(static_cast<std::size_t>(picture_.width) * static_cast<std::size_t>(end - first)) {}

  bool is_reached(float lowest_y, float highest_y) const {
    return highest_y - 0.5f + half_.y > static_cast<float>(first_) && lowest_y - 0.5f - half_.y < static_cast<float>(end_ - 1);
  }

  template <class Color>
  void add(float x, float y, const Color& color) {
    const float color_square = color[0] * color[0] + color[1] * color[1] + color[2] * color[2];
    const float u = x - 0.5f, v = y - 0.5f;
    const int left = std::max(0, ceil_of(u - half_.x)), right = std::min(picture_.width - 1, floor_of(u + half_.x));
    const int top = std::max(first_, ceil_of(v - half_.y)), bottom = std::min(end_ - 1, floor_of(v + half_.y));
    for (int j = top; j <= bottom; ++j) {
      const float row_weight = 1.0f - std::abs(static_cast<float>(j) - v) / half_.y;
      float* pixel = picture_.pixel(left, j);
      float* sum = &weights_[static_cast<std::size_t>(j - first_) * static_cast<std::size_t>(picture_.width)];
      float* square = squares_ ? squares_->pixel(left, j) : nullptr;
      for (int i = left; i <= right; ++i, pixel += 3) {
        const float weight = row_weight * (1.0f - std::abs(static_cast<float>(i) - u) / half_.x);
        for (int c = 0; c < 3; ++c) pixel[c] += weight * color[c];
        sum[i] += weight;
        if (square) *square++ += weight * color_square;
      }
    }
  }

  void divide_by_weights() {
    constexpr float kMin = 1e-4f;  ///< smaller sums of weights are rounding errors
    float* pixel = picture_.pixel(0, first_);
    float* square = squares_ ? squares_->pixel(0, first_) : nullptr;
    for (const float weight : weights_) {
      float of_mean = 0.0f;
      for (int c = 0; c < 3; ++c, ++pixel) {
        *pixel = weight > kMin ? *pixel / weight : 0.0f;
        of_mean += *pixel * *pixel;
      }
      if (!square) continue;
      *square = weight > kMin ? std::max(0.0f, *square / weight - of_mean) : kInfinity;
      ++square;
    }
  }

 private:
  static int floor_of(float v) { return static_cast<int>(std::floor(std::clamp(v, -1e6f, 1e6f))); }
  static int ceil_of(float v) { return static_cast<int>(std::ceil(std::clamp(v, -1e6f, 1e6f))); }

  Image& picture_;
  int first_, end_;
  Vec2f half_;
  Image* squares_;  ///< sums of squared colours, later the variances; may be null
  std::vector<float> weights_;
};

/// Adds the colours of the pixels first_x, first_x + step, ... of every panel row to the image, and then divides the sums by
/// the sums of weights. color(x, y) returns a pixel's colour, indexed by channel. Stops after a row if `context` is cancelled.
template <class ColorOf>
void sum_rays(const Arrivals& arrivals, int first_x, int step, const ColorOf& color, const ThreadPool& pool,
              const Context& context, const TentSum& sum) {
  const int height = sum.picture.height, bands = (height + kBandRows - 1) / kBandRows;
  pool.for_each(static_cast<std::size_t>(bands), [&](std::size_t index) {
    const int first = static_cast<int>(index) * kBandRows;
    Band band(sum, first, std::min(first + kBandRows, height));
    for (int row = 0; row < arrivals.height; ++row) {
      if (context.cancelled) return;
      const auto r = static_cast<std::size_t>(row), begin = r * static_cast<std::size_t>(arrivals.width);
      if (!band.is_reached(arrivals.lowest_y[r], arrivals.highest_y[r])) continue;
      for (int x = first_x; x < arrivals.width; x += step) {
        const std::size_t at = begin + static_cast<std::size_t>(x);
        band.add(arrivals.x[at], arrivals.y[at], color(x, row));
      }
    }
    band.divide_by_weights();
  });
}

}  // namespace

void validate_depth(const Optics& optics, double z_mm, const char* flag) {
  const Viewer viewer = design_viewer(optics);
  const Vec2i lenses = lens_grid(optics);
  if (lenses.x < 2 || (parallax_of(optics).along && lenses.y < 2))
    throw usage_error(flag, "a single lens or view has no parallax, so there is no depth to focus on",
                      "pictures of several lenses, or of several views");
  if (!(std::abs(z_mm) <= 1e9)) throw usage_error(flag, fmt::format("{} mm is out of range", z_mm), "-1e9 to 1e9");
  const double share = 1.0 - z_mm * viewer.vergence;  // distance of the plane from the viewer, divided by that of the panel
  constexpr double kLeastShare = 1e-4;                // rays in single precision are exact to 1e-7 of the panel's distance
  if (share >= kLeastShare) return;
  throw usage_error(flag,
                    fmt::format("a plane at z = {:.9g} mm is {} the viewer, at z = {:.9g} mm", z_mm,
                                share > 0.0 ? "too near" : "not in front of", 1.0 / viewer.vergence),
                    fmt::format("depths below {:.9g} mm", (1.0 - kLeastShare) / viewer.vergence));
}

Image refocus(const RenderedPanel& rendered, double z_mm, Vec2i size, const ThreadPool& pool, Image* disagreement,
              const Context& context) {
  const Optics& optics = rendered.optics;
  validate(rendered);
  if (size != Vec2i(0) && !(size.x > 0 && size.y > 0))
    throw usage_error("size", fmt::format("is {}x{}", size.x, size.y), "two numbers of pixels, or 0x0 for the natural size");
  if (size == Vec2i(0)) size = natural_view_size(optics);
  const Arrivals arrivals = find_arrivals(optics, z_mm, size, pool, context);
  const Vec2d pixel_mm = display_window(optics).size / Vec2d(size);
  const Vec2f half_width(glm::max(sample_spacing_mm(optics) / pixel_mm, Vec2d(1.0)));
  if (disagreement) *disagreement = Image(size.x, size.y, 1);
  if (sub_pixels_per_pixel(optics) == 1) {
    Image picture(size.x, size.y, 3);
    const auto color = [&](int x, int y) { return rendered.picture.pixel(x, y); };
    sum_rays(arrivals, 0, 1, color, pool, context, {picture, half_width, disagreement});
    return picture;
  }
  Image picture(size.x, size.y, 3), of_one_color, differences;
  for (int c = 0; c < 3; ++c) {
    of_one_color = Image(size.x, size.y, 3);
    if (disagreement) differences = Image(size.x, size.y, 1);
    const auto color = [&](int x, int y) { return std::array<float, 3>{rendered.picture.pixel(x / 3, y)[c], 0.0f, 0.0f}; };
    sum_rays(arrivals, c, 3, color, pool, context, {of_one_color, half_width, disagreement ? &differences : nullptr});
    for (std::size_t i = 0; i < differences.data.size(); ++i) disagreement->data[i] += differences.data[i];
    for (std::size_t i = 0; i < picture.data.size(); i += 3)
      picture.data[i + static_cast<std::size_t>(c)] = of_one_color.data[i];
  }
  return picture;
}

}  // namespace lippmann
