// Tachyon's camera: the CAMERA statement, the poses of a camera path, and their conversion to a Camera and its node.
//
// Sampling positions: Tachyon counts columns from 1 at the left and rows from 1 at the bottom. The ray of column x and row y of
// a W x H image passes through x/W of its width and y/H of its height from the bottom, without a half-pixel offset. In our
// coordinates, pixel (i, j) from the top left has its centre at (i + 1/2, j + 1/2), so column x = i + 1 samples at i + 1 and
// row y = H - j at H - y = j. That is half a pixel right and up, or Camera::pixel_offset = (1/2, -1/2).
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/lexer.hpp"

namespace lippmann::tachyon {

/// A pose in Tachyon's left-handed world; vectors may have any length.
struct CameraPose {
  Vec3f center{0.0f};
  Vec3f view{0.0f, 0.0f, 1.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};
};

/// A CAMERA statement. The defaults are those of Tachyon for a scene without a CAMERA statement.
struct CameraRecord {
  float zoom = 1.0f;  ///< the image height is 1 / zoom at distance 1, or everywhere if orthographic
  bool is_orthographic = false;
  float aspect_ratio = 1.0f;         ///< height of a pixel divided by its width
  int ray_depth = 6;                 ///< path vertices
  std::optional<Vec2f> half_extent;  ///< FRUSTUM: half the image size at distance 1; replaces zoom and aspect_ratio
  CameraPose pose;
};

/// Reads a statement after its keyword. Warns about antialiasing, lenses and non-square pixels, which render options control.
CameraRecord parse_camera(Lexer& lexer, const Context& context);

/// Throws Error at the lexer's line if view or up is zero, or both are parallel.
void require_orientation(const CameraPose& pose, const Lexer& lexer);

/// Returns the camera's node in our world.
Transform node_of(const CameraPose& pose);

/// Returns the camera, without its node, for a scene that requests `resolution` pixels.
Camera camera_of(const CameraRecord& record, Vec2i resolution);

}  // namespace lippmann::tachyon
