// Computes images that eyes see of a rendered image or a folder of frames, and other images derived from them: `lippmann
// replay`.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann {

/// A plane of focus: either a depth in mm in the display frame, or a disparity in pixels between neighbouring views, positive
/// in front of z = 0 (depth_of_disparity_px in replay/disparity.hpp).
struct FocusPlane {
  double value = 0.0;
  bool in_px = false;
};

/// `count` planes from the first to the last, equally spaced in depth or in disparity. count >= 2.
struct FocalStack {
  double first = -20.0, last = 20.0;
  int count = 21;
  bool in_px = false;
  FocusPlane plane(int i) const { return {first + (last - first) * i / (count - 1), in_px}; }
};

struct ReplayParams {
  std::filesystem::path in = {};      ///< an image or a folder (replay/light_field_frames.hpp)
  LightFieldHints field = {};         ///< properties of the light field that the caller states
  std::filesystem::path folder = {};  ///< folder for the results; empty: "replay" beside the images
  bool exr = false;                   ///< true: writes linear floats (EXR) instead of PNG

  std::optional<Vec3d> eye_mm = {};  ///< position of the eye; none: the design viewing position of the display
  EyeView view = {};                 ///< options of eye views; eye_mm above overrides view.eye_mm
  /// true: eye views have one pixel per lens (lens_grid() in optics/viewing.hpp), even if these are not square
  bool one_per_lens = false;

  // The images to make. If none is requested, eye_0000.png etc. show the eye's view of every frame.

  /// Distance of the two eyes of a pair: left_0000.png, right_0000.png and, side by side, pair_0000.png.
  std::optional<double> ipd_mm = {};
  int sweep = 0;  ///< number of eye positions from left to right through the viewing zone: sweep_0000.png etc.
  std::optional<FocusPlane> refocus = {};      ///< plane of the image refocus_0000.png
  std::optional<FocalStack> focal_stack = {};  ///< planes of the images stack_0000_00.png etc.
  /// Whether to combine the stack into all_in_focus_0000.png, depth_0000.exr and its preview depth_0000.png.
  bool all_in_focus = false;
  /// Row and column of the epipolar images epi_row_0000.png and epi_column_0000.png.
  std::optional<int> epi_row = {}, epi_column = {};
  std::filesystem::path video = {};              ///< an .mp4 or .mkv file of the views, pairs or sweep
  std::optional<double> frames_per_second = {};  ///< frame rate of the video; none: as in the report
};

struct Replayed {
  std::vector<std::filesystem::path> written;
  std::optional<Vec3d> eye_mm = {};  ///< the eye, or the middle of both eyes; none: no image shows an eye's view
  /// Share of the lenses through which an eye sees views of a neighbouring viewing zone; for a pair, the larger share of both
  /// eyes.
  double out_of_zone = 0.0;
};

/// Computes and writes the images. Throws Error naming the flag or file. Stops at once if context.cancelled is set; finished
/// images remain, and the unfinished one leaves no file.
Replayed replay(const ReplayParams& params, const Context& context);

}  // namespace lippmann
