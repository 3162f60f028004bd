#include <cstdint>
#include <string>

#include <fmt/format.h>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {
namespace {

constexpr int kMaxSide = 1 << 16;  ///< floats place a sample to 1/256 pixel up to here
constexpr std::int64_t kMaxPixels = std::int64_t(1) << 31;
constexpr double kMaxTilt = 1e3, kMaxPhase = 1e6;       ///< phases keep 1e-7 of a lens even so
constexpr double kMaxOffset = 4;                        ///< pixels, of sub-pixels from their pixel's centre
constexpr float kMinLength = 1e-6f, kMaxLength = 1e9f;  ///< mm; squares and quotients stay within floats

[[noreturn]] void reject(const char* field, const std::string& problem, const std::string& accepted) {
  throw usage_error(field, problem, accepted);
}

void check_count(const char* field, int value, int maximum) {
  if (value < 1 || value > maximum)
    reject(field, fmt::format("is {}", value), fmt::format("a whole number from 1 to {}", maximum));
}

void check_length(const char* field, float value) {
  if (!(value >= kMinLength && value <= kMaxLength))
    reject(field, fmt::format("is {} mm", value), fmt::format("a length from {} to {} mm", kMinLength, kMaxLength));
}

void check_distance_or_infinity(const char* field, float value) {
  if (value == kInfinity) return;
  if (!(value >= kMinLength && value <= kMaxLength))
    reject(field, fmt::format("is {} mm", value), fmt::format("a distance from {} to {} mm, or inf", kMinLength, kMaxLength));
}

void check_position(const char* field, float value) {
  if (!(std::abs(value) <= kMaxLength))
    reject(field, fmt::format("is {} mm", value), fmt::format("a position within {} mm of the centre", kMaxLength));
}

/// A cell narrower than a pixel holds no picture. (0.999: pitches of one pixel may come out a rounding error narrower.)
void check_lens(const char* field, float lens_pitch_mm, const Panel& panel) {
  check_length(field, lens_pitch_mm);
  if (lens_pitch_mm < 0.999f * panel.pixel_pitch_mm)
    reject(field, fmt::format("is {} mm, less than one pixel", lens_pitch_mm),
           fmt::format("at least the pixel pitch, {} mm", panel.pixel_pitch_mm));
}

void check_number(const char* field, double value, double low, double high) {
  if (!(value >= low && value <= high))
    reject(field, fmt::format("is {}", value), fmt::format("a number from {} to {}", low, high));
}

void check_panel(const Panel& panel) {
  check_count("panel.width", panel.width, kMaxSide);
  check_count("panel.height", panel.height, kMaxSide);
  if (std::int64_t(panel.width) * panel.height > kMaxPixels)
    reject("panel", fmt::format("has {} x {} pixels", panel.width, panel.height), fmt::format("at most {} pixels", kMaxPixels));
  check_length("panel.pixel_pitch_mm", panel.pixel_pitch_mm);
}

void check_model(const Panel& panel, const LenticularSheet& sheet) {
  check_lens("lenticular.lens_pitch_mm", sheet.lens_pitch_mm, panel);
  check_length("lenticular.gap_mm", sheet.gap_mm);
  if (!(std::abs(sheet.slant) < radians(89.9f)))
    reject("lenticular.slant", fmt::format("is {} degrees", degrees(sheet.slant)), "an angle between -89.9 and 89.9 degrees");
  check_position("lenticular.offset_mm", sheet.offset_mm);
  check_distance_or_infinity("lenticular.viewing_distance_mm", sheet.viewing_distance_mm);
  check_position("lenticular.eye_height_mm", sheet.eye_height_mm);
}

void check_model(const Panel& panel, const MicrolensArray& array) {
  check_lens("microlens.lens_pitch_mm", array.lens_pitch_mm, panel);
  check_length("microlens.gap_mm", array.gap_mm);
  check_position("microlens.offset_mm.x", array.offset_mm.x);
  check_position("microlens.offset_mm.y", array.offset_mm.y);
  check_distance_or_infinity("microlens.viewing_distance_mm", array.viewing_distance_mm);
}

void check_model(const Panel& panel, const MultiView& views) {
  check_count("multiview.columns", views.columns, panel.width);
  check_count("multiview.rows", views.rows, panel.height);
  if (!(views.view_cone >= 0.0f && views.view_cone <= radians(179.0f)))
    reject("multiview.view_cone", fmt::format("is {} degrees", degrees(views.view_cone)), "an angle from 0 to 179 degrees");
  check_length("multiview.distance_mm", views.distance_mm);
  if (views.baseline_mm != 0.0f) check_length("multiview.baseline_mm", views.baseline_mm);
  check_number("multiview.pixel_height", views.pixel_height, 0.01, 100);
}

void check_model(const Panel&, const SingleView& view) {
  check_length("singleview.distance_mm", view.distance_mm);
  for (const float offset : {view.pixel_offset.x, view.pixel_offset.y})
    if (!(std::abs(offset) <= kMaxSide))
      reject("singleview.pixel_offset", fmt::format("is {} pixels", offset), fmt::format("at most {} pixels", kMaxSide));
}

void check_model(const Panel& panel, const SlantedPanel& slanted) {
  if (panel.width % 3 != 0)
    reject("panel.width", fmt::format("is {}, which is no whole number of pixels of three sub-pixels", panel.width),
           "3 sub-pixels for each pixel of a slanted panel");
  check_number("slanted.periods", slanted.periods, 1e-3, panel.width);  // a lens is as wide as a sub-pixel at least
  check_number("slanted.tilt", slanted.tilt, -kMaxTilt, kMaxTilt);
  check_number("slanted.center", slanted.center, -kMaxPhase, kMaxPhase);
  if (!(slanted.view_cone >= 0.0f && slanted.view_cone <= radians(179.0f)))
    reject("slanted.view_cone", fmt::format("is {} degrees", degrees(slanted.view_cone)), "an angle from 0 to 179 degrees");
  check_length("slanted.distance_mm", slanted.distance_mm);
  for (const auto& row : slanted.sub_pixels)
    for (const auto& column : row)
      for (const Vec2f offset : column)
        for (const float value : {offset.x, offset.y}) check_number("slanted.sub_pixels", value, -kMaxOffset, kMaxOffset);
}

void check_depths(const Optics& optics) {
  if (std::isnan(optics.z_front_mm) || optics.z_front_mm < -kMaxLength)
    reject("z_front_mm", fmt::format("is {} mm", optics.z_front_mm), "a depth in front of z_back, or inf");
  if (std::isfinite(optics.z_front_mm)) check_position("z_front_mm", optics.z_front_mm);
  if (!(-optics.z_back_mm < resolved_z_front_mm(optics)))
    reject("z_back_mm",
           fmt::format("is {} mm: rays that start at z = {} mm and end at {} mm have no length", optics.z_back_mm,
                       resolved_z_front_mm(optics), -optics.z_back_mm),
           "a distance behind the display that lies behind z_front, or inf");
}

}  // namespace

void validate(const Optics& optics) {
  check_panel(optics.panel);
  std::visit([&](const auto& model) { check_model(optics.panel, model); }, optics.model);
  check_depths(optics);
}

}  // namespace lippmann
