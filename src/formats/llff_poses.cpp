#include "formats/llff_poses.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/npy.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

constexpr std::size_t kColumns = 17;

PosedPicture picture_from_row(std::span<const double> row, const std::string& entry, const std::string& where) {
  constexpr double kMost = 1e9, kMostSide = 65536.0;
  const std::string place = where + ": " + entry;
  for (const double value : row)
    if (!(std::abs(value) <= kMost)) throw Error(place, fmt::format("has the number {}", value), "numbers up to 1e9");
  PosedPicture picture;
  picture.entry = place;
  picture.depth_bounds_mm = kMmPerUnit * Vec2d(row[15], row[16]);
  PosedCamera& camera = picture.camera;
  double rotation[9];
  for (std::size_t i = 0; i < 3; ++i) {
    const double *down = &row[5 * i], *right = down + 1, *back = down + 2, *position = down + 3;
    rotation[3 * i] = *right, rotation[3 * i + 1] = -*down, rotation[3 * i + 2] = *back;
    camera.position_mm[static_cast<int>(i)] = kMmPerUnit * *position;
  }
  camera.rotation = checked_rotation(rotation, place);
  const double height = row[4], width = row[9], focal = row[14];
  for (const double side : {height, width})
    if (!(side >= 1.0 && side <= kMostSide) || side != std::floor(side))
      throw Error(place, fmt::format("its picture has {}x{} pixels", width, height), "whole numbers up to 65536");
  if (!(focal >= 1e-3)) throw Error(place, fmt::format("its focal length is {} pixels", focal), "a number above 0");
  if (!(row[15] > 0.0 && row[15] <= row[16]))
    throw Error(place, fmt::format("its depths reach from {} to {}", row[15], row[16]),
                "the nearest depth, above 0, then the farthest");
  camera.size = {static_cast<int>(width), static_cast<int>(height)};
  camera.focal_px = Vec2d(focal);
  camera.principal_px = 0.5 * Vec2d(camera.size);
  return picture;
}

void check_llff(const PosedCamera& camera, std::size_t view, const std::string& where) {
  constexpr double kTolerance_px = 1e-3;
  const Vec2d off = camera.principal_px - 0.5 * Vec2d(camera.size);
  if (std::abs(camera.focal_px.x / camera.focal_px.y - 1.0) > 1e-6)
    throw Error(where, fmt::format("the pixels of view {} are not square, but the format llff requires square pixels", view),
                "the format nerf or colmap");
  if (std::max(std::abs(off.x), std::abs(off.y)) > kTolerance_px)
    throw Error(
        where,
        fmt::format("the axis of view {} is {:.4g} x {:.4g} pixels away from the middle of its picture, which the format "
                    "llff cannot express",
                    view, off.x, off.y),
        "the format nerf or colmap, or a render with `cameras`");
}

}  // namespace

std::vector<PosedPicture> parse_llff_poses(std::span<const std::byte> file, const std::string& where) {
  constexpr std::size_t kMostRows = 65536;
  const NpyArray array = parse_npy(file, where);
  if (array.shape.size() != 2 || array.shape[1] != kColumns || array.shape[0] < 1 || array.shape[0] > kMostRows)
    throw Error(where, "does not have rows of 17 numbers", fmt::format("1 to {} rows", kMostRows));
  std::vector<PosedPicture> pictures;
  for (std::size_t i = 0; i < array.shape[0]; ++i)
    pictures.push_back(
        picture_from_row(std::span(array.values).subspan(i * kColumns, kColumns), fmt::format("row {}", i), where));
  return pictures;
}

std::vector<std::byte> encode_llff_poses(const std::vector<PosedCamera>& cameras, const std::vector<Vec2d>& bounds_mm,
                                         const std::string& where) {
  std::vector<double> values;
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    const PosedCamera& camera = cameras[view];
    check_llff(camera, view, where);
    const double size_and_focal[] = {static_cast<double>(camera.size.y), static_cast<double>(camera.size.x), camera.focal_px.x};
    for (int i = 0; i < 3; ++i)
      for (const double value : {-camera.rotation[1][i] + 0.0, camera.rotation[0][i], camera.rotation[2][i],
                                 camera.position_mm[i] / kMmPerUnit, size_and_focal[i]})
        values.push_back(value);
    values.push_back(bounds_mm[view].x / kMmPerUnit), values.push_back(bounds_mm[view].y / kMmPerUnit);
  }
  return encode_npy(std::span<const double>(values), {cameras.size(), kColumns});
}

}  // namespace lippmann
