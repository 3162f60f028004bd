#include "apps/lippmann/camera_flags.hpp"

#include <string>

#include "apps/lippmann/command_line.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::app {

const char* CameraFlags::first_given() const {
  if (baseline_mm) return "--baseline";
  if (focal_length_mm) return "--focal-length";
  if (sensor_width_mm) return "--sensor-width";
  return focus_distance_mm ? "--focus-distance" : nullptr;
}

std::optional<StatedCameras> CameraFlags::read() const {
  const char* given = first_given();
  if (!given) return std::nullopt;
  const auto needed = [&](const std::optional<double>& length, const char* flag) {
    if (!length) throw usage_error(flag, "is required with " + std::string(given), "a length in mm");
    return *length;
  };
  StatedCameras cameras;
  cameras.baseline_mm = needed(baseline_mm, "--baseline");
  cameras.focal_length_mm = needed(focal_length_mm, "--focal-length");
  cameras.focus_distance_mm = needed(focus_distance_mm, "--focus-distance");
  cameras.sensor_width_mm = sensor_width_mm.value_or(cameras.sensor_width_mm);
  return cameras;
}

void add_camera_flags(const Command& command, CameraFlags& flags) {
  const Command group = command.add_group("Cameras, for views whose files do not state them");
  group.add_option("--baseline", flags.baseline_mm, "Distance between neighbouring cameras").type_name("MM").positive();
  group.add_option("--focal-length", flags.focal_length_mm, "Focal length of the cameras").type_name("MM").positive();
  group.add_option("--sensor-width", flags.sensor_width_mm, "Width of the camera's sensor, which a view covers; default: 35")
      .type_name("MM")
      .positive();
  group
      .add_option("--focus-distance", flags.focus_distance_mm,
                  "Distance from the cameras to the zero plane, whose points do not move from view to view")
      .type_name("MM")
      .positive();
}

}  // namespace lippmann::app
