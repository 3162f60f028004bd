// The file transforms.json of NeRF data sets: camera-to-world matrices with Blender's axes (x right, y up, z backwards).
//
// Supported keys: w, h, fl_x, fl_y, cx, cy or camera_angle_x, global or per frame; file_path, depth_file_path, transform_matrix
// (4x4 or 3x4). Lens distortion and fisheye cameras are errors.
#pragma once

#include <string>
#include <vector>

#include "layout/posed_folder.hpp"

namespace lippmann {

/// Parses a file. Throws Error naming `where` and the frame for invalid cameras.
std::vector<PosedPicture> parse_transforms(const std::string& text, const std::string& where);

/// Returns the contents of a transforms.json for pictures with complete cameras. Depth files hold planar depth in thousandths
/// of the matrices' unit, with ray lengths in depth/NNN_ray.npy. `is_test`, by picture, splits the pictures into lists for
/// training and testing; empty: no lists.
std::string transforms_text(const std::vector<PosedPicture>& pictures, const std::vector<bool>& is_test = {});

}  // namespace lippmann
