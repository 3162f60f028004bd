// Folders of pictures whose cameras stand in a file beside them: nerf, colmap and llff.
//
// Written: images/000.png, ... by view. Lengths in the files are metres; those of a LightField are millimetres.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "layout/posed_cameras.hpp"
#include "lippmann/layout/formats.hpp"

namespace lippmann {

inline constexpr double kMmPerUnit = 1000.0;  ///< of the files

/// A picture as a file of cameras lists it.
struct PosedPicture {
  std::string entry;             ///< its place in the file, for messages: "frames[3]"
  std::string picture, depth;    ///< paths inside the folder; an empty depth: none
  PosedCamera camera;            ///< a size of 0 x 0: as the picture has it
  double angle_x = 0.0;          ///< the horizontal field of view, where the file states no focal length; else 0
  bool has_principal_px = true;  ///< otherwise it is the middle of the picture
};

/// Throws Error naming `where` for a path that is empty, absolute, longer than 1000 characters, or leads out of the folder.
void check_inner_path(const std::string& path, const std::string& where);

/// "images/000.png" of a view, with as many digits as `count` views need, so that names sort as views.
std::string posed_picture_name(int view, int count, const char* ending);

/// "depth/000.npy", and "depth/000_ray.npy" for the lengths of rays beside it.
std::string posed_depth_name(int view, int count);
std::string ray_length_name(const std::string& depth_name);

/// Reads the pictures and arranges them: cameras that share a plane as a grid from the lowest left, others in the order of the
/// file, as one row unless `options` has a grid. `file` is the file that lists them. Throws Error naming it and the entry where
/// a picture is missing or has another size.
LightField read_posed_pictures(const std::filesystem::path& folder, const std::filesystem::path& file,
                               std::vector<PosedPicture> pictures, const FormatOptions& options);

/// Writes images/000.png, ... and returns their paths, by view.
std::vector<std::filesystem::path> write_posed_pictures(const LightField& field, const std::filesystem::path& folder);

/// The length of the ray to the point that each pixel shows, from its planar depth; 0: nothing is there.
Image ray_lengths(const Image& planar_depth, const PosedCamera& camera);

/// Writes planar depth and ray lengths of a view into `folder`, times `scale`: depth/NNN.npy and depth/NNN_ray.npy, whose
/// folder exists. 0: nothing is there.
std::vector<std::filesystem::path> write_posed_depth(const LightField& field, int view, const PosedCamera& camera,
                                                     const std::filesystem::path& folder, const std::string& name,
                                                     double scale = 1.0);

/// A light field of one view as one of the views of a larger set.
struct ViewOfSet {
  int number = 0, count = 1;
  double depth_scale = 1.0;  ///< written depth for a millimetre
};

/// Writes images/NNN.png, and depth as above if there is any. Folders are made. Returns what was written.
std::vector<std::filesystem::path> write_posed_view(const LightField& field, const std::filesystem::path& folder,
                                                    const ViewOfSet& view);

/// A point of the world, seen in a picture.
struct CloudPoint {
  Vec3d position_mm;
  unsigned char rgb[3];
};

/// Every n-th pixel across and down of every view, back-projected by its depth: at most about `most` points. Empty without
/// depth.
std::vector<CloudPoint> point_cloud(const LightField& field, const std::vector<PosedCamera>& cameras, std::size_t most);

/// The least and the greatest planar depth in mm; without depth, 100 mm and 100 m.
Vec2d depth_bounds_mm(const LightField& field);

/// The same of pictures of which write_posed_view wrote all, read one by one.
std::vector<CloudPoint> cloud_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures,
                                          std::size_t most);
Vec2d depth_bounds_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures);

}  // namespace lippmann
