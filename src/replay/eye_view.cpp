#include "lippmann/replay/eye_view.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"

namespace lippmann {
namespace {

/// Returns points spread evenly over the pupil. Based on: Vogel, "A better way to construct the sunflower head", Math.
/// Biosciences 44, 1979.
std::vector<Vec2d> pupil_points(double diameter_mm, int count) {
  if (diameter_mm == 0.0) return {Vec2d(0.0)};
  const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
  std::vector<Vec2d> points;
  for (int i = 0; i < count; ++i) {
    const double radius = 0.5 * diameter_mm * std::sqrt((i + 0.5) / count), angle = i * golden_angle;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

/// Returns the number of samples per pixel of the view: more than one if the display has more lenses than the view has pixels.
Vec2i samples_per_pixel(const Optics& optics, Vec2i size) {
  constexpr int kMax = 16;
  const Vec2i grid = lens_grid(optics);
  return glm::clamp((grid + size - 1) / size, Vec2i(1), Vec2i(kMax));
}

}  // namespace

void validate(const EyeView& view) {
  constexpr double kFarthestMm = 1e9, kNearestMm = 1e-3;
  const Vec3d eye = view.eye_mm;
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(eye[axis]) <= kFarthestMm))
      throw usage_error("eye", fmt::format("({}, {}, {}) mm is not a position", eye.x, eye.y, eye.z),
                        "X,Y,Z in mm of the display frame");
  if (!(eye.z >= kNearestMm))
    throw usage_error("eye", fmt::format("an eye at z = {} mm is not in front of the display plane z = 0", eye.z),
                      fmt::format("z of at least {} mm", kNearestMm));
  if (!(view.pupil_mm >= 0.0 && view.pupil_mm <= kFarthestMm) || view.pupil_points < 1)
    throw usage_error("pupil", fmt::format("{} mm is out of range", view.pupil_mm), "0 (a pinhole) or more");
  if (!(std::abs(view.focus_mm) <= kFarthestMm && view.focus_mm < 0.999 * eye.z))
    throw usage_error("focus", fmt::format("{} mm is not in front of the eye", view.focus_mm), "a depth below the eye's z");
  if (view.size != Vec2i(0) && !(view.size.x > 0 && view.size.y > 0))
    throw usage_error("size", fmt::format("is {}x{}", view.size.x, view.size.y),
                      "two numbers of pixels, or 0x0 for the natural size");
  if (!(view.crosstalk_px >= 0.0 && view.crosstalk_px <= kMaxBlurPx))
    throw usage_error("crosstalk", fmt::format("{} pixels", view.crosstalk_px), fmt::format("0 to {}", kMaxBlurPx));
}

Image eye_view(const RenderedPanel& rendered, const EyeView& view, const ThreadPool& pool, const Context& context) {
  const Window window = display_window(rendered.optics);
  const Vec2i size = view.size.x > 0 ? view.size : natural_view_size(rendered.optics);
  const Vec2i samples = samples_per_pixel(rendered.optics, size);
  const EyeSampler sampler(rendered, view.filter, view.crosstalk_px);
  // If the eye at E sees a point of depth z at s, the pupil point E + d sees it at s - d z / (E.z - z). The images of all
  // pupil points are shifted so that they coincide at the depth of focus.
  const double shift = -view.focus_mm / (view.eye_mm.z - view.focus_mm);
  struct PupilPoint {
    Viewer viewer;
    Vec2d shift_mm;
  };
  std::vector<PupilPoint> pupil;
  for (const Vec2d& point : pupil_points(view.pupil_mm, view.pupil_points))
    pupil.push_back({viewer_at(view.eye_mm + Vec3d(point, 0.0)), shift * point});
  const float weight = 1.0f / static_cast<float>(samples.x * samples.y * static_cast<int>(pupil.size()));
  Image picture(size.x, size.y, 3);
  pool.for_each(static_cast<std::size_t>(size.y), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < size.x && !context.cancelled; ++x) {  // checked per pixel, because a row may take seconds
      Vec3f sum(0.0f);
      for (int j = 0; j < samples.y; ++j)
        for (int i = 0; i < samples.x; ++i) {
          const Vec2d at(x + (i + 0.5) / samples.x, y + (j + 0.5) / samples.y);
          for (const PupilPoint& p : pupil) sum += sampler.color(p.viewer, window.point_at(at, size) + p.shift_mm);
        }
      float* pixel = picture.pixel(x, y);
      for (int c = 0; c < 3; ++c) pixel[c] = weight * sum[c];
    }
  });
  return picture;
}

}  // namespace lippmann
