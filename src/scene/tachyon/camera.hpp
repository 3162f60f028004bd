// Tachyon's camera: the CAMERA statement, the poses of a camera path, and their conversion to a Camera and its node.
//
// Tachyon samples pixels at their corners instead of their centres. Its columns count from 1 at the left, and its rows from 1
// at the bottom. In an image of W x H pixels, the ray of column x and row y passes through x/W of the width and through y/H of
// the height from the bottom.
//
// Our pixel (i, j) counts from the top left and has its centre at (i + 1/2, j + 1/2). It equals Tachyon's column x = i + 1 and
// row y = H - j, which is sampled at the point (i + 1, j). That point is half a pixel to the right of the centre and half a
// pixel above it. Therefore Camera::pixel_offset = (1/2, -1/2).
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/lexer.hpp"

namespace lippmann::tachyon {

/// A pose in Tachyon's left-handed world. The vectors may have any length.
struct CameraPose {
  Vec3f center{0.0f};
  Vec3f view{0.0f, 0.0f, 1.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};
};

/// A CAMERA statement. The defaults are Tachyon's for a file without this statement.
struct CameraRecord {
  /// Perspective: the image height at distance 1 is 1 / zoom. Orthographic: the image height is 1 / zoom.
  float zoom = 1.0f;
  bool is_orthographic = false;
  float aspect_ratio = 1.0f;  ///< height of a pixel divided by its width
  int ray_depth = 6;          ///< longest path, in vertices
  /// From FRUSTUM: half the image's width and height at distance 1. It replaces zoom and aspect_ratio.
  std::optional<Vec2f> half_extent;
  CameraPose pose;
};

/// Reads the statement after its keyword. Warns about antialiasing, lenses and non-square pixels because render options replace
/// these.
CameraRecord parse_camera(Lexer& lexer, const Context& context);

/// Throws Error at the lexer's line if view or up is zero, or if they are parallel.
void require_orientation(const CameraPose& pose, const Lexer& lexer);

/// Returns the transform of the camera's node, in right-handed coordinates.
Transform node_of(const CameraPose& pose);

/// Returns the camera for a scene that requests an image of `resolution` pixels. Its node is not set.
Camera camera_of(const CameraRecord& record, Vec2i resolution);

}  // namespace lippmann::tachyon
