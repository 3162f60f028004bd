// parameters.cfg of the 4D light field benchmark (HCI): cameras, and the disparities that follow from them.
//
// Parallel cameras a baseline b apart, focal length f, sensor of size s on its longer side of n pixels; pictures are shifted so
// that points at the focus distance F do not move from view to view. A point at planar depth Z moves by
//   d = (beta F / Z - beta) / (F s),   beta = b f n    pixels from camera to camera (lengths in mm)
// to the left as the camera moves right, where it is nearer than F. Our off-axis views through one rectangle of z = 0 are that
// model: F is their distance from the plane, F s / f the longer side of the rectangle.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lippmann/layout/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

struct HciParameters {
  double focal_length_mm = 100.0, sensor_size_mm = 35.0, fstop = 100.0;
  int width = 0, height = 0;  ///< pixels of a view
  int columns = 1, rows = 1;
  double baseline_mm = 0.0, focus_distance_m = 1.0;
  double centre_camera_m[3] = {0.0, 0.0, 0.0};
  std::string scene = {};
  double disparity_min = 0.0, disparity_max = 0.0;
};

/// Throws Error naming `where` for what is missing, not a number, or no camera.
HciParameters parse_hci_parameters(const std::string& text, const std::string& where);
std::string hci_parameters_text(const HciParameters& parameters);

/// Reads FOLDER/parameters.cfg; none if there is no such file. Throws Error naming it.
std::optional<HciParameters> read_hci_parameters(const std::filesystem::path& folder);
/// Returns the path.
std::filesystem::path write_hci_parameters(const std::filesystem::path& folder, const HciParameters& parameters);

/// Pixels from camera to camera, positive nearer than the focus distance. depth_m: planar, above 0; inf: at infinity.
double hci_disparity_px(const HciParameters& parameters, double depth_m);

/// The parameters of a light field whose cameras are known. Sensors are 35 mm wide. Throws Error naming `where` if the format
/// cannot say what they are: distances between eyes that differ, or pixels that are not square.
HciParameters hci_parameters(const LightField& field, const std::string& where);
/// The same with the mean distance between neighbouring eyes, for formats that hold their positions too.
HciParameters mean_hci_parameters(const LightField& field, const std::string& where);
/// The parameters as flags would state them.
StatedCameras stated_cameras(const HciParameters& parameters);
/// Around the axis: where the middle camera stands in its scene, and how it is turned, does not matter to views.
ViewCameras hci_cameras(const HciParameters& parameters);

}  // namespace lippmann
