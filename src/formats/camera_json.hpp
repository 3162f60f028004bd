// Cameras and positions of views as JSON, in side files of light fields.
//
//   "positions": [[x, y], ...]
//   "cameras": {"distance_mm": d, "pixel_mm": [w, h], "centre_px": [x, y], "eyes_mm": [[x, y], ...]}
//
// Lists are in the order of the views; x is to the right and y up, as in LightField.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>
#include <vector>

#include "core/json_fields.hpp"
#include "lippmann/layout/light_field.hpp"

namespace lippmann {

/// Read an object of the form above. `count`: number of views. Throw Error naming the file and the key.
std::vector<Vec2d> points_in(const JsonFields& fields, std::string_view key, int count);
ViewCameras cameras_in(const JsonFields& fields, int count);

nlohmann::ordered_json points_json(const std::vector<Vec2d>& points);
nlohmann::ordered_json cameras_json(const ViewCameras& cameras);

}  // namespace lippmann
