// Depth as grey levels in RGB-D pictures.
#pragma once

namespace lippmann {

struct DepthRange {
  /// Depths z in the display frame, above 0 in front of the screen. far_mm < near_mm.
  double near_mm = 10.0, far_mm = -30.0;

  bool operator==(const DepthRange&) const = default;
};

enum class DepthScale { kDisparity, kDepth };

struct DepthCoding {
  DepthRange range{};
  /// True: grey is linear in z. False: grey is linear in disparity, about 1 / distance from the eye.
  bool even_in_depth = false;
  bool near_black = false;

  bool operator==(const DepthCoding&) const = default;
};

}  // namespace lippmann
