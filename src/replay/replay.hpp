// `lippmann replay`: from a rendered picture or a folder of frames to what eyes see of it, and other pictures computed from it.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/replay/eye_view.hpp"
#include "lippmann/replay/light_field_frames.hpp"

namespace lippmann {

/// A plane to focus on: its depth in mm of the display, or the pixels by which its points move from view to view, positive in
/// front of z = 0 (depth_of_disparity_px in replay/disparity.hpp).
struct FocusPlane {
  double value = 0.0;
  bool in_px = false;
};

/// Planes from first to last, equally far apart in their unit, count >= 2.
struct FocalStack {
  double first = -20.0, last = 20.0;
  int count = 21;
  bool in_px = false;
  FocusPlane plane(int i) const { return {first + (last - first) * i / (count - 1), in_px}; }
};

struct ReplayParams {
  std::filesystem::path in = {};      ///< a picture or a folder (replay/light_field_frames.hpp)
  LightFieldHints field = {};         ///< what flags say of it
  std::filesystem::path folder = {};  ///< for the results; empty: "replay" beside the pictures
  bool exr = false;                   ///< linear floats instead of PNG

  std::optional<Vec3d> eye_mm = {};  ///< none: where the display is meant to be seen from
  EyeView view = {};                 ///< its eye is set from eye_mm
  bool one_per_lens = false;         ///< a sample for each lens (row, view's pixel), whatever shape that gives the picture

  // What to make; where nothing of this is asked for, the eye's view of every frame: eye_0000.png.
  std::optional<double> ipd_mm = {};           ///< two eyes so far apart: left_, right_ and, side by side, pair_0000.png
  int sweep = 0;                               ///< so many eyes from left to right through the zone: sweep_0000.png
  std::optional<FocusPlane> refocus = {};      ///< focused on that plane: refocus_0000.png
  std::optional<FocalStack> focal_stack = {};  ///< at these: stack_0000_00.png
  bool all_in_focus = false;                   ///< from a stack: all_in_focus_0000.png, depth_0000.exr and (for looking) .png
  std::optional<int> epi_row = {}, epi_column = {};  ///< epi_row_0000.png, epi_column_0000.png
  std::filesystem::path video = {};                  ///< .mp4 or .mkv of the views, pairs or sweep
  std::optional<double> frames_per_second = {};      ///< none: as the report says
};

struct Replayed {
  std::vector<std::filesystem::path> written;
  std::optional<Vec3d> eye_mm = {};  ///< none: no picture shows what an eye sees
  double out_of_zone = 0.0;          ///< the share of lenses that show that eye a neighbour's picture; of a pair the larger
};

/// Throws Error naming the flag or file. When context.cancelled is set, it stops at once: pictures that are finished stay, the
/// one under way leaves nothing.
Replayed replay(const ReplayParams& params, const Context& context);

}  // namespace lippmann
