// Finds the frames to replay, from a finished render or a light field in any format of `convert`, and reads each frame as a
// panel with optics.
//
// The optics come from a render's report.json. Without a report, they follow from the cameras in the files (HCI, MIV) or are
// assumed (assumed_optics()), and the panel is a quilt of the views. If a render stored its views in another layout, they are
// moved back to their places on the panel.
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

/// Properties of a light field that the caller states, mostly from flags.
struct LightFieldHints {
  std::filesystem::path report = {};  ///< empty: report.json beside the images
  std::string from = {};              ///< a format of `convert`; empty: detected
  std::optional<ViewGrid> views = {};
  std::optional<ViewGrid> tiles = {};         ///< columns and rows of a quilt's tiles
  std::optional<double> view_angle_deg = {};  ///< full angle of the viewing zone, if the cameras are unknown
  /// Whether the outermost views are at the two ends of view_angle_deg. If not, they are half a view step inside.
  bool cone_ends = false;
  std::function<void(std::string_view)> warn = {};  ///< called with each warning
  /// The display that the images were made for. If this is set, images of the format `native` or of an unknown format are read
  /// as frames of the display's panel, and a row of views without cameras is read as a quilt for the display.
  std::optional<Display> display = {};
  bool is_other_display = false;  ///< true: accept images that were made for another display
};

/// Returns the hints, with `warn` set to the `warn` of the context.
inline LightFieldHints with_warnings(LightFieldHints hints, const Context& context) {
  hints.warn = context.warn;
  return hints;
}

struct LightFieldFrames {
  Optics optics{};
  std::vector<std::filesystem::path> files{};  ///< images or folders of views, in the order of frames
  std::filesystem::path folder{};  ///< default folder for results: the input folder, or the folder of the input file
  double frames_per_second = 25.0;
  bool is_panel = false;        ///< the images have no report and are frames of the panel of `optics`
  std::string assumption = {};  ///< sentence about assumed cameras, or empty
  /// Reads the frame with this index in `files`. Throws Error naming the file, for example if its size is not the panel's.
  std::function<RenderedPanel(std::size_t)> read{};
};

/// Throws Error naming an unreadable file, a flag that the input requires, or a flag that has no effect on the input.
LightFieldFrames find_light_field_frames(const std::filesystem::path& in, const LightFieldHints& hints);

/// Arranges the views on the panel of `optics`, in linear light. Throws Error naming `where` if the grid or the size of the
/// views differs from that of the optics, or if the views of the optics do not consist of whole pixels.
RenderedPanel panel_of(const LightField& field, const Optics& optics, const std::string& where);

/// Returns whether the cameras of the views are known and form a regular grid.
bool has_camera_grid(const LightField& field);

/// Returns optics with the cameras of the views. Throws Error naming `where` unless the cameras form a regular grid centred on
/// the display's axis.
Optics optics_of_cameras(const LightField& field, const std::string& where);

/// For views with unknown cameras: a display 100 mm high, seen from 300 mm. A row of views spreads over view_angle_deg
/// (default: 40 degrees), with the outermost views at the ends of this angle if `cone_ends`, otherwise half a view step inside.
/// A grid of cameras spans 10 degrees across by default.
Optics assumed_optics(const LightField& field, std::optional<double> view_angle_deg, bool cone_ends = false);

/// Returns a sentence without its full stop on the optics that assumed_optics() returned for the views of `where`.
std::string describe_assumed_optics(const LightField& field, const Optics& optics, std::optional<double> view_angle_deg,
                                    const std::string& where);

/// Returns the parameters of the cameras that assumed_optics() assumes.
MultiView assumed_views(const LightField& field, std::optional<double> view_angle_deg, bool cone_ends = false);

}  // namespace lippmann
