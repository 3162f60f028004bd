#include "lippmann/formats/plenoptic_calibration.hpp"

#include <fmt/format.h>

#include <memory>
#include <numbers>
#include <utility>

#include "formats/estimate_lens_grid.hpp"
#include "formats/lens_grid_file.hpp"
#include "formats/plenoptic_views.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

void require_lens_pitch(std::optional<double> pitch_px, const char* setting) {
  if (!pitch_px || (*pitch_px >= kLeastLensPitchPx && *pitch_px <= kMostLensPitchPx)) return;
  throw usage_error(setting, fmt::format("is {} pixels", *pitch_px),
                    fmt::format("{} to {} pixels", kLeastLensPitchPx, kMostLensPitchPx));
}

void refuse_without_pitch(const PlenopticSettings& settings) {
  const auto refuse = [](bool is_set, const char* setting) {
    if (is_set)
      throw usage_error(setting, "has no effect without `lens-pitch-px`", "`lens-pitch-px` and this setting, or only `white`");
  };
  refuse(settings.row_pitch_px.has_value(), "lens-row-pitch-px");
  refuse(settings.rotation_deg.has_value(), "lens-rotation");
  refuse(settings.offset_px.has_value(), "lens-offset");
  refuse(!settings.arrangement.empty(), "lens-arrangement");
}

LensArrangement arrangement_of(const PlenopticSettings& settings) {
  if (settings.arrangement.empty()) return LensArrangement::kSquare;
  if (const std::optional<LensArrangement> known = read_arrangement(settings.arrangement)) return *known;
  throw usage_error("lens-arrangement", "is '" + settings.arrangement + "'", "square, hexagonal or hexagonal-columns");
}

LensGrid stated_grid(const PlenopticSettings& settings) {
  require_lens_pitch(settings.pitch_px, "lens-pitch-px");
  require_lens_pitch(settings.row_pitch_px, "lens-row-pitch-px");
  const double turn = settings.rotation_deg.value_or(0.0) * std::numbers::pi / 180.0;
  const Vec2d offset = settings.offset_px.value_or(Vec2d(0.5 * *settings.pitch_px));
  LensGrid grid = lens_grid(*settings.pitch_px, turn, offset, arrangement_of(settings));
  grid.row_pitch_px = settings.row_pitch_px.value_or(grid.row_pitch_px);
  return grid;
}

}  // namespace

ReadPlenopticSettings read_plenoptic_settings(const PlenopticSettings& settings) {
  ReadPlenopticSettings read;
  if (!settings.pitch_px) refuse_without_pitch(settings);
  if (!settings.pitch_px && settings.white.empty() && !settings.lanczos && !settings.inverted) return read;
  PlenopticCalibration& calibration = read.calibration.emplace();
  calibration.lanczos = settings.lanczos, calibration.inverted = settings.inverted;
  if (settings.pitch_px) calibration.grid = stated_grid(settings);
  if (settings.white.empty()) return read;
  auto white = std::make_shared<const Image>(read_white(settings.white));
  if (!calibration.grid) {
    read.fit = estimate_lens_grid(*white, settings.white.string());
    calibration.grid = read.fit->grid;
  }
  calibration.white = std::move(white);
  return read;
}

}  // namespace lippmann
