// Computes what eyes see of a rendered image or a folder of frames, and other images derived from it: `lippmann replay`.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann {

/// A plane of focus, by its depth in mm in the display frame, or by its disparity in pixels between neighbouring views,
/// positive in front of z = 0 (depth_of_disparity_px in replay/disparity.hpp).
struct FocusPlane {
  double value = 0.0;
  bool in_px = false;
};

/// Planes from first to last, equally spaced in their unit. count >= 2.
struct FocalStack {
  double first = -20.0, last = 20.0;
  int count = 21;
  bool in_px = false;
  FocusPlane plane(int i) const { return {first + (last - first) * i / (count - 1), in_px}; }
};

struct ReplayParams {
  std::filesystem::path in = {};      ///< an image or a folder (replay/light_field_frames.hpp)
  LightFieldHints field = {};         ///< properties of the light field that flags state
  std::filesystem::path folder = {};  ///< for the results; empty: "replay" beside the images
  bool exr = false;                   ///< write linear floats instead of PNG

  std::optional<Vec3d> eye_mm = {};  ///< none: the design viewing position of the display
  EyeView view = {};                 ///< options of eye views; eye_mm above replaces its eye
  bool one_per_lens = false;         ///< one sample per lens (or view pixel and row), regardless of the image's proportions

  // Images to make. If none is requested, eye_0000.png etc. show the eye's view of every frame.
  std::optional<double> ipd_mm = {};           ///< distance of two eyes: left_, right_ and side by side pair_0000.png
  int sweep = 0;                               ///< number of eyes from left to right through the viewing zone: sweep_0000.png
  std::optional<FocusPlane> refocus = {};      ///< focused on that plane: refocus_0000.png
  std::optional<FocalStack> focal_stack = {};  ///< one image per plane: stack_0000_00.png
  bool all_in_focus = false;  ///< combines the stack: all_in_focus_0000.png, depth_0000.exr and, as a preview, depth_0000.png
  std::optional<int> epi_row = {}, epi_column = {};  ///< epi_row_0000.png, epi_column_0000.png
  std::filesystem::path video = {};                  ///< .mp4 or .mkv of the views, pairs or sweep
  std::optional<double> frames_per_second = {};      ///< none: as in the report
};

struct Replayed {
  std::vector<std::filesystem::path> written;
  std::optional<Vec3d> eye_mm = {};  ///< none: no image shows an eye's view
  double out_of_zone = 0.0;          ///< share of lenses that show the eye a neighbouring zone; for a pair the larger of both
};

/// Computes and writes the images. Throws Error naming the flag or file. Stops at once if context.cancelled is set: finished
/// images remain, and the unfinished one leaves no file.
Replayed replay(const ReplayParams& params, const Context& context);

}  // namespace lippmann
