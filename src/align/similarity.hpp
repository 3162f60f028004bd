// Similarity transforms of an image plane: rotation, scale and translation. Positions are in pixels, x right and y down from
// the corner of the top-left pixel.
#pragma once

#include <cmath>
#include <numbers>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// Maps q to (a q.x - b q.y + x, b q.x + a q.y + y). The rotation is clockwise in the image, by atan2(b, a).
struct Similarity {
  double a = 1.0, b = 0.0, x = 0.0, y = 0.0;

  Vec2d operator()(Vec2d q) const { return {a * q.x - b * q.y + x, b * q.x + a * q.y + y}; }
  double scale() const { return std::hypot(a, b); }
  double turn_deg() const { return std::atan2(b, a) * (180.0 / std::numbers::pi); }

  bool operator==(const Similarity&) const = default;
};

inline Similarity operator*(const Similarity& second, const Similarity& first) {
  const Vec2d moved = second(Vec2d(first.x, first.y));
  return {second.a * first.a - second.b * first.b, second.b * first.a + second.a * first.b, moved.x, moved.y};
}

inline Similarity inverse(const Similarity& s) {
  const double square = s.a * s.a + s.b * s.b;
  Similarity back{s.a / square, -s.b / square, 0.0, 0.0};
  const Vec2d moved = back(Vec2d(s.x, s.y));
  back.x = -moved.x, back.y = -moved.y;
  return back;
}

}  // namespace lippmann
