// NAME_param.txt of cvkit, the Computer Vision Toolkit: the camera of one picture.
//
//   camera.A=[fx 0 cx; 0 fy cy; 0 0 1]    pixels, from the top left corner of the picture
//   camera.R=[1 0 0; 0 1 0; 0 0 1]        a point of the world is R p + T: x right, y down, z forward
//   camera.T=[x y z]
//   camera.width=w, camera.height=h
//   rho=f t                               disparity = rho / depth
//
// Positions are in metres, as in the HCI format.
#pragma once

#include <string>

#include "layout/miv_cameras.hpp"

namespace lippmann {

struct CvkitCamera {
  MivCamera camera;  ///< without name and range, and without resolution if width and height are missing
  double rho = 0.0;  ///< pixels times metres; 0: not given
};

/// Parses a camera file. Throws Error naming `where` for malformed matrices, skewed or rotated cameras, and lens distortion.
CvkitCamera parse_cvkit_camera(const std::string& text, const std::string& where);

std::string cvkit_camera_text(const CvkitCamera& camera);

}  // namespace lippmann
