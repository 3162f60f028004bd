#include "optics/eye_height.hpp"

#include <cmath>

#include "lippmann/core/error.hpp"

namespace lippmann {

float eye_height_mm(const EyeHeight& height, float distance_mm) {
  return height.is_angle ? distance_mm * std::tan(radians(height.value)) : height.value;
}

Optics with_eye_height(Optics optics, const std::optional<EyeHeight>& height) {
  if (!height) return optics;
  const float distance = viewing_distance_mm(optics);
  if (!std::isfinite(distance))
    throw usage_error("eye-height", "has no effect on an infinitely distant viewer", "a finite `viewing-distance`");
  std::visit(
      [&](auto& model) {
        if constexpr (requires { model.eye_height_mm; })
          model.eye_height_mm = eye_height_mm(*height, distance);
        else
          throw usage_error("eye-height", "has no effect on optics with vertical parallax",
                            "`optics` lenticular, multiview or single");
      },
      optics.model);
  return optics;
}

}  // namespace lippmann
