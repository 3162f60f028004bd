#include "formats/camera_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace lippmann {
namespace {

using CameraJson = nlohmann::ordered_json;

constexpr NumberRange kCameraLength{1e-9, 1e12};

CameraJson point_json(const Vec2d& point) { return {point.x, point.y}; }

}  // namespace

std::vector<Vec2d> points_in(const JsonFields& fields, std::string_view key, int count) {
  const CameraJson& list = fields.value(key);
  if (!list.is_array() || static_cast<int>(list.size()) != count)
    fields.reject(key, "is not a list of one point for each view", fmt::format("{} pairs of numbers", count));
  std::vector<Vec2d> points;
  for (const CameraJson& point : list) {
    const std::vector<double> pair = fields.numbers_in(key, point, 2);
    points.emplace_back(pair[0], pair[1]);
  }
  return points;
}

ViewCameras cameras_in(const JsonFields& fields, int count) {
  ViewCameras cameras;
  cameras.distance_mm = fields.number("distance_mm", kCameraLength);
  cameras.pixel_mm = fields.pair("pixel_mm", kCameraLength);
  cameras.centre_px = fields.pair("centre_px");
  cameras.eyes_mm = points_in(fields, "eyes_mm", count);
  return cameras;
}

CameraJson points_json(const std::vector<Vec2d>& points) {
  CameraJson list = CameraJson::array();
  for (const Vec2d& point : points) list.push_back(point_json(point));
  return list;
}

CameraJson cameras_json(const ViewCameras& cameras) {
  return {{"distance_mm", cameras.distance_mm},
          {"pixel_mm", point_json(cameras.pixel_mm)},
          {"centre_px", point_json(cameras.centre_px)},
          {"eyes_mm", points_json(cameras.eyes_mm)}};
}

}  // namespace lippmann
