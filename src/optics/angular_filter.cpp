#include "lippmann/optics/angular_filter.hpp"

#include <algorithm>
#include <numeric>

namespace lippmann {
namespace {

double radical_inverse(int i, int base) {
  double inverse = 0.0, digit = 1.0;
  for (; i > 0; i /= base) inverse += i % base * (digit /= base);
  return inverse;
}

/// Returns one position from -1/2 to 1/2 per sample. The positions are the midpoints of equal intervals. Positions of samples
/// have the same order as their radical inverses.
std::vector<float> places(int samples, int base) {
  std::vector<int> by_place(static_cast<std::size_t>(samples));
  std::iota(by_place.begin(), by_place.end(), 0);
  std::sort(by_place.begin(), by_place.end(),
            [base](int a, int b) { return radical_inverse(a, base) < radical_inverse(b, base); });
  std::vector<float> places(by_place.size());
  for (int rank = 0; rank < samples; ++rank)
    places[static_cast<std::size_t>(by_place[static_cast<std::size_t>(rank)])] =
        static_cast<float>((rank + 0.5) / samples - 0.5);
  return places;
}

}  // namespace

std::vector<Vec2f> eye_shifts(const Optics& optics, AngularFilter filter, int samples) {
  const std::optional<ViewTiles> views = view_tiles(optics);
  if (filter == AngularFilter::kNone || !views) return {Vec2f(0.0f)};
  const bool grid = views->camera_grid;
  const bool across = grid ? views->columns > 1 : views->count() > 1, up = grid && views->rows > 1;
  const std::vector<float> x = places(samples, 3), y = places(samples, 5);
  std::vector<Vec2f> shifts;
  for (std::size_t i = 0; i < x.size(); ++i) shifts.emplace_back(across ? x[i] : 0.0f, up ? y[i] : 0.0f);
  return shifts;
}

Optics with_eyes_shifted(Optics optics, Vec2f shift) {
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.eye_shift; }) model.eye_shift = shift;
      },
      optics.model);
  return optics;
}

}  // namespace lippmann
