// The file parameters.cfg of the 4D light field benchmark (HCI): cameras and their disparities.
//
// The cameras are parallel, with baseline b, focal length f, and a sensor whose longer side has size s and n pixels. Pictures
// are shifted so that points at the focus distance F have no disparity. A point at planar depth Z moves by
//   d = (beta F / Z - beta) / (F s),   beta = b f n    pixels from camera to camera (lengths in mm).
// If the point is nearer than F, it moves left as the camera moves right. Our off-axis views through one rectangle in the
// plane z = 0 follow the same model: F is the distance of the cameras from that plane, and F s / f is the longer side of
// the rectangle.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

struct HciParameters {
  double focal_length_mm = 100.0, sensor_size_mm = 35.0;
  int width = 0, height = 0;  ///< size of a view in pixels
  int columns = 1, rows = 1;
  double baseline_mm = 0.0, focus_distance_m = 1.0;
  HciNotes notes = {};  ///< without a centre camera, it stands on the display's axis, at the focus distance
};

/// Throws Error naming `where` for missing keys, malformed numbers and invalid cameras.
HciParameters parse_hci_parameters(const std::string& text, const std::string& where);
std::string hci_parameters_text(const HciParameters& parameters);

/// Reads FOLDER/parameters.cfg; none if it does not exist. Throws Error naming the file.
std::optional<HciParameters> read_hci_parameters(const std::filesystem::path& folder);
/// Throws Error naming FOLDER/parameters.cfg if `size`, the size of a view's picture, differs from the size in `parameters`.
void require_size(const HciParameters& parameters, const std::filesystem::path& picture, Vec2i size);
/// Writes FOLDER/parameters.cfg and returns its path.
std::filesystem::path write_hci_parameters(const std::filesystem::path& folder, const HciParameters& parameters);

/// Disparity between neighbouring cameras in pixels, positive for points nearer than the focus distance. depth_m:
/// planar depth > 0; may be inf.
double hci_disparity_px(const HciParameters& parameters, double depth_m);
/// The inverse of hci_disparity_px(). Returns infinity for disparities that no depth > 0 has.
double hci_depth_m(const HciParameters& parameters, double disparity_px);

/// Returns the parameters of the views' cameras, with sensors 35 mm wide, and the notes of the field. Throws Error naming
/// `where` if the format cannot express the cameras: non-uniform eye distances or non-square pixels.
HciParameters hci_parameters(const LightField& field, const std::string& where);
/// Returns parameters with the mean distance between neighbouring eyes, for formats that also store each eye's position.
HciParameters mean_hci_parameters(const LightField& field, const std::string& where);
StatedCameras stated_cameras(const HciParameters& parameters);
/// Cameras centred on the display's axis. HciNotes have the pose of the middle camera in its scene.
ViewCameras hci_cameras(const HciParameters& parameters);

}  // namespace lippmann
