// Flags of `convert` for raw pictures of plenoptic cameras.
#pragma once

#include <optional>
#include <string>

#include "lippmann/formats/plenoptic_calibration.hpp"

namespace lippmann::app {

class Command;  // declared in command_line.hpp

struct PlenopticFlags {
  std::string white, offset, arrangement, sampling;
  std::optional<double> pitch_px, row_pitch_px, rotation_deg;
  bool inverted = false;
};

void add_plenoptic_flags(const Command& command, PlenopticFlags& flags);

/// Reads the flags and the white picture that they name. Throws Error naming the flag or the file.
ReadPlenopticSettings read_plenoptic_flags(const PlenopticFlags& flags);

}  // namespace lippmann::app
