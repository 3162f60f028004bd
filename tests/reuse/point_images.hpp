// Makes point images (depth, object and colour of each pixel's first hit) and motions by hand.
#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"
#include "reuse/motion.hpp"
#include "reuse/point_image.hpp"

namespace lippmann::test {

inline PointImage empty_points(const Panel& panel) {
  const auto pixels = static_cast<std::size_t>(panel.width) * static_cast<std::size_t>(panel.height);
  PointImage image;
  image.points.z.assign(pixels, kMissedDepth);
  image.points.object.assign(pixels, kMissedObject);
  image.film = Image(panel.width, panel.height, 3);
  for (std::size_t p = 0; p < pixels; ++p) image.film.data[3 * p] = static_cast<float>(p);
  return image;
}

inline void set_point(PointImage& image, std::size_t pixel, float z, std::uint32_t object = 0) {
  image.points.z[pixel] = z;
  image.points.object[pixel] = object;
}

inline GroupMotion group_motion(const Affine3f& a) {
  GroupMotion motion;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) motion.rows[static_cast<std::size_t>(4 * r + c)] = a.linear[c][r];
    motion.rows[static_cast<std::size_t>(4 * r + 3)] = a.translation[r];
  }
  motion.still = a == Affine3f{};
  return motion;
}

/// Object i moves by transform i, in mm of the display. Cannot be copied or moved, because it points into itself.
struct KnownMotion {
  std::vector<std::uint32_t> group_of_object;
  Motion motion;

  explicit KnownMotion(const std::vector<Affine3f>& of_objects) {
    for (const Affine3f& a : of_objects) {
      group_of_object.push_back(static_cast<std::uint32_t>(group_of_object.size()));
      motion.groups.push_back(group_motion(a));
    }
    motion.group_of_object = &group_of_object;
  }
  KnownMotion(const KnownMotion&) = delete;
  KnownMotion& operator=(const KnownMotion&) = delete;
};

inline Affine3f shift(float x, float y, float z) { return {Mat3f(1.0f), Vec3f(x, y, z)}; }

inline Vec2f centre_of(const Optics& optics, std::uint32_t pixel) {
  const auto width = static_cast<std::uint32_t>(film_size(optics).x);
  return {static_cast<float>(pixel % width) + 0.5f, static_cast<float>(pixel / width) + 0.5f};
}

}  // namespace lippmann::test
