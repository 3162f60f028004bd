#include <cstdint>

#include "optics/checks.hpp"
#include "optics/models.hpp"

namespace lippmann {
namespace {

constexpr std::int64_t kMaxPixels = std::int64_t(1) << 31;

void check_panel(const Panel& panel, int sub_pixels) {
  check_count("panel.width", panel.width, kMaxSide / sub_pixels);
  check_count("panel.height", panel.height, kMaxSide);
  if (std::int64_t(panel.width) * sub_pixels * panel.height > kMaxPixels)
    reject_field("panel", fmt::format("has {} x {} pixels", panel.width, panel.height),
                 fmt::format("at most {} pixels", kMaxPixels / sub_pixels));
  check_length("panel.pixel_pitch_mm", panel.pixel_pitch_mm);
}

void check_depths(const Optics& optics) {
  if (std::isnan(optics.z_front_mm) || optics.z_front_mm < -kMaxLength)
    reject_field("z_front_mm", fmt::format("is {} mm", optics.z_front_mm), "a depth in front of z_back, or inf");
  if (std::isfinite(optics.z_front_mm)) check_position("z_front_mm", optics.z_front_mm);
  if (!(-optics.z_back_mm < resolved_z_front_mm(optics)))
    reject_field("z_back_mm",
                 fmt::format("is {} mm, so that rays start at z = {} mm and end at {} mm", optics.z_back_mm,
                             resolved_z_front_mm(optics), -optics.z_back_mm),
                 "a distance behind the display and behind z_front, or inf");
}

}  // namespace

void validate(const Optics& optics) {
  check_panel(optics.panel, sub_pixels_per_pixel(optics));
  std::visit([&](const auto& model) { check_model(optics.panel, model); }, optics.model);
  check_depths(optics);
}

}  // namespace lippmann
