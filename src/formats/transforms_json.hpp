// Reads and writes the file transforms.json of NeRF data sets, which has camera-to-world matrices with Blender's axes (x right,
// y up, z backwards).
//
// These keys are supported: w, h, fl_x, fl_y, cx, cy or camera_angle_x, for all frames or for one frame; file_path,
// depth_file_path, transform_matrix (4x4 or 3x4), time; train_filenames, val_filenames, test_filenames. Lens distortion and
// fisheye cameras are errors. One warning lists other keys, and another one the pictures that no list has.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "formats/posed_folder.hpp"

namespace lippmann {

/// Parses a file. A frame inherits values that it does not state. Throws Error naming `where` and the frame for invalid
/// cameras.
std::vector<PosedPicture> parse_transforms(const std::string& text, const std::string& where,
                                           const std::function<void(std::string_view)>& warn = {});

/// Returns the contents of a transforms.json for pictures with complete cameras. Depth files hold planar depth in thousandths
/// of the unit of the matrices; ray lengths are in depth/NNN_ray.npy. If the pictures have splits, lists of their names are
/// written. If no picture is for validation, the pictures for testing are also listed for validation.
std::string transforms_text(const std::vector<PosedPicture>& pictures);

/// Returns the contents of transforms_train.json, transforms_val.json or transforms_test.json: the pictures of one split. Empty
/// if the split has no pictures. The names of the pictures have no extension, because 3D Gaussian Splatting
/// (readCamerasFromTransforms) and nerfstudio (blender_dataparser) append .png.
std::string split_transforms_text(const std::vector<PosedPicture>& pictures, Split split);

}  // namespace lippmann
