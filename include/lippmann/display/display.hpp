// A display as data: what a preset, a user's own file or a device's calibration says of a panel and the lenses on it, and the
// optics that follow.
//
// Three kinds: slanted panels (Looking Glass and the like), whose every sub-pixel has a direction by calibration; lenticular
// sheets on a print or a panel; microlens arrays on a panel. docs/reference/displays.md describes the files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/optics/optics.hpp"

namespace lippmann {

enum class DisplayKind { kSlantedPanel, kLenticularSheet, kMicrolensArray };

/// The quilt that a display wants: views side by side in one picture.
struct DisplayQuilt {
  int columns = 8, rows = 6;        ///< tiles
  int width = 4096, height = 4096;  ///< pixels of the whole picture
  double aspect = 0.75;             ///< width / height of the display, not of a tile: tiles' pixels need not be square

  bool operator==(const DisplayQuilt&) const = default;
};

/// Positions of red, green and blue, panel pixels from their pixel's centre, x right and y up.
using SubPixelCell = std::array<Vec2f, 3>;

/// A slanted panel's calibration, "visual.json": names in the file in brackets where they differ. With W, H the panel's pixels,
/// a sub-pixel of colour c = 0, 1, 2 of the pixel at x, y from 0 to 1 (y up) lies at the phase
///   z = (x + c s + y T) P - center,  P = pitch W / DPI cos(atan(1 / slope)),  T = H / (W slope),  s = 1 / 3W
/// below the lenses and is of the view v = 1 - fract(z), as in Looking Glass Factory's shaders. flip_image_x negates T and s.
/// flip_image_y has no effect, as in these.
struct Calibration {
  double pitch = 52.0;  ///< lenses per inch, across them
  double slope = -7.0;  ///< rise over run of the lenses: pixels down for one to the right
  double center = 0.5;  ///< phase
  bool invert = true;   ///< (invView)
  bool flip_image_x = false, flip_image_y = false;
  bool flip_sub_pixels = false;     ///< (flipSubp) blue and red change places
  double vertical_angle_deg = 0.0;  ///< (verticalAngle) kept, no part of the formula
  double fringe = 0.0;              ///< likewise
  std::vector<SubPixelCell> cells;  ///< (subpixelCells) at most 8; none: stripes. In place of c s, and of y's offset, 0
  int cell_pattern = 0;             ///< (CellPatternMode) 0 ... 4: which of the cells a pixel has
  std::string version;              ///< (configVersion)

  /// Tools do not agree on patterns 2 and 4. "columns": 2 is by column modulo 2, 4 by row modulo 2. "rows": 2 is by row modulo
  /// 4, 4 by column modulo 2. (Rows count from the bottom. 1 is a checkerboard, 3 is by row + 2 (column modulo 2), modulo 4.)
  enum class Patterns { kColumns, kRows } patterns = Patterns::kColumns;
  /// Nor on invView: most invert always, older ones only where it is set.
  enum class Inversion { kAlways, kIfFlagged } inversion = Inversion::kAlways;
  /// The terms that flipImageX changes: it negates the slope T in all tools, in newer ones the step s too, and in the newest it
  /// also adds 1/2 to the center.
  enum class Flip { kSlope, kSlopeAndStep, kSlopeStepAndCenter } flip = Flip::kSlopeAndStep;
};

/// The lenses of sheets and arrays.
struct DisplayLenses {
  double pitch_mm = 1.0;
  double slant_deg = 0.0;  ///< angle of a sheet's lenses from the vertical
  LensPacking packing = LensPacking::kSquare;
  /// Left edge of the print below a lens of a sheet, in pixels from the left edge of the top row; none: at the centre.
  std::optional<double> phase_px = {};
};

/// What a device plays. By default, everything.
struct DisplayVideo {
  std::string codec = "hevc";  ///< h264, hevc, vp9, av1 or ffv1
  int longest_side = 8192;     ///< pixels
  bool quilts = true;          ///< plays videos of quilts; else only pictures
};

struct Display {
  std::string name;         ///< the preset's name, or the file's name without its ending
  std::string description;  ///< one line
  DisplayKind kind = DisplayKind::kSlantedPanel;
  std::vector<std::string> serials;           ///< prefixes of the serial numbers of such devices; of a calibration, its own
  Vec2i pixels{1536, 2048};                   ///< width and height of the panel or print
  double dpi = 324.0;                         ///< pixels per inch
  double view_cone_deg = 40.0;                ///< full angle
  std::optional<double> viewing_distance_mm;  ///< none: from where the panel's height spans 14 degrees
  std::optional<double> crosstalk_px;         ///< sigma of its lenses' blur, in its pixels (optics/crosstalk.hpp)
  Calibration calibration;                    ///< slanted panels
  DisplayLenses lenses;                       ///< the other kinds
  std::optional<DisplayQuilt> quilt;
  DisplayVideo video;

  double pixel_mm() const { return 25.4 / dpi; }
  Vec2d size_mm() const { return Vec2d(pixels) * pixel_mm(); }
};

/// How far the viewer stands: as given, or (height / 2) / tan(7 degrees).
double viewing_distance_mm(const Display& display);

/// The model of a slanted panel for a viewer at that distance. Its Optics::panel is W x H pixels of pixel_mm().
SlantedPanel slanted_panel(const Display& display, double distance_mm);

/// The rays of the display's own pixels, for its viewer. (Of a sheet or an array: lenses whose cells converge to the viewer;
/// they begin at the panel's centre.) Passes validate().
Optics native_optics(const Display& display);

/// The rays of its quilt, whose tiles, stretched to the display, are what its viewer sees: MultiView. None: it has no quilt.
std::optional<Optics> quilt_optics(const Display& display);

/// What its periods P and tilt T are: see Calibration.
double periods_of(const Display& display);
double tilt_of(const Display& display);

/// How many of its pixels (whole ones) lie below a lens, across.
double pixels_below_lens(const Display& display);

/// How the print of a lenticular sheet is divided: the strip below lens k covers the pixels x of row y (continuous, y down)
/// with start + k cell <= x cos(slant) - y sin(slant) < start + (k + 1) cell. The sheet's viewer sees the whole of each strip:
/// with the lenses' pitch p, the gap g and the viewing distance D, strips are p (D + g) / D wide, because rays from the eye
/// through two neighbouring lens centres, p apart at the distance D, are that far apart on the print, at D + g.
struct LensStrips {
  double start_px = 0.0, cell_px = 1.0;
  double cosine = 1.0, sine = 0.0;
};
LensStrips lens_strips(const Display& display);

/// How many views: of its quilt; else the pixels (of a slanted panel sub-pixels) below a lens, rounded down.
int views_of(const Display& display);

const char* to_string(DisplayKind kind);

}  // namespace lippmann
