// Tachyon's camera: the CAMERA statement, the poses of a camera path, and their conversion to a Camera and its node.
//
// Tachyon samples pixels at their corners. Its columns count from 1 at the left, and its rows from 1 at the bottom. In an image
// of W x H pixels, the ray of column x and row y passes through x/W of the width and through y/H of the height from the bottom.
//
// Our pixel (i, j) counts from the top left and has its centre at (i + 1/2, j + 1/2). It equals Tachyon's column x = i + 1 and
// row y = H - j, which is sampled at the point (i + 1, j). Therefore Camera::pixel_offset = (1/2, -1/2).
#pragma once

#include <optional>

#include "lippmann/core/context.hpp"
#include "lippmann/scene/scene.hpp"
#include "scene/lexer.hpp"

namespace lippmann::tachyon {

struct CameraPose {
  Vec3f center{0.0f};
  Vec3f view{0.0f, 0.0f, 1.0f};
  Vec3f up{0.0f, 1.0f, 0.0f};
};

struct CameraRecord {
  /// The image height is 1 / zoom. Perspective cameras measure the height in the plane at distance 1.
  float zoom = 1.0f;
  bool is_orthographic = false;
  float aspect_ratio = 1.0f;
  int ray_depth = 6;
  /// From FRUSTUM: half the image's width and height at distance 1. It replaces zoom and aspect_ratio.
  std::optional<Vec2f> half_extent;
  CameraPose pose;
};

/// Warns about antialiasing, lenses and non-square pixels because render options replace these.
CameraRecord parse_camera(Lexer& lexer, const Context& context);

void require_orientation(const CameraPose& pose, const Lexer& lexer);

Transform node_of(const CameraPose& pose);

Camera camera_of(const CameraRecord& record, Vec2i resolution);

}  // namespace lippmann::tachyon
