#pragma once

#include <nlohmann/json.hpp>

namespace lippmann::test {

using Json = nlohmann::ordered_json;

inline Json wrapped(double value) { return {{"value", value}}; }

/// Devices write each number as an object {"value": x}.
inline Json portrait_calibration() {
  return {{"configVersion", "3.0"},        {"serial", "LKG-P12345"},      {"pitch", wrapped(52.5)},
          {"slope", wrapped(-7.25)},       {"center", wrapped(0.125)},    {"viewCone", wrapped(40.0)},
          {"invView", wrapped(1.0)},       {"verticalAngle", wrapped(0)}, {"DPI", wrapped(324.0)},
          {"screenW", wrapped(1536.0)},    {"screenH", wrapped(2048.0)},  {"flipImageX", wrapped(0.0)},
          {"flipImageY", wrapped(0.0)},    {"flipSubp", wrapped(0.0)},    {"fringe", wrapped(0.0)},
          {"subpixelCells", Json::array()}};
}

inline Json cell(double rx, double ry, double gx, double gy, double bx, double by) {
  return {{"ROffsetX", rx}, {"ROffsetY", ry}, {"GOffsetX", gx}, {"GOffsetY", gy}, {"BOffsetX", bx}, {"BOffsetY", by}};
}

}  // namespace lippmann::test
