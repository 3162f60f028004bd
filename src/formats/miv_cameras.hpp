// The file cameras.json of MIV and RVS (MPEG immersive video and its view synthesizer). It has one entry per view.
//
// Positions are in metres, in the order forward, left, up. Rotations are yaw, pitch and roll in degrees: from the camera's axes
// to the world's, a rotation about forward by the roll, then about left by the pitch, then about up by the yaw (TMIV). Depth
// codes of b bits are (2^b - 1) (1/z - 1/far) / (1/near - 1/far); code 0 means no surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/formats/formats.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/layout/posed_camera.hpp"

namespace lippmann {

struct MivCamera {
  std::string name;  ///< the view's picture, without extension
  double position_m[3] = {0.0, 0.0, 0.0}, rotation_deg[3] = {0.0, 0.0, 0.0};
  double near_m = 0.1, far_m = 100.0;
  int depth_bits = 16;  ///< of the codes in the depth map
  Vec2i resolution{0, 0};
  Vec2d focal_px{0.0}, principal_point_px{0.0};
};

/// Throws Error naming `where` if the file is malformed, has no or more than 4096 cameras, or if a camera is not
/// perspective, has a path as its name, or has invalid numbers.
std::vector<MivCamera> parse_miv_cameras(const std::string& text, const std::string& where);

/// Returns the contents of cameras.json. `depth`: whether there are depth maps beside the views.
std::string miv_cameras_text(const std::vector<MivCamera>& cameras, const std::string& content, bool depth);

/// Converts a camera of any pose. The view's size is `size`.
PosedCamera posed_camera(const MivCamera& camera, Vec2i size);

/// Reverses posed_camera(). The name and the depth range are not set.
MivCamera miv_camera(const PosedCamera& camera);

/// Sorts parallel cameras by rows from bottom to top, and from left to right within a row. Other cameras keep their order.
void sort_as_views(std::vector<MivCamera>& cameras);

/// Sets field.cameras if all cameras are parallel, have their eyes in one plane and show the same rectangle of another plane.
/// Otherwise sets field.poses. `cameras` must be in view order and not empty.
void set_cameras(const std::vector<MivCamera>& cameras, LightField& field);

/// Warns about a missing camera in a grid. `where`: name of the file or folder with the cameras.
void warn_of_missing_cameras(const std::vector<MivCamera>& cameras, const std::string& where, const FormatOptions& options);

/// Returns the grid of sorted cameras: `views` if it is given, otherwise one row per camera height. If the number of cameras is
/// not a multiple of the number of heights, or if a camera is rotated, returns a single row. Throws a usage Error naming
/// `where` if `views` has a different number of cameras.
ViewGrid grid_of_cameras(const std::vector<MivCamera>& cameras, std::optional<ViewGrid> views, const std::string& where);

/// Converts ViewCameras, whose eyes are all in one plane. near_m, far_m: depth range of all cameras.
std::vector<MivCamera> miv_cameras(const ViewCameras& cameras, Vec2i view_size, const std::vector<std::string>& names,
                                   double near_m, double far_m);

/// Converts the cameras or poses of a light field, which must have either.
std::vector<MivCamera> miv_cameras(const LightField& field, const std::vector<std::string>& names, double near_m, double far_m);

/// Converts cameras in view order to ViewCameras. Returns none unless the cameras are parallel, have their eyes in one
/// plane, and show the same rectangle of another plane.
std::optional<ViewCameras> cameras_of_miv(const std::vector<MivCamera>& cameras);

}  // namespace lippmann
