// Makes the calibration of raw plenoptic pictures from numbers, or from a picture of uniform white light.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lippmann/layout/lens_grid.hpp"

namespace lippmann {

inline constexpr double kLeastLensPitchPx = 2.0, kMostLensPitchPx = 4096.0;

/// The lens grid as a user states it, in pixels from the top left of the picture. Without pitch_px, the grid is fitted to
/// `white`, and the other members that describe the grid must be empty.
struct PlenopticSettings {
  std::filesystem::path white = {};         ///< picture of uniform white light by the same camera; empty: none
  std::optional<double> pitch_px = {};      ///< pitches must be kLeastLensPitchPx ... kMostLensPitchPx
  std::optional<double> row_pitch_px = {};  ///< none: equally spaced lenses
  std::optional<double> rotation_deg = {};  ///< clockwise rotation of the rows; none: 0
  std::optional<Vec2d> offset_px = {};      ///< centre of any lens; none: half a pitch from the left and top edges
  std::string arrangement = {};             ///< square, hexagonal or hexagonal-columns; empty: square
  bool lanczos = false, inverted = false;   ///< see PlenopticCalibration
};

/// A lens grid that was fitted to a white picture.
struct LensGridFit {
  LensGrid grid{};           ///< grid.offset_px is the centre of the lens nearest to the middle of the picture
  int lenses = 0;            ///< number of lenses used in the fit
  double residual_px = 0.0;  ///< root mean square distance of the lens centres from the grid
};

struct ReadPlenopticSettings {
  std::optional<PlenopticCalibration> calibration = {};  ///< none: all settings have their defaults
  std::optional<LensGridFit> fit = {};                   ///< none: no white picture, or pitch_px is set
};

/// Reads the white picture, and fits the lens grid to it unless pitch_px is set. Throws a usage Error naming the setting
/// (lens-pitch-px, lens-row-pitch-px, ...) or Error naming the file.
ReadPlenopticSettings read_plenoptic_settings(const PlenopticSettings& settings);

}  // namespace lippmann
