// transforms.json of NeRF's data sets: camera-to-world matrices with Blender's axes, x right, y up, z backwards.
//
// Read: w, h, fl_x, fl_y, cx, cy or camera_angle_x, for all frames or for each; file_path, depth_file_path, transform_matrix
// (4x4 or 3x4). Lens distortion and fisheye cameras are refused.
#pragma once

#include <string>
#include <vector>

#include "layout/posed_folder.hpp"

namespace lippmann {

/// Throws Error naming `where` and the frame for anything that makes no camera.
std::vector<PosedPicture> parse_transforms(const std::string& text, const std::string& where);

/// A transforms.json for pictures whose cameras are complete. Depth files of pictures that name one hold planar depth in
/// thousandths of the matrices' unit, beside ray lengths in depth/NNN_ray.npy. `is_test`, by picture, splits them into lists
/// for training and for testing; empty: no lists.
std::string transforms_text(const std::vector<PosedPicture>& pictures, const std::vector<bool>& is_test = {});

}  // namespace lippmann
