#include "align/parallax.hpp"

#include <algorithm>
#include <utility>

namespace lippmann {
namespace {

constexpr double kLeftOut = 0.02;

struct Range {
  double low = 0.0, high = 0.0;
};

/// Returns the range of the horizontal motion of a pair's points: x in the other image minus x in the middle image. The
/// fraction kLeftOut of the points is left out at each end.
Range range_in(const RegisteredPictures& registered, const SharedPlaces& pair) {
  std::vector<double> moves;
  for (std::size_t i = 0; i < pair.in_first.size(); ++i)
    moves.push_back(registered.pictures[pair.first](pair.in_first[i]).x -
                    registered.pictures[pair.second](pair.in_second[i]).x);
  if (pair.first == registered.middle)
    for (double& move : moves) move = -move;
  std::sort(moves.begin(), moves.end());
  const auto last = static_cast<double>(moves.size() - 1);
  return {moves[static_cast<std::size_t>(kLeftOut * last + 0.5)],
          moves[static_cast<std::size_t>((1.0 - kLeftOut) * last + 0.5)]};
}

double lens_width_mm(const Display& display) {
  switch (display.kind) {
    case DisplayKind::kSlantedPanel:
      return display.size_mm().x / std::abs(periods_of(display));
    case DisplayKind::kLenticularSheet:
      return lens_strips(display).cell_px * display.pixel_mm();
    case DisplayKind::kMicrolensArray:
      break;
  }
  return display.lenses.pitch_mm;
}

}  // namespace

Parallax parallax_of(const RegisteredPictures& registered) {
  std::size_t first = registered.middle, last = registered.middle;
  Range at_first, at_last;
  for (const SharedPlaces& pair : registered.shared) {
    if (pair.first != registered.middle && pair.second != registered.middle) continue;
    const std::size_t picture = pair.first == registered.middle ? pair.second : pair.first;
    if (picture < first) first = picture, at_first = range_in(registered, pair);
    if (picture > last) last = picture, at_last = range_in(registered, pair);
  }
  const double steps = static_cast<double>(registered.pictures.size() - 1) / static_cast<double>(last - first);
  return {(at_first.high - at_last.low) * steps, (at_first.low - at_last.high) * steps};
}

ShownParallax shown_parallax(const Display& display, Vec2i picture_size, std::size_t count) {
  ShownParallax shown;
  const Vec2d scale = display.size_mm() / Vec2d(picture_size);
  shown.mm_per_px = std::max(scale.x, scale.y);
  shown.lens_mm = lens_width_mm(display);
  shown.views = std::min(views_of(display), static_cast<int>(count));
  shown.resolved_lenses = shown.views - 1;
  return shown;
}

}  // namespace lippmann
