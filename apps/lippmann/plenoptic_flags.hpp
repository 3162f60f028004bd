// Flags of `convert` for raw pictures of plenoptic cameras.
#pragma once

#include <optional>
#include <string>

#include "layout/estimate_lens_grid.hpp"
#include "lippmann/layout/lens_grid.hpp"

namespace lippmann::app {

class Command;  // declared in command_line.hpp

struct PlenopticFlags {
  std::string white, offset, arrangement, sampling;
  std::optional<double> pitch_px, row_pitch_px, rotation_deg;
  bool inverted = false;
};

struct ReadPlenopticFlags {
  std::optional<PlenopticCalibration> calibration = {};  ///< nullopt if no flag is given
  std::optional<LensGridFit> fit = {};  ///< the grid estimated from the white picture; nullopt if flags define it
};

void add_plenoptic_flags(const Command& command, PlenopticFlags& flags);

/// Reads the white picture. Estimates the lens grid from it, unless flags define the grid. Throws Error naming the flag or the
/// file.
ReadPlenopticFlags read_plenoptic_flags(const PlenopticFlags& flags);

}  // namespace lippmann::app
