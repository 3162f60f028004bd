// The frames that `replay` looks at: what a render has left, or a light field in any format that `convert` reads, each as a
// panel with optics.
//
// A render's report.json says the optics; pictures that show the views in another way than the panel does (--layout) are put
// back. Without a report the cameras are those that the format states (HCI, MIV), and the panel is a quilt of the views. Where
// nothing states them, they are assumed: see assumed_optics.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lippmann/core/context.hpp"
#include "lippmann/display/display.hpp"
#include "lippmann/layout/light_field.hpp"
#include "lippmann/replay/rendered_frames.hpp"

namespace lippmann {

/// What flags say about the light field.
struct LightFieldHints {
  std::filesystem::path report = {};                ///< empty: report.json beside the pictures
  std::string from = {};                            ///< a format of `convert`; empty: as names and the report say
  std::optional<ViewGrid> views = {};               ///< how many across and up
  std::optional<ViewGrid> tiles = {};               ///< how many tiles of a quilt across and up
  std::optional<double> view_angle_deg = {};        ///< of the viewing zone, where nothing states the cameras
  bool cone_ends = false;                           ///< the outermost views of a row stand at the ends of that angle
  std::function<void(std::string_view)> warn = {};  ///< as FormatOptions::warn
  /// Pictures whose format is native, or of which nothing states the format, are what this display's panel shows. A row of
  /// views without cameras is a quilt for it.
  std::optional<Display> display = {};
  bool is_other_display = false;  ///< `display` need not be that of the pictures: no error where they are something else
};

/// The hints with the context's warnings.
inline LightFieldHints with_warnings(LightFieldHints hints, const Context& context) {
  hints.warn = context.warn;
  return hints;
}

struct LightFieldFrames {
  Optics optics;
  std::vector<std::filesystem::path> files;  ///< ascending: pictures, or folders of views
  std::filesystem::path folder;              ///< beside what is read: where results go
  double frames_per_second = 25.0;
  bool is_panel = false;        ///< pictures without a report that are what the panel of `optics` shows
  std::string assumption = {};  ///< one sentence on what was assumed of the cameras; empty: nothing
  /// The frame of that index. Throws Error naming the file, also where its size is not that of the optics' panel.
  std::function<RenderedPanel(std::size_t)> read;
};

/// Throws Error naming the file, the flag that has to say what nothing else says, or a flag without effect.
LightFieldFrames find_light_field_frames(const std::filesystem::path& in, const LightFieldHints& hints);

/// The views of a light field put behind the optics that show them, in linear light: what eyes look at. Throws Error naming
/// `where` for optics that have no such views.
RenderedPanel panel_of(const LightField& field, const Optics& optics, const std::string& where);

/// A quilt of those views. Throws Error naming `where` for cameras that are not a regular grid around the axis.
Optics optics_of_cameras(const LightField& field, const std::string& where);

/// The same of views whose cameras nobody states: a display 100 mm high, seen from 300 mm away, by a row of views that spread
/// over an angle (default: 40 degrees), with its ends or half a step inside, or by a grid of cameras (10 degrees across).
Optics assumed_optics(const LightField& field, std::optional<double> view_angle_deg, bool cone_ends = false);

/// The model of these optics.
MultiView assumed_views(const LightField& field, std::optional<double> view_angle_deg, bool cone_ends = false);

}  // namespace lippmann
