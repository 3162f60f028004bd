#include "layout/strip_interlace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "layout/picture_samples.hpp"
#include "layout/strip_place.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann {
namespace {

struct Blend {
  int at = 0, next = 0;
  float share = 0.0f;
};

/// Selects the views or frames shown at a position in a strip, from 0 at its left end to 1 at its right end.
class StripOrder {
 public:
  StripOrder(int count, const DisplayPictureParams& params) : count_(count), linear_(params.filter == ViewFilter::kLinear) {
    if (!params.flip) return;
    is_flip_ = true, blend_ = params.flip->blend;
    std::vector<double> shares = params.flip->shares;
    if (shares.empty()) shares.assign(static_cast<std::size_t>(count), 1.0);
    if (static_cast<int>(shares.size()) != count)
      throw usage_error("shares", fmt::format("{} shares for {} frames", shares.size(), count), "one share for each frame");
    const double sum = std::accumulate(shares.begin(), shares.end(), 0.0);
    double end = 0.0;
    for (const double share : shares) ends_.push_back(end += share / sum);
    ends_.back() = 1.0;
  }

  Blend at(double place) const {
    if (is_flip_) return frame_at(place);
    if (linear_) return reversed(linear(place * count_ - 0.5));
    const int part = std::min(static_cast<int>(place * count_), count_ - 1);
    return reversed({part, part, 0.0f});
  }

 private:
  Blend reversed(Blend blend) const { return {count_ - 1 - blend.at, count_ - 1 - blend.next, blend.share}; }

  Blend linear(double place) const {
    const double within = std::clamp(place, 0.0, count_ - 1.0);
    const int at = static_cast<int>(within);
    return {at, std::min(at + 1, count_ - 1), static_cast<float>(within - at)};
  }

  double share_of(int frame) const {
    const auto at = static_cast<std::size_t>(frame);
    return ends_[at] - (at > 0 ? ends_[at - 1] : 0.0);
  }

  /// Half width of the transition between `frame` and the next frame, as a share of the strip's width.
  double reach_of(int frame) const { return 0.5 * blend_ * std::min(share_of(frame), share_of(frame + 1)); }

  Blend frame_at(double place) const {
    const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, place);
    const int frame = static_cast<int>(found - ends_.begin());
    const auto mixed = [&](int first) {
      const double reach = reach_of(first), away = place - ends_[static_cast<std::size_t>(first)];
      return Blend{first, first + 1, static_cast<float>(0.5 + 0.5 * away / reach)};
    };
    if (frame > 0 && place - ends_[static_cast<std::size_t>(frame - 1)] < reach_of(frame - 1)) return mixed(frame - 1);
    if (frame + 1 < count_ && ends_[static_cast<std::size_t>(frame)] - place < reach_of(frame)) return mixed(frame);
    return {frame, frame, 0.0f};
  }

  int count_;
  bool linear_, is_flip_ = false;
  double blend_ = 0.0;
  std::vector<double> ends_;  ///< ends of the frames, as shares of the strip's width
};

template <class Sample>
class LightOfSamples {
 public:
  LightOfSamples() {
    if constexpr (!std::is_floating_point_v<Sample>)
      for (std::size_t i = 0; i <= kWhite; ++i)
        light_.push_back(static_cast<float>(linear_from_srgb(static_cast<double>(i) / static_cast<double>(kWhite))));
  }
  float light(Sample sample) const {
    if constexpr (std::is_floating_point_v<Sample>)
      return sample;
    else
      return light_[sample];
  }
  Sample sample(float light) const {
    if constexpr (std::is_floating_point_v<Sample>)
      return light;
    else
      return nearest_sample<Sample>(static_cast<double>(kWhite) * srgb_from_linear(std::clamp(light, 0.0f, 1.0f)));
  }

 private:
  static constexpr std::size_t kWhite = std::is_floating_point_v<Sample> ? 0 : std::numeric_limits<Sample>::max();
  std::vector<float> light_;
};

/// A blend of two views, each of which is a blend of two columns.
struct StripPixel {
  Blend views, columns;
};

template <class Sample>
class StripInterlacer {
 public:
  StripInterlacer(const LightField& field, const Display& sheet, const StripOrder& order, const std::vector<Sample>& views)
      : size_(field.view_size), width_(sheet.pixels.x), strips_(lens_strips(sheet)), order_(order), views_(views) {
    if (is_upright())
      for (int i = 0; i < width_; ++i) columns_.push_back(pixel_at(i, 0));
  }

  void write_row(int j, Sample* out) const {
    for (int i = 0; i < width_; ++i, out += 3)
      write_pixel(is_upright() ? columns_[static_cast<std::size_t>(i)] : pixel_at(i, j), j, out);
  }

 private:
  bool is_upright() const { return strips_.sine == 0.0; }

  StripPixel pixel_at(int i, int j) const {
    const double y = j + 0.5;
    const auto [lens, within] = strip_place(strips_, {i + 0.5, y});
    const Blend views = order_.at(within);
    if (is_upright()) {
      const int column = std::clamp(static_cast<int>(lens), 0, size_.x - 1);
      return {views, {column, column, 0.0f}};
    }
    const double centre = strips_.start_px + (lens + 0.5) * strips_.cell_px;
    const double x = (centre + y * strips_.sine) / strips_.cosine;
    const double place = std::clamp(x / width_ * size_.x - 0.5, 0.0, size_.x - 1.0);
    const int column = static_cast<int>(place);
    return {views, {column, std::min(column + 1, size_.x - 1), static_cast<float>(place - column)}};
  }

  void write_pixel(const StripPixel& pixel, int j, Sample* out) const {
    if (pixel.views.share == 0.0f && pixel.columns.share == 0.0f) {
      std::copy_n(at(pixel.views.at, pixel.columns.at, j), 3, out);
      return;
    }
    for (int c = 0; c < 3; ++c) {
      const float first = in_view(pixel.views.at, pixel.columns, j, c);
      const float second = pixel.views.share == 0.0f ? first : in_view(pixel.views.next, pixel.columns, j, c);
      out[c] = light_.sample(std::lerp(first, second, pixel.views.share));
    }
  }

  float in_view(int view, const Blend& columns, int j, int c) const {
    const float left = light_.light(at(view, columns.at, j)[c]);
    return columns.share == 0.0f ? left : std::lerp(left, light_.light(at(view, columns.next, j)[c]), columns.share);
  }

  const Sample* at(int view, int column, int j) const {
    const std::size_t row = static_cast<std::size_t>(view) * static_cast<std::size_t>(size_.y) + static_cast<std::size_t>(j);
    return views_.data() + 3 * (row * static_cast<std::size_t>(size_.x) + static_cast<std::size_t>(column));
  }

  Vec2i size_;
  int width_;
  LensStrips strips_;
  const StripOrder& order_;
  const std::vector<Sample>& views_;
  LightOfSamples<Sample> light_;
  std::vector<StripPixel> columns_;
};

}  // namespace

Picture interlace_strips(const LightField& field, const Display& sheet, const DisplayPictureParams& params,
                         const ThreadPool& pool) {
  if (params.filter == ViewFilter::kGaussian)
    throw usage_error("filter", "gaussian works for slanted panels only", "nearest or linear");
  const StripOrder order(field.grid.count(), params);
  Picture picture = blank(field.stack, sheet.pixels);
  std::visit(
      [&](auto& to) {
        const auto& from = std::get<std::remove_cvref_t<decltype(to)>>(field.stack);
        using Sample = typename std::remove_cvref_t<decltype(samples_of(to))>::value_type;
        const StripInterlacer<Sample> interlacer(field, sheet, order, samples_of(from));
        const std::size_t row = 3 * static_cast<std::size_t>(sheet.pixels.x);
        pool.for_each(static_cast<std::size_t>(sheet.pixels.y),
                      [&](std::size_t j) { interlacer.write_row(static_cast<int>(j), samples_of(to).data() + j * row); });
      },
      picture);
  return picture;
}

}  // namespace lippmann
