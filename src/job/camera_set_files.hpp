// The files of a data set of cameras around a scene: what no frame can write alone, because it lists all of them.
#pragma once

#include "folder/render_folder.hpp"
#include "job/render_setup.hpp"

namespace lippmann {

/// Fills in what a job with cameras around the scene takes for granted: a single view, and the format `nerf`. Throws a usage
/// Error for other optics and formats.
void complete_camera_set(RenderParams& params);

/// Writes the cameras of the frames that the folder's journal holds, in the format of the job: transforms.json with
/// transforms_train.json and transforms_test.json, sparse/0, or poses_bounds.npy. Nothing for jobs without such cameras, or
/// before the first frame.
void write_camera_set_files(const RenderSetup& setup, RenderFolder& folder);

}  // namespace lippmann
