// Code that the formats nerf, colmap and llff share. Each has folders of pictures with a camera file.
//
// Pictures are written as images/000.png, ..., one per view. Lengths are in metres in the files and in millimetres in a
// LightField.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "layout/posed_cameras.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

inline constexpr double kMmPerUnit = 1000.0;  ///< the files store lengths in metres

/// A picture that a camera file lists.
struct PosedPicture {
  std::string entry;           ///< position of the entry in the file, for messages: "frames[3]"
  std::string picture, depth;  ///< paths relative to the folder; `depth` is empty if there is no depth file
  PosedCamera camera;          ///< its size is 0 x 0 if the picture determines it
  /// Horizontal field of view if the file has no focal length; otherwise 0.
  double angle_x = 0.0;
  bool has_principal_px = true;  ///< false: the principal point is in the middle of the picture
};

/// Throws Error naming `where` if a path is empty, absolute, longer than 1000 characters, or leads outside the folder.
void check_inner_path(const std::string& path, const std::string& where);

/// Returns "images/000.png" for a view. The number has enough digits for `count` views, so that names sort in the order of the
/// views.
std::string posed_picture_name(int view, int count, const char* ending);

/// Return "depth/000.npy", and the name of the file with ray lengths beside it, "depth/000_ray.npy".
std::string posed_depth_name(int view, int count);
std::string ray_length_name(const std::string& depth_name);

/// Reads the pictures and arranges them as views. Parallel cameras whose views show the same rectangle of a plane become a
/// grid, starting at the lower left. Other cameras stay in file order, as one row unless `options` has a grid. `file` is the
/// camera file. Throws Error naming this file and the entry if a picture is missing or has another size than the entry states.
LightField read_posed_pictures(const std::filesystem::path& folder, const std::filesystem::path& file,
                               std::vector<PosedPicture> pictures, const FormatOptions& options);

/// Writes images/000.png, ... and returns their paths, one per view.
std::vector<std::filesystem::path> write_posed_pictures(const LightField& field, const std::filesystem::path& folder);

/// Converts planar depth to the length of the ray through each pixel. 0 means no surface.
Image ray_lengths(const Image& planar_depth, const PosedCamera& camera);

/// Writes the planar depth and the ray lengths of a view, both multiplied by `scale`, to depth/NNN.npy and depth/NNN_ray.npy in
/// `folder`. The folder `depth` in it must exist. 0 means no surface.
std::vector<std::filesystem::path> write_posed_depth(const LightField& field, int view, const PosedCamera& camera,
                                                     const std::filesystem::path& folder, const std::string& name,
                                                     double scale = 1.0);

/// Describes a light field with a single view as a part of a larger set of views.
struct ViewOfSet {
  int number = 0, count = 1;
  double depth_scale = 1.0;  ///< factor by which depths are multiplied in the files
};

/// Writes images/NNN.png and, if the light field has depth, the files of write_posed_depth(). Creates folders. Returns the
/// paths of the files written.
std::vector<std::filesystem::path> write_posed_view(const LightField& field, const std::filesystem::path& folder,
                                                    const ViewOfSet& view);

struct CloudPoint {
  Vec3d position_mm;
  unsigned char rgb[3];
};

/// Converts pixels to points in the world by their depth. Takes every n-th pixel across and down of every view, with n such
/// that there are at most about `most` points. Returns no points if there is no depth.
std::vector<CloudPoint> point_cloud(const LightField& field, const std::vector<PosedCamera>& cameras, std::size_t most);

/// Returns the least and the greatest planar depth in mm. If there is no depth, returns 100 mm and 100 m.
Vec2d depth_bounds_mm(const LightField& field);

/// Return the same as point_cloud() and depth_bounds_mm() for the pictures that write_posed_view() wrote. The pictures are read
/// one by one.
std::vector<CloudPoint> cloud_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures,
                                          std::size_t most);
Vec2d depth_bounds_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures);

}  // namespace lippmann
