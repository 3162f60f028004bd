// Describes a display: a panel and its lenses, from a preset, a user's file or a device's calibration, and the resulting
// optics.
//
// There are three kinds: slanted panels (such as Looking Glass), where a calibration gives the direction of each sub-pixel;
// lenticular sheets on a print or a panel; microlens arrays on a panel. docs/reference/displays.md describes the files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class DisplayKind { kSlantedPanel, kLenticularSheet, kMicrolensArray };

/// The quilt of a display: its views as tiles of one image.
struct DisplayQuilt {
  int columns = 8, rows = 6;        ///< number of tiles across and down
  int width = 4096, height = 4096;  ///< size of the whole image in pixels
  double aspect = 0.75;             ///< width / height of the display; a tile may differ, since its pixels need not be square

  bool operator==(const DisplayQuilt&) const = default;
};

/// Positions of the red, green and blue sub-pixels relative to the centre of their pixel, in panel pixels, x right and y up.
using SubPixelCell = std::array<Vec2f, 3>;

/// The calibration of a slanted panel, "visual.json". If the file calls a member differently, its comment begins with the
/// file's name for it. On a panel of W x H pixels, take the pixel at (x, y), from 0 to 1 with y up. Its sub-pixel of colour c =
/// 0, 1, 2 lies below the lenses at the phase
///   z = (x + c s + y T) P - center,  P = pitch W / DPI cos(atan(1 / slope)),  T = H / (W slope),  s = 1 / 3W
/// and shows the view v = 1 - fract(z), as in Looking Glass Factory's shaders. flip_image_x negates T and s. flip_image_y has
/// no effect, as in those shaders.
struct Calibration {
  double pitch = 52.0;  ///< lenses per inch, measured perpendicular to the lenses
  double slope = -7.0;  ///< slope of the lenses: pixels down per pixel to the right
  double center = 0.5;  ///< phase that is subtracted, in lens pitches
  bool invert = true;   ///< invView: see Inversion
  bool flip_image_x = false, flip_image_y = false;
  bool flip_sub_pixels = false;     ///< flipSubp: swaps blue and red
  double vertical_angle_deg = 0.0;  ///< verticalAngle: stored but not used by the formula
  double fringe = 0.0;              ///< stored but not used by the formula
  /// subpixelCells: at most 8 arrangements of sub-pixels. They replace c s, and a y offset of 0, in the formula. Empty: the
  /// sub-pixels are vertical stripes.
  std::vector<SubPixelCell> cells{};
  int cell_pattern = 0;   ///< CellPatternMode: 0 ... 4, selects which cell each pixel has
  std::string version{};  ///< configVersion: version of the file's format

  /// Meaning of the cell patterns 2 and 4, which differs between tools. kColumns: pattern 2 selects the cell by column modulo
  /// 2, pattern 4 by row modulo 2. kRows: pattern 2 selects it by row modulo 4, pattern 4 by column modulo 2. In both, pattern
  /// 1 is a checkerboard and pattern 3 is (row + 2 (column modulo 2)) modulo 4. Rows count from the bottom.
  enum class Patterns { kColumns, kRows } patterns = Patterns::kColumns;
  /// Meaning of invView, which differs between tools: most always invert the order of views, older ones only if invView is set.
  enum class Inversion { kAlways, kIfFlagged } inversion = Inversion::kAlways;
  /// The terms that flipImageX changes. All tools negate the tilt T, newer ones also the step s, and the newest also add 1/2 to
  /// the center.
  enum class Flip { kSlope, kSlopeAndStep, kSlopeStepAndCenter } flip = Flip::kSlopeAndStep;
};

/// The lenses of a lenticular sheet or a microlens array.
struct DisplayLenses {
  double pitch_mm = 1.0;
  double slant_deg = 0.0;  ///< lenticular sheets: angle between the lenses and the vertical
  LensPacking packing = LensPacking::kSquare;
  /// Lenticular sheets: left edge of the strip below a lens, in pixels from the left edge of the top row. None: a lens edge
  /// lies at the panel's centre.
  std::optional<double> phase_px = {};
};

/// The videos that a device can play.
struct DisplayVideo {
  std::string codec = "hevc";  ///< h264, hevc, vp9, av1 or ffv1
  int longest_side = 8192;     ///< maximum width and height in pixels
  bool quilts = true;          ///< true: the device plays videos of quilts; false: only still images of them
};

struct Display {
  std::string name{};         ///< the preset's name, or the file's name without its ending
  std::string description{};  ///< one line of text for users
  DisplayKind kind = DisplayKind::kSlantedPanel;
  std::vector<std::string> serials{};  ///< prefixes of serial numbers of this device type; for a calibration, the serial number
  Vec2i pixels{1536, 2048};            ///< width and height of the panel or print
  double dpi = 324.0;                  ///< pixels per inch
  double view_cone_deg = 40.0;         ///< full angle of the viewing zone
  std::optional<double> viewing_distance_mm{};  ///< none: the distance at which the panel's height spans 14 degrees
  std::optional<double> crosstalk_px{};         ///< sigma of the lens blur, in display pixels (optics/crosstalk.hpp)
  Calibration calibration{};                    ///< slanted panels only
  DisplayLenses lenses{};                       ///< lenticular sheets and microlens arrays only
  std::optional<DisplayQuilt> quilt{};
  DisplayVideo video{};

  double pixel_mm() const { return 25.4 / dpi; }
  Vec2d size_mm() const { return Vec2d(pixels) * pixel_mm(); }
};

/// Returns the distance of the viewer from the display: the member of that name, or by default (height / 2) / tan(7 degrees).
double viewing_distance_mm(const Display& display);

/// Returns the model of a slanted panel for a viewer at `distance_mm`. Its Optics::panel is W x H pixels of pixel_mm().
SlantedPanel slanted_panel(const Display& display, double distance_mm);

/// Returns the optics of the display's own pixels, for its viewer. The cells of a lenticular sheet or a microlens array
/// converge to the viewer, and a cell boundary lies at the panel's centre unless phase_px is set. The result passes validate().
Optics native_optics(const Display& display);

/// Returns the optics of the display's quilt, a MultiView; none if the display has no quilt. Each tile, stretched to the size
/// of the display, is the view from one eye position.
std::optional<Optics> quilt_optics(const Display& display);

/// Return the periods P and the tilt T of a calibration; see Calibration.
double periods_of(const Display& display);
double tilt_of(const Display& display);

/// Returns the number of pixels across one lens: pixels, not sub-pixels; may be fractional.
double pixels_below_lens(const Display& display);

/// Division of the print of a lenticular sheet into strips. The strip below lens k covers the pixels x of row y (continuous, y
/// down) with start + k cell <= x cos(slant) - y sin(slant) < start + (k + 1) cell. Strips are p (D + g) / D wide, with the
/// lens pitch p, the gap g and the viewing distance D: rays from the eye through two neighbouring lens centres are p apart at
/// the lenses (distance D), and p (D + g) / D apart at the print (distance D + g).
struct LensStrips {
  double start_px = 0.0, cell_px = 1.0;
  double cosine = 1.0, sine = 0.0;
};
LensStrips lens_strips(const Display& display);

/// Returns the number of views: that of the quilt if there is one. Otherwise the number of pixels across a lens, rounded down:
/// sub-pixels for slanted panels, and squared for microlens arrays.
int views_of(const Display& display);

const char* to_string(DisplayKind kind);

}  // namespace lippmann
