// Tachyon's camera: the CAMERA statement, the poses of a camera path, and what they are as our Camera and its node.
//
// Pixels. Tachyon counts columns from 1 on the left and rows from 1 at the bottom, and the ray of column x and row y of a
// W x H picture runs through x/W of its width and y/H of its height from the bottom: no half pixel. In our coordinates, where
// pixel (i, j) from the top left has its centre at (i + 1/2, j + 1/2), column x = i + 1 samples at i + 1 and row y = H - j at
// H - y = j: half a pixel further right and half a pixel further up, which is Camera::pixel_offset = (1/2, -1/2).
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/lexer.hpp"

namespace lippmann::tachyon {

/// In Tachyon's left-handed world; vectors of any length.
struct CameraPose {
  Vec3f center{0.0f};
  Vec3f view{0.0f, 0.0f, 1.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};
};

/// A CAMERA statement; the defaults are Tachyon's for a scene without one.
struct CameraRecord {
  float zoom = 1.0f;  ///< the picture is 1 / zoom high at distance 1, or everywhere if orthographic
  bool is_orthographic = false;
  float aspect_ratio = 1.0f;         ///< pixels are this much narrower than high
  int ray_depth = 6;                 ///< path vertices
  std::optional<Vec2f> half_extent;  ///< half the picture's size at distance 1, instead of zoom and aspect_ratio (FRUSTUM)
  CameraPose pose;
};

/// Reads what follows CAMERA. Warns about antialiasing, lenses and pixels that are not square, which are the render's choice
/// here.
CameraRecord parse_camera(Lexer& lexer, const Context& context);

/// Throws Error at the lexer's line for a pose that looks nowhere: view or up zero, or parallel.
void require_orientation(const CameraPose& pose, const Lexer& lexer);

/// The camera's node in our world.
Transform node_of(const CameraPose& pose);

/// The camera, without its node, for a scene that asks for `resolution` pixels.
Camera camera_of(const CameraRecord& record, Vec2i resolution);

}  // namespace lippmann::tachyon
