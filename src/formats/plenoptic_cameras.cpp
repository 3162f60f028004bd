#include "formats/plenoptic_cameras.hpp"

#include <cmath>

#include "optics/plenoptic.hpp"

namespace lippmann {

std::vector<PosedCamera> plenoptic_cameras(const Optics& optics, const SampledLenses& lenses, Vec2i view_size,
                                           const std::vector<Vec2d>& offsets_px) {
  const Vec2d right_up(1.0, -1.0);
  const auto& camera = std::get<PlenopticCamera>(optics.model);
  const double m = optics.panel.pixel_pitch_mm, b = camera.gap_mm, f = camera.focal_length_mm, t = array_distance_mm(camera);
  const double array_per_sensor = 1.0 / (1.0 + b / t);
  const Vec2d middle_px = 0.5 * Vec2d(optics.panel.width, optics.panel.height);
  const Vec2d first_mm = (lenses.first_px - middle_px) * right_up * m * array_per_sensor;
  const Vec2d step_mm = lenses.step_px * m * array_per_sensor;
  std::vector<PosedCamera> cameras;
  for (const Vec2d& offset_px : offsets_px) {
    const Vec2d eye_mm = offset_px * right_up * m * t / b;
    const Vec2d axis_mm = eye_mm * (t / f - 1.0);
    cameras.push_back({.size = view_size,
                       .focal_px = t / step_mm,
                       .principal_px = 0.5 + (axis_mm - first_mm) / step_mm * right_up,
                       .position_mm = Vec3d(eye_mm, camera.distance_mm)});
  }
  return cameras;
}

std::optional<ViewCameras> microlens_cameras(const Optics& optics, const SampledLenses& lenses,
                                             const std::vector<Vec2d>& offsets_px) {
  const LensArray array = lens_array(optics).value();
  const double v = array.viewing_distance_mm;
  if (!std::isfinite(v)) return std::nullopt;
  const double lens_mm_per_px = optics.panel.pixel_pitch_mm / (1.0 + array.gap_mm / v);
  const Vec2d middle_px = 0.5 * Vec2d(optics.panel.width, optics.panel.height);
  ViewCameras cameras{v, lenses.step_px * lens_mm_per_px, 0.5 - (lenses.first_px - middle_px) / lenses.step_px, {}};
  for (const Vec2d& offset_px : offsets_px) {
    const Ray ray = ray_of_pixel(optics, Vec2f(lenses.first_px + offset_px));
    const Vec3d at(ray.origin), towards(ray.direction);
    cameras.eyes_mm.emplace_back(Vec2d(at) + Vec2d(towards) * ((v - at.z) / towards.z));
  }
  return cameras;
}

}  // namespace lippmann
