// Describes a display (a panel and its lenses) and computes its optics.
//
// There are three kinds of displays:
// 1. slanted panels such as Looking Glass, where a calibration determines the direction of each sub-pixel;
// 2. lenticular sheets on a print or a panel;
// 3. microlens arrays on a panel.
// docs/reference/displays.md describes the files.
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
  double aspect = 0.75;             ///< width / height of the display; the pixels of a tile need not be square

  bool operator==(const DisplayQuilt&) const = default;
};

/// Positions of the red, green and blue sub-pixels relative to the centre of their pixel, in panel pixels, x right and y up.
using SubPixelCell = std::array<Vec2f, 3>;

/// The calibration of a slanted panel, from its file "visual.json". If the key in the file differs from the name of the member,
/// the comment of the member begins with the key.
///
/// The panel has W x H pixels. (x, y) is the position of a pixel, from 0 to 1 with y up. c = 0, 1, 2 is the colour of a
/// sub-pixel. As in Looking Glass Factory's shaders, the sub-pixel is at phase z below the lenses and shows the view v, from 0
/// to 1:
///   z = (x + c s + y T) P - center,  v = 1 - fract(z)
///   P = (pitch W / DPI) cos(atan(1 / slope)): the number of lenses across the panel, which has DPI pixels per inch
///   T = H / (W slope): the shift of the lenses over the height of the panel, in widths of the panel
///   s = 1 / (3 W): the width of a sub-pixel, in widths of the panel
/// If flip_image_x is set, T and s change their sign, unless Flip states otherwise. flip_image_y has no effect, as in those
/// shaders.
struct Calibration {
  double pitch = 52.0;  ///< lenses per inch, measured perpendicular to the lenses
  double slope = -7.0;  ///< slope of the lenses: pixels down per pixel to the right
  double center = 0.5;  ///< subtracted phase, in lens pitches
  bool invert = true;   ///< invView: see Inversion
  bool flip_image_x = false, flip_image_y = false;
  bool flip_sub_pixels = false;     ///< flipSubp: swaps blue and red
  double vertical_angle_deg = 0.0;  ///< verticalAngle: stored but not used by the formula
  double fringe = 0.0;              ///< stored but not used by the formula
  /// subpixelCells: at most 8 arrangements of sub-pixels in a pixel. In the formula above, the x of a sub-pixel replaces c s,
  /// and its y is added to y. If empty, sub-pixels are vertical stripes.
  std::vector<SubPixelCell> cells{};
  int cell_pattern = 0;   ///< CellPatternMode, 0 ... 4: selects one of `cells` for each pixel (see Patterns)
  std::string version{};  ///< configVersion: version of the file's format

  /// Meaning of `cell_pattern` 2 and 4, which differs between tools. Rows count from the bottom. The index of the cell is
  ///   pattern  kColumns                            kRows
  ///   1        (column + row) mod 2                (column + row) mod 2
  ///   2        column mod 2                        row mod 4
  ///   3        (row + 2 (column mod 2)) mod 4      (row + 2 (column mod 2)) mod 4
  ///   4        row mod 2                           column mod 2
  enum class Patterns { kColumns, kRows } patterns = Patterns::kColumns;
  /// Meaning of invView, which differs between tools. Most tools always invert the order of views. Older tools invert it only
  /// if invView is set.
  enum class Inversion { kAlways, kIfFlagged } inversion = Inversion::kAlways;
  /// Terms of the formula above that flipImageX changes. All tools negate T. Newer tools also negate s. The newest tools also
  /// add 1/2 to `center`.
  enum class Flip { kSlope, kSlopeAndStep, kSlopeStepAndCenter } flip = Flip::kSlopeAndStep;
};

/// The lenses of a lenticular sheet or a microlens array.
struct DisplayLenses {
  double pitch_mm = 1.0;
  double slant_deg = 0.0;  ///< lenticular sheets: angle between the lenses and the vertical
  LensPacking packing = LensPacking::kSquare;
  /// Lenticular sheets: position of the left edge of a strip (see LensStrips), in pixels from the left edge of the top row. No
  /// value: a lens edge lies at the panel's centre.
  std::optional<double> phase_px = {};
};

/// The videos that a device can play.
struct DisplayVideo {
  std::string codec = "hevc";  ///< h264, hevc, vp9, av1 or ffv1
  int longest_side = 8192;
  bool quilts = true;  ///< true: the device plays videos of quilts; false: it shows only still quilts
};

struct Display {
  std::string name{};
  std::string description{};
  DisplayKind kind = DisplayKind::kSlantedPanel;
  std::vector<std::string> serials{};  ///< prefixes of the device type's serial numbers, or a device's whole serial number
  Vec2i pixels{1536, 2048};
  double dpi = 324.0;
  double view_cone_deg = 40.0;                  ///< full angle of the viewing zone
  std::optional<double> viewing_distance_mm{};  ///< no value: the distance at which the panel's height spans 14 degrees
  std::optional<double> crosstalk_px{};         ///< sigma of the lens blur, in display pixels (optics/crosstalk.hpp)
  Calibration calibration{};                    ///< slanted panels only
  DisplayLenses lenses{};                       ///< lenticular sheets and microlens arrays only
  std::optional<DisplayQuilt> quilt{};
  DisplayVideo video{};

  double pixel_mm() const { return 25.4 / dpi; }
  Vec2d size_mm() const { return Vec2d(pixels) * pixel_mm(); }
};

/// Returns Display::viewing_distance_mm, or (height / 2) / tan(7 degrees) if it has no value.
double viewing_distance_mm(const Display& display);

/// Returns the optics model of a slanted panel for a viewer at `distance_mm`.
SlantedPanel slanted_panel(const Display& display, double distance_mm);

/// Returns the optics of the display's own pixels for a viewer at its viewing distance. In lenticular sheets and microlens
/// arrays, a panel area (cell) belongs to each lens, and the cells are spaced for this viewer. A cell boundary lies at the
/// panel's centre unless phase_px is set. The result passes validate().
Optics native_optics(const Display& display);

/// Returns the optics of the display's quilt (a MultiView), or nothing if the display has no quilt. Each tile of the quilt,
/// stretched to the size of the display, is the view from one eye position.
std::optional<Optics> quilt_optics(const Display& display);

double periods_of(const Display& display);
double tilt_of(const Display& display);

/// Returns the number of pixels (not sub-pixels) across one lens, which may be fractional.
double pixels_below_lens(const Display& display);

/// Returns the sigma of the display's crosstalk for a picture with `optics`, which are native_optics() or quilt_optics(). The
/// unit is a panel pixel, or the distance between neighbouring views of a quilt. None: unknown.
std::optional<double> crosstalk_of_picture(const Display& display, const Optics& optics);

/// Division of the print of a lenticular sheet into strips, one below each lens. Strip k contains the points (x, y) of the
/// print, in pixels with y down, for which
///   start + k cell <= x cos(slant) - y sin(slant) < start + (k + 1) cell.
/// Rays from the eye, at distance D from the lenses, through two neighbouring lens centres meet the print p (D + g) / D apart,
/// which is the width of a strip (cell). g is the gap between print and lenses, and p their pitch.
struct LensStrips {
  double start_px = 0.0, cell_px = 1.0;
  double cosine = 1.0, sine = 0.0;
};
LensStrips lens_strips(const Display& display);

/// Returns the number of views. If the display has a quilt, this is the number of tiles. Otherwise, it is the number of pixels
/// (for slanted panels: sub-pixels) across a lens, rounded down, and for microlens arrays the square of this number.
int views_of(const Display& display);

const char* to_string(DisplayKind kind);

}  // namespace lippmann
