// Extracts views from the interlaced frame of a slanted panel. Row y of every view is made from the panel rows whose centres
// lie in row y when the panel is scaled to the size of the view.
#include <fmt/format.h>

#include <limits>

#include "layout/sub_pixel_views.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/interlace.hpp"

namespace lippmann {
namespace {

constexpr float kNone = std::numeric_limits<float>::infinity();

/// One row of samples of every view, with the nearest sub-pixel found so far for each sample.
template <class Sample>
class SampleRow {
 public:
  SampleRow(int views, int width)
      : width_(width), best_(3 * static_cast<std::size_t>(views) * static_cast<std::size_t>(width), Found{kNone, {}}) {}

  /// Takes `value` for a sample if its sub-pixel is nearer than the sub-pixels offered before. `distance`: squared distance
  /// between the sub-pixel and the sample in three dimensions: x and y in samples, and the number of the view.
  void offer(int view, int x, int color, float distance, Sample value) {
    Found& best = best_[at(view, x, color)];
    if (distance < best.distance) best = {distance, value};
  }

  /// Writes the row. Samples without a sub-pixel copy the nearest sample with a sub-pixel, the left one in case of a tie.
  /// Returns false if no sample of the row has a sub-pixel.
  bool write(int view, int color, Sample* out) const {
    int left = -1, right = next(view, 0, color);
    if (right == width_) return false;
    for (int x = 0; x < width_; ++x) {
      if (x == right) left = x, right = next(view, x + 1, color);
      const bool from_right = left < 0 || (right < width_ && right - x < x - left);
      out[3 * x + color] = best_[at(view, from_right ? right : left, color)].value;
    }
    return true;
  }

 private:
  struct Found {
    float distance;
    Sample value;
  };

  std::size_t at(int view, int x, int color) const {
    return 3 * (static_cast<std::size_t>(view) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) +
           static_cast<std::size_t>(color);
  }
  /// Returns the first sample at or after x that has a sub-pixel, or width_.
  int next(int view, int x, int color) const {
    while (x < width_ && best_[at(view, x, color)].distance == kNone) ++x;
    return x;
  }

  int width_;
  std::vector<Found> best_;
};

template <class Image>
void fill(const Image& frame, const auto& samples, const SlantedPanel& panel, int count, Vec2i size, auto& views,
          const ThreadPool& pool) {
  using Sample = std::remove_cvref_t<decltype(samples[0])>;
  const Vec2i pixels(frame.width, frame.height);
  const std::size_t row_size = 3 * static_cast<std::size_t>(size.x);
  pool.for_each(static_cast<std::size_t>(size.y), [&](std::size_t sample_row) {
    const int y = static_cast<int>(sample_row);
    SampleRow<Sample> found(count, size.x);
    const auto take = [&](int j) {
      const SubPixelRow row = sub_pixel_row(panel, pixels, j);
      const Sample* in = samples.data() + static_cast<std::size_t>(j) * 3 * static_cast<std::size_t>(pixels.x);
      const double dy = (j + 0.5) * size.y / pixels.y - (y + 0.5);
      for (int i = 0; i < pixels.x; ++i) {
        const int x = sample_at(i, pixels.x, size.x);
        const double dx = (i + 0.5) * size.x / pixels.x - (x + 0.5);
        for (int color = 0; color < 3; ++color) {
          const double v = row.view(i, color);
          const int view = nearest_view(v, count);
          const double dv = v * count - (view + 0.5);
          found.offer(view, x, color, static_cast<float>(dx * dx + dy * dy + dv * dv), in[3 * i + color]);
        }
      }
    };
    // `first` becomes the first panel row whose centre is not above this row of samples. If the view has more rows than the
    // panel, the centre may lie below this row.
    int first = static_cast<int>(static_cast<std::int64_t>(y) * pixels.y / size.y);
    while (first > 0 && sample_at(first - 1, pixels.y, size.y) >= y) --first;
    while (first + 1 < pixels.y && sample_at(first, pixels.y, size.y) < y) ++first;
    take(first);
    for (int j = first + 1; j < pixels.y && sample_at(j, pixels.y, size.y) == y; ++j) take(j);
    for (int view = 0; view < count; ++view)
      for (int color = 0; color < 3; ++color)
        found.write(view, color,
                    views.data() + (static_cast<std::size_t>(view) * static_cast<std::size_t>(size.y) + sample_row) * row_size);
  });
}

}  // namespace

LightField deinterlace(const Picture& frame, const Display& display, int count, Vec2i view_size, const std::string& where,
                       const ThreadPool& pool) {
  if (display.kind != DisplayKind::kSlantedPanel)
    throw usage_error(
        "display",
        fmt::format("{} is a {}, but only slanted panels have interlaced pixels", display.name, to_string(display.kind)),
        "a slanted panel");
  const Vec2i size = size_of(frame);
  if (size != display.pixels)
    throw Error(where, fmt::format("has {}x{} pixels", size.x, size.y),
                fmt::format("{}x{}, a frame for the display {}", display.pixels.x, display.pixels.y, display.name));
  LightField field{.stack = blank(frame, {view_size.x, view_size.y * count}), .grid = {count, 1}, .view_size = view_size};
  field.aspect = static_cast<double>(size.x) / size.y;
  const SlantedPanel panel = slanted_panel(display, viewing_distance_mm(display));
  if (const auto* bytes = std::get_if<Image8>(&frame))
    fill(*bytes, bytes->rgb, panel, count, view_size, std::get<Image8>(field.stack).rgb, pool);
  else if (const auto* words = std::get_if<Image16>(&frame))
    fill(*words, words->rgb, panel, count, view_size, std::get<Image16>(field.stack).rgb, pool);
  else
    fill(std::get<Image>(frame), std::get<Image>(frame).data, panel, count, view_size, std::get<Image>(field.stack).data, pool);
  return field;
}

}  // namespace lippmann
