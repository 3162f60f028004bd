#include "lippmann/layout/interlace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "layout/picture_samples.hpp"
#include "layout/sub_pixel_views.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

template <class Sample>
Sample rounded(float value) {
  constexpr auto most = static_cast<float>(std::numeric_limits<Sample>::max());
  return static_cast<Sample>(std::clamp(value + 0.5f, 0.0f, most));
}
template <>
float rounded<float>(float value) {
  return value;
}

/// The samples of all views of a stack as one array.
template <class Sample>
struct Views {
  const Sample* samples;
  Vec2i size;
  int count;

  const Sample* row(int view, int y) const {
    return samples + (static_cast<std::size_t>(view) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(y)) * 3 *
                         static_cast<std::size_t>(size.x);
  }
};

/// Two samples for linear interpolation, with the indices `at` and `next` = min(`at` + 1, last index). `share`: weight of
/// `next`.
struct Between {
  int at, next;
  float share;
};

std::vector<Between> between_samples(int pixels, int size) {
  std::vector<Between> all;
  for (int i = 0; i < pixels; ++i) {
    const double place = std::clamp((i + 0.5) * size / pixels - 0.5, 0.0, size - 1.0);
    const int at = static_cast<int>(place);
    all.push_back({at, std::min(at + 1, size - 1), static_cast<float>(place - at)});
  }
  return all;
}

template <class Sample>
class Interlacer {
 public:
  Interlacer(const Views<Sample>& views, const SlantedPanel& panel, Vec2i pixels, const InterlaceParams& params)
      : views_(views),
        panel_(panel),
        pixels_(pixels),
        params_(params),
        across_(between_samples(pixels.x, views.size.x)),
        down_(between_samples(pixels.y, views.size.y)) {
    for (int i = 0; i < pixels.x; ++i) column_.push_back(3 * sample_at(i, pixels.x, views.size.x));
  }

  void write_row(int j, Sample* out) const {
    const SubPixelRow row = sub_pixel_row(panel_, pixels_, j);
    if (params_.filter == ViewFilter::kNearest) return write_nearest(row, j, out);
    for (int i = 0; i < pixels_.x; ++i)
      for (int color = 0; color < 3; ++color) *out++ = rounded<Sample>(mixed(row.view(i, color), i, j, color));
  }

 private:
  void write_nearest(const SubPixelRow& row, int j, Sample* out) const {
    const Sample* const first = views_.row(0, sample_at(j, pixels_.y, views_.size.y));
    const std::size_t per_view = 3 * static_cast<std::size_t>(views_.size.x) * static_cast<std::size_t>(views_.size.y);
    for (int i = 0; i < pixels_.x; ++i)
      for (int color = 0; color < 3; ++color)
        *out++ = first[static_cast<std::size_t>(nearest_view(row.view(i, color), views_.count)) * per_view +
                       static_cast<std::size_t>(column_[static_cast<std::size_t>(i)] + color)];
  }

  float bilinear(int view, int i, int j, int color) const {
    const Between x = across_[static_cast<std::size_t>(i)], y = down_[static_cast<std::size_t>(j)];
    const Sample *above = views_.row(view, y.at) + color, *below = views_.row(view, y.next) + color;
    const auto in_row = [&](const Sample* samples) {
      const auto left = static_cast<float>(samples[3 * x.at]), right = static_cast<float>(samples[3 * x.next]);
      return left + (right - left) * x.share;
    };
    const float top = in_row(above);
    return top + (in_row(below) - top) * y.share;
  }

  float mixed(double v, int i, int j, int color) const {
    const auto place = static_cast<float>(std::clamp(v * views_.count - 0.5, 0.0, views_.count - 1.0));
    if (params_.filter == ViewFilter::kLinear) {
      const int view = static_cast<int>(place);
      const float share = place - static_cast<float>(view), here = bilinear(view, i, j, color);
      return share == 0.0f ? here : here + (bilinear(view + 1, i, j, color) - here) * share;
    }
    const auto sigma = static_cast<float>(params_.sigma_views), reach = 3.0f * sigma + 0.5f;
    float sum = 0.0f, weights = 0.0f;
    const int last = std::min(views_.count - 1, static_cast<int>(place + reach));
    for (int view = std::max(0, static_cast<int>(std::ceil(place - reach))); view <= last; ++view) {
      const float away = (static_cast<float>(view) - place) / sigma, weight = std::exp(-0.5f * away * away);
      sum += weight * bilinear(view, i, j, color), weights += weight;
    }
    return sum / weights;
  }

  Views<Sample> views_;
  const SlantedPanel& panel_;
  Vec2i pixels_;
  const InterlaceParams& params_;
  std::vector<int> column_;
  std::vector<Between> across_, down_;
};

}  // namespace

void require_own_frame(const Display& display) {
  if (display.kind != DisplayKind::kSlantedPanel)
    throw usage_error(
        "display",
        fmt::format("{} is a {}, but only slanted panels have interlaced pixels", display.name, to_string(display.kind)),
        "a slanted panel");
}

Picture interlace(const LightField& field, const Display& display, const InterlaceParams& params, const ThreadPool& pool) {
  require_own_frame(display);
  if (field.grid.rows != 1)
    throw usage_error("views",
                      fmt::format("{}x{} views do not fit a panel, which shows one row", field.grid.columns, field.grid.rows),
                      "one row of views; `keep` can select one");
  const SlantedPanel panel = slanted_panel(display, viewing_distance_mm(display));
  Picture frame = blank(field.stack, display.pixels);
  std::visit(
      [&](auto& to) {
        const auto& from = std::get<std::remove_cvref_t<decltype(to)>>(field.stack);
        using Sample = typename std::remove_cvref_t<decltype(samples_of(to))>::value_type;
        const Interlacer<Sample> interlacer({samples_of(from).data(), field.view_size, field.grid.count()}, panel,
                                            display.pixels, params);
        const std::size_t row = 3 * static_cast<std::size_t>(display.pixels.x);
        pool.for_each(static_cast<std::size_t>(display.pixels.y),
                      [&](std::size_t j) { interlacer.write_row(static_cast<int>(j), samples_of(to).data() + j * row); });
      },
      frame);
  return frame;
}

}  // namespace lippmann
