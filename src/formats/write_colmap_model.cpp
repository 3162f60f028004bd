// Based on: COLMAP's documentation, "Output Format".
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "formats/colmap_model.hpp"

namespace lippmann {
namespace {

bool same_lens(const PosedCamera& a, const PosedCamera& b) {
  return a.size == b.size && a.focal_px == b.focal_px && a.principal_px == b.principal_px;
}

/// The distinct intrinsics in the order of the pictures, and for each picture the index of its intrinsics.
struct SharedLenses {
  std::vector<PosedCamera> lenses;
  std::vector<std::size_t> of_picture;
};

SharedLenses shared_lenses(const std::vector<PosedPicture>& pictures) {
  SharedLenses shared;
  for (const PosedPicture& picture : pictures) {
    const auto found = std::find_if(shared.lenses.begin(), shared.lenses.end(),
                                    [&](const PosedCamera& lens) { return same_lens(lens, picture.camera); });
    shared.of_picture.push_back(static_cast<std::size_t>(found - shared.lenses.begin()));
    if (found == shared.lenses.end()) shared.lenses.push_back(picture.camera);
  }
  return shared;
}

/// COLMAP's pose: a rotation and a translation from the world to the camera, in the files' unit.
struct ColmapPose {
  glm::dquat rotation;
  Vec3d translation;
};

ColmapPose colmap_pose(const PosedCamera& camera) {
  const glm::dmat3 world_from_colmap(camera.rotation[0], -camera.rotation[1], -camera.rotation[2]);
  const glm::dmat3 colmap_from_world = glm::transpose(world_from_colmap);
  return {glm::normalize(glm::quat_cast(colmap_from_world)), -(colmap_from_world * camera.position_mm) / kMmPerUnit + 0.0};
}

template <class... Values>
void put(std::string& bytes, Values... values) {
  (bytes.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
}

}  // namespace

std::string colmap_cameras_text(const std::vector<PosedPicture>& pictures) {
  std::string text = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
  unsigned id = 0;
  for (const PosedCamera& lens : shared_lenses(pictures).lenses)
    text += fmt::format("{} PINHOLE {} {} {} {} {} {}\n", ++id, lens.size.x, lens.size.y, lens.focal_px.x, lens.focal_px.y,
                        lens.principal_px.x, lens.principal_px.y);
  return text;
}

std::string colmap_cameras_binary(const std::vector<PosedPicture>& pictures) {
  constexpr std::int32_t kPinhole = 1;
  const std::vector<PosedCamera> lenses = shared_lenses(pictures).lenses;
  std::string bytes;
  put(bytes, std::uint64_t{lenses.size()});
  std::uint32_t id = 0;
  for (const PosedCamera& lens : lenses) {
    put(bytes, ++id, kPinhole, static_cast<std::uint64_t>(lens.size.x), static_cast<std::uint64_t>(lens.size.y));
    put(bytes, lens.focal_px.x, lens.focal_px.y, lens.principal_px.x, lens.principal_px.y);
  }
  return bytes;
}

std::string colmap_images_text(const std::vector<PosedPicture>& pictures) {
  const SharedLenses shared = shared_lenses(pictures);
  std::string text = "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, POINT3D_ID)\n";
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto [q, t] = colmap_pose(pictures[i].camera);
    text += fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", i + 1, q.w, q.x, q.y, q.z, t.x, t.y, t.z, shared.of_picture[i] + 1,
                        pictures[i].picture);
  }
  return text;
}

std::string colmap_images_binary(const std::vector<PosedPicture>& pictures) {
  const SharedLenses shared = shared_lenses(pictures);
  std::string bytes;
  put(bytes, std::uint64_t{pictures.size()});
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto [q, t] = colmap_pose(pictures[i].camera);
    put(bytes, static_cast<std::uint32_t>(i + 1), q.w, q.x, q.y, q.z, t.x, t.y, t.z);
    put(bytes, static_cast<std::uint32_t>(shared.of_picture[i] + 1));
    bytes.append(pictures[i].picture.c_str(), pictures[i].picture.size() + 1);
    put(bytes, std::uint64_t{0});  // number of image points
  }
  return bytes;
}

std::string colmap_points_text(const std::vector<CloudPoint>& cloud) {
  std::string text = "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[] as (IMAGE_ID, POINT2D_IDX)\n";
  std::size_t id = 0;
  for (const CloudPoint& point : cloud) {
    const Vec3d p = point.position_mm / kMmPerUnit;
    text += fmt::format("{} {:.9g} {:.9g} {:.9g} {} {} {} 0\n", ++id, p.x, p.y, p.z, point.rgb[0], point.rgb[1], point.rgb[2]);
  }
  return text;
}

std::string colmap_points_binary(const std::vector<CloudPoint>& cloud) {
  std::string bytes;
  put(bytes, std::uint64_t{cloud.size()});
  std::uint64_t id = 0;
  for (const CloudPoint& point : cloud) {
    const Vec3d p = point.position_mm / kMmPerUnit;
    put(bytes, ++id, p.x, p.y, p.z, point.rgb[0], point.rgb[1], point.rgb[2], 0.0, std::uint64_t{0});
  }
  return bytes;
}

}  // namespace lippmann
