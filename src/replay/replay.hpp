// Computes the images that eyes see of a rendered image or a folder of frames, and other images from them: `lippmann replay`.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann {

/// A plane of focus: a depth in mm in the display frame, or a disparity in pixels between neighbouring views (positive in front
/// of the plane z = 0, see replay/disparity.hpp).
struct FocusPlane {
  double value = 0.0;
  bool in_px = false;
};

/// `count` planes, at least 2, equally spaced in depth or in disparity.
struct FocalStack {
  double first = -20.0, last = 20.0;
  int count = 21;
  bool in_px = false;
  FocusPlane plane(int i) const { return {first + (last - first) * i / (count - 1), in_px}; }
};

struct ReplayParams {
  std::filesystem::path in = {};
  LightFieldHints field = {};         ///< properties of the light field that its files do not state
  std::filesystem::path folder = {};  ///< empty: "replay" beside the images
  bool exr = false;                   ///< writes linear floats (EXR) instead of PNG

  std::optional<Vec3d> eye_mm = {};  ///< none: the display's design viewing position
  EyeView view = {};
  /// Eye views have one pixel per lens, even if the pixels are not square.
  bool one_per_lens = false;

  // The images to make. If none is requested, every frame gives eye_0000.png etc.

  /// If set, makes left_0000.png, right_0000.png, and pair_0000.png with both images. The value is the distance between the
  /// eyes in mm.
  std::optional<double> ipd_mm = {};
  int sweep = 0;
  std::optional<FocusPlane> refocus = {};
  std::optional<FocalStack> focal_stack = {};
  /// Combines the stack into all_in_focus_0000.png, depth_0000.exr and its preview depth_0000.png.
  bool all_in_focus = false;
  std::optional<int> epi_row = {}, epi_column = {};
  std::filesystem::path video = {};
  std::optional<double> frames_per_second = {};  ///< none: the frame rate in the report
};

struct Replayed {
  std::vector<std::filesystem::path> written;
  std::optional<Vec3d> eye_mm = {};  ///< the eye, or the middle of both eyes; none if no image shows an eye's view
  /// Fraction of the lenses through which an eye sees a neighbouring viewing zone. For a pair of eyes, the larger fraction.
  double out_of_zone = 0.0;
};

/// Throws Error naming the flag or file. Stops at once if context.cancelled is set; finished images remain.
Replayed replay(const ReplayParams& params, const Context& context);

}  // namespace lippmann
