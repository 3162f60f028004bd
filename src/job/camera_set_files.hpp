// Lists the cameras of a data set whose cameras stand around a scene.
#pragma once

#include "folder/render_folder.hpp"
#include "job/render_setup.hpp"

namespace lippmann {

/// Sets the defaults for cameras around the scene: a single view and the format `nerf`. Throws a usage Error for other
/// optics, and for formats other than `nerf`, `colmap` and `llff`.
void complete_camera_set(RenderParams& params);

/// Writes the cameras of all frames in the folder's journal: transforms.json, transforms_train.json and
/// transforms_test.json for `nerf`, sparse/0 for `colmap`, poses_bounds.npy for `llff`. Does nothing without cameras
/// around the scene, or before the first frame is finished.
void write_camera_set_files(const RenderSetup& setup, RenderFolder& folder);

}  // namespace lippmann
