// Common parts of the formats nerf, colmap and llff: folders of pictures with a camera file.
//
// Pictures are written as images/000.png, ... by view. Lengths are metres in the files and millimetres in a LightField.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "layout/posed_cameras.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

inline constexpr double kMmPerUnit = 1000.0;  ///< unit of the files

/// A picture as listed in a camera file.
struct PosedPicture {
  std::string entry;             ///< position in the file, for messages: "frames[3]"
  std::string picture, depth;    ///< paths inside the folder; empty depth: none
  PosedCamera camera;            ///< size 0 x 0: from the picture
  double angle_x = 0.0;          ///< horizontal field of view if the file has no focal length; else 0
  bool has_principal_px = true;  ///< false: the middle of the picture
};

/// Throws Error naming `where` if a path is empty, absolute, longer than 1000 characters, or leads outside the folder.
void check_inner_path(const std::string& path, const std::string& where);

/// Returns "images/000.png" for a view, with enough digits for `count` views, so that names sort as views.
std::string posed_picture_name(int view, int count, const char* ending);

/// Return "depth/000.npy", and "depth/000_ray.npy" for the ray lengths beside it.
std::string posed_depth_name(int view, int count);
std::string ray_length_name(const std::string& depth_name);

/// Reads the pictures and arranges them: cameras that share a plane as a grid from the lower left; others in file order, as one
/// row unless `options` has a grid. `file` is the camera file. Throws Error naming it and the entry if a picture is missing or
/// has another size.
LightField read_posed_pictures(const std::filesystem::path& folder, const std::filesystem::path& file,
                               std::vector<PosedPicture> pictures, const FormatOptions& options);

/// Writes images/000.png, ... and returns the paths by view.
std::vector<std::filesystem::path> write_posed_pictures(const LightField& field, const std::filesystem::path& folder);

/// Converts planar depth to the length of the ray through each pixel; 0: no surface.
Image ray_lengths(const Image& planar_depth, const PosedCamera& camera);

/// Writes planar depth and ray lengths of a view, multiplied by `scale`, to depth/NNN.npy and depth/NNN_ray.npy in `folder`.
/// The folder depth must exist. 0 means no surface.
std::vector<std::filesystem::path> write_posed_depth(const LightField& field, int view, const PosedCamera& camera,
                                                     const std::filesystem::path& folder, const std::string& name,
                                                     double scale = 1.0);

/// The place of a single-view light field in a larger set.
struct ViewOfSet {
  int number = 0, count = 1;
  double depth_scale = 1.0;  ///< factor of depths in the files
};

/// Writes images/NNN.png and, if there is any, depth as above. Creates folders. Returns the files written.
std::vector<std::filesystem::path> write_posed_view(const LightField& field, const std::filesystem::path& folder,
                                                    const ViewOfSet& view);

/// A coloured point in the world.
struct CloudPoint {
  Vec3d position_mm;
  unsigned char rgb[3];
};

/// Back-projects every n-th pixel across and down of every view by its depth, to about `most` points at most. Empty without
/// depth.
std::vector<CloudPoint> point_cloud(const LightField& field, const std::vector<PosedCamera>& cameras, std::size_t most);

/// Returns the least and the greatest planar depth in mm; without depth, 100 mm and 100 m.
Vec2d depth_bounds_mm(const LightField& field);

/// Do the same for pictures written by write_posed_view(), reading them one by one.
std::vector<CloudPoint> cloud_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures,
                                          std::size_t most);
Vec2d depth_bounds_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures);

}  // namespace lippmann
