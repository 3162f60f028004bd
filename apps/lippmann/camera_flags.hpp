// Flags that define the cameras of a light field whose files do not define them.
#pragma once

#include <optional>

#include "lippmann/formats/formats.hpp"

namespace lippmann::app {

class Command;

struct CameraFlags {
  std::optional<double> baseline_mm, focal_length_mm, sensor_width_mm, focus_distance_mm;

  /// Returns the name of the first of these flags that is given, or null.
  const char* first_given() const;
  /// Returns the cameras, or nullopt if no flag is given. Throws a usage Error naming a missing flag.
  std::optional<StatedCameras> read() const;
};

void add_camera_flags(const Command& command, CameraFlags& flags);

}  // namespace lippmann::app
