// Reads and writes NAME_param.txt of cvkit, the Computer Vision Toolkit: the camera of one picture.
//
//   camera.A=[fx 0 cx; 0 fy cy; 0 0 1]    in pixels, from the top left corner of the picture
//   camera.R=[... ; ... ; ...]            R p + T is the world position of a point p in the camera's frame;
//                                         axes: x right, y down, z forward
//   camera.T=[x y z]
//   camera.width=w, camera.height=h
//   rho=f t                               disparity = rho / depth
//
// Positions are in metres, as in the HCI format.
#pragma once

#include <string>

#include "formats/miv_cameras.hpp"

namespace lippmann {

struct CvkitCamera {
  /// The name and the depth range are not set; the resolution is not set if the file lacks width and height.
  MivCamera camera;
  double rho = 0.0;  ///< disparity times depth, in pixels times metres; 0: not given
};

/// Throws Error naming `where` for malformed matrices, skewed cameras, and lens distortion.
CvkitCamera parse_cvkit_camera(const std::string& text, const std::string& where);

std::string cvkit_camera_text(const CvkitCamera& camera);

}  // namespace lippmann
