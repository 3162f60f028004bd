// The coding of depth as grey levels in RGB-D pictures.
#pragma once

namespace lippmann {

struct DepthRange {
  double near_mm = 10.0, far_mm = -30.0;  ///< z in the display frame, above 0 in front of the screen; far < near

  bool operator==(const DepthRange&) const = default;
};

enum class DepthScale { kDisparity, kDepth };

struct DepthCoding {
  DepthRange range{};
  bool even_in_depth = false;  ///< true: grey is linear in z; false: in disparity, about 1 / z from the eye
  bool near_black = false;

  bool operator==(const DepthCoding&) const = default;
};

}  // namespace lippmann
