// Reads and writes COLMAP models: cameras, images (with poses) and points3D, as text or binary. Cameras look along +z,
// with x to the right and y down. Poses map the world to the camera: a quaternion w, x, y, z and a translation.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "formats/posed_folder.hpp"

namespace lippmann {

/// Cameras by COLMAP's camera id. Their `position_mm` and `rotation` are not set.
using ColmapCameras = std::map<unsigned, PosedCamera>;

/// Parse cameras. Throw Error for cameras with lens distortion. The Errors of all parsers name `where` and the line or entry.
ColmapCameras parse_colmap_cameras(const std::string& text, const std::string& where);
ColmapCameras parse_colmap_cameras(std::span<const std::byte> binary, const std::string& where);

/// Parse images, sorted by picture name in natural order.
std::vector<PosedPicture> parse_colmap_images(const std::string& text, const ColmapCameras& cameras, const std::string& where);
std::vector<PosedPicture> parse_colmap_images(std::span<const std::byte> binary, const ColmapCameras& cameras,
                                              const std::string& where);

struct ColmapPoints {
  std::vector<CloudPoint> points;
  std::size_t tracks = 0;  ///< number of points with a track, which lists the pictures that show the point
};

/// Parse points. Errors and tracks of points are not kept.
ColmapPoints parse_colmap_points(const std::string& text, const std::string& where);
ColmapPoints parse_colmap_points(std::span<const std::byte> binary, const std::string& where);

/// Return the contents of the files. Pictures with equal intrinsics share one camera entry. Points have no tracks.
std::string colmap_cameras_text(const std::vector<PosedPicture>& pictures);
std::string colmap_images_text(const std::vector<PosedPicture>& pictures);
std::string colmap_points_text(const std::vector<CloudPoint>& cloud);
std::string colmap_cameras_binary(const std::vector<PosedPicture>& pictures);
std::string colmap_images_binary(const std::vector<PosedPicture>& pictures);
std::string colmap_points_binary(const std::vector<CloudPoint>& cloud);

}  // namespace lippmann
