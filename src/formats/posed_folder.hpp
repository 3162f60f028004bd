// Code that the formats nerf, colmap and llff share: folders of pictures, images/000.png, ..., with a camera file.
// Lengths are in metres in the files and in millimetres in a LightField.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "layout/posed_cameras.hpp"
#include "lippmann/formats/formats.hpp"

namespace lippmann {

inline constexpr double kMmPerUnit = 1000.0;  ///< the files store metres

struct PosedPicture {
  std::string entry;           ///< the file and the position of the entry in it, for messages: "transforms.json: frames[3]"
  std::string picture, depth;  ///< paths relative to the folder; `depth` is empty if there is no depth file
  /// Values that the file does not state are 0, except for the principal point, which is NaN. read_posed_pictures() replaces
  /// them: the size by that of the picture, the principal point by the middle of the picture, focal_px.x by the focal length
  /// that follows from `angle_x`, and focal_px.y by focal_px.x.
  PosedCamera camera;
  double angle_x = 0.0;                       ///< horizontal field of view; 0: not stated
  std::optional<Vec2d> depth_bounds_mm = {};  ///< nearest and farthest depth
  std::optional<Split> split = {};
  std::optional<double> time = {};
};

/// The contents of a camera file.
struct PosedSet {
  std::filesystem::path file;  ///< for messages
  std::vector<PosedPicture> pictures;
  std::vector<CloudPoint> points = {};
};

/// Throws Error naming `where` if a path is empty, absolute, longer than 1000 characters, or leads outside the folder.
void check_inner_path(const std::string& path, const std::string& where);

/// Returns "images/000.png", with enough digits for `count` views, so that names sort in the order of the views.
std::string posed_picture_name(int view, int count, const char* ending);

/// Return "depth/000.npy", and the file with ray lengths beside it, "depth/000_ray.npy".
std::string posed_depth_name(int view, int count);
std::string ray_length_name(const std::string& depth_name);

/// Reads the pictures and arranges them as views. Parallel cameras whose views show the same rectangle of a plane become a
/// grid, starting at the lower left. Other cameras stay in file order, as one row unless `options` has a grid. Depth files are
/// .npy arrays or 16-bit PNG files, in thousandths of the file's unit. Throws Error naming the entry if a picture is missing or
/// has another size than the entry states.
LightField read_posed_pictures(const std::filesystem::path& folder, PosedSet set, const FormatOptions& options);

/// Returns the entries of the views for a camera file: names images/000.png, ..., cameras and splits, without depth files.
/// Throws Error naming `folder` if the cameras are unknown.
std::vector<PosedPicture> listed_pictures(const LightField& field, const std::filesystem::path& folder);

/// Returns the path of a picture. Some programs omit the extension: "./train/r_0" is r_0.png. Throws Error naming the entry if
/// the file is missing.
std::filesystem::path path_of_picture(const std::filesystem::path& folder, const PosedPicture& picture);

struct SplitList {
  Split split = Split::kTraining;
  std::vector<std::string> names = {};
};

/// Sets the splits of pictures by lists of their names. If two lists have a name, the first list counts. Pictures in no list
/// are for training. Warns about names without a picture. `where`: the file, for the message.
void set_splits(const std::vector<SplitList>& lists, std::vector<PosedPicture>& pictures, const std::string& where,
                const std::function<void(std::string_view)>& warn);

/// Writes images/000.png, ... and returns their paths, one per view.
std::vector<std::filesystem::path> write_posed_pictures(const LightField& field, const std::filesystem::path& folder);

/// Returns the pictures of one part of the data set, such as those for training. Their `split` is reset.
std::vector<PosedPicture> pictures_of_split(const std::vector<PosedPicture>& pictures, Split split);

/// The file test.txt beside COLMAP's and LLFF's cameras lists the names of the pictures that are not for training, one per
/// line. held_out_names() returns its contents. read_held_out_names() calls set_splits() if the file exists and lists a
/// picture.
std::string held_out_names(const std::vector<PosedPicture>& pictures);
void write_held_out_names(const std::filesystem::path& file, const std::vector<PosedPicture>& pictures);
void read_held_out_names(const std::filesystem::path& file, std::vector<PosedPicture>& pictures,
                         const std::function<void(std::string_view)>& warn);

/// Converts planar depth to the length of the ray through each pixel. 0 means no surface.
Image ray_lengths(const Image& planar_depth, const PosedCamera& camera);

/// Writes the planar depth and the ray lengths of a view, times `scale`, to depth/NNN.npy and depth/NNN_ray.npy in
/// `folder`, whose folder `depth` must exist. 0 means no surface.
std::vector<std::filesystem::path> write_posed_depth(const LightField& field, int view, const PosedCamera& camera,
                                                     const std::filesystem::path& folder, const std::string& name,
                                                     double scale = 1.0);

/// The place of a light field with a single view in a larger set: view `number` of `count` views.
struct ViewOfSet {
  int number = 0, count = 1;
  double depth_scale = 1.0;  ///< factor by which depths in the files are multiplied
};

/// Writes images/NNN.png and, if the light field has depth, the files of write_posed_depth(). Returns the paths of the
/// files written.
std::vector<std::filesystem::path> write_posed_view(const LightField& field, const std::filesystem::path& folder,
                                                    const ViewOfSet& view);

/// Converts pixels to points in the world by their depth. Takes every n-th pixel across and down of every view, with n such
/// that there are at most about `most` points. Returns no points if there is no depth.
std::vector<CloudPoint> point_cloud(const LightField& field, const std::vector<PosedCamera>& cameras, std::size_t most);

/// Returns the least and the greatest planar depth in mm, or 100 mm and 100 m if the light field has no depth.
Vec2d depth_bounds_mm(const LightField& field);

/// Like point_cloud() and depth_bounds_mm(), for pictures that write_posed_view() wrote. Read one picture at a time.
std::vector<CloudPoint> cloud_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures,
                                          std::size_t most);
Vec2d depth_bounds_of_pictures(const std::filesystem::path& folder, const std::vector<PosedPicture>& pictures);

}  // namespace lippmann
