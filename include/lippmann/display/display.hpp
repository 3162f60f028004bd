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
  int columns = 8, rows = 6;        ///< tiles
  int width = 4096, height = 4096;  ///< pixels of the whole image
  double aspect = 0.75;             ///< width / height of the display, not of a tile, whose pixels need not be square

  bool operator==(const DisplayQuilt&) const = default;
};

/// Positions of red, green and blue relative to the pixel's centre, in panel pixels, x right and y up.
using SubPixelCell = std::array<Vec2f, 3>;

/// The calibration of a slanted panel, "visual.json". Names in parentheses are those in the file, if different. For a panel of
/// W x H pixels, a sub-pixel of colour c = 0, 1, 2 of the pixel at x, y from 0 to 1 (y up) lies at the phase
///   z = (x + c s + y T) P - center,  P = pitch W / DPI cos(atan(1 / slope)),  T = H / (W slope),  s = 1 / 3W
/// below the lenses and shows the view v = 1 - fract(z), as in Looking Glass Factory's shaders. flip_image_x negates T and s.
/// flip_image_y has no effect, as in those shaders.
struct Calibration {
  double pitch = 52.0;  ///< lenses per inch, across them
  double slope = -7.0;  ///< slope of the lenses: pixels down per pixel to the right
  double center = 0.5;  ///< phase
  bool invert = true;   ///< (invView)
  bool flip_image_x = false, flip_image_y = false;
  bool flip_sub_pixels = false;       ///< (flipSubp) swaps blue and red
  double vertical_angle_deg = 0.0;    ///< (verticalAngle) stored but not used by the formula
  double fringe = 0.0;                ///< stored but not used by the formula
  std::vector<SubPixelCell> cells{};  ///< (subpixelCells) at most 8; replace c s and the y offset 0; none: stripes
  int cell_pattern = 0;               ///< (CellPatternMode) 0 ... 4: assignment of cells to pixels
  std::string version{};              ///< (configVersion)

  /// Meaning of patterns 2 and 4, which differs between tools. "columns": 2 is column modulo 2, 4 is row modulo 2. "rows": 2 is
  /// row modulo 4, 4 is column modulo 2. In both, 1 is a checkerboard and 3 is (row + 2 (column modulo 2)) modulo 4. Rows count
  /// from the bottom.
  enum class Patterns { kColumns, kRows } patterns = Patterns::kColumns;
  /// Meaning of invView, which differs between tools: most always invert, older ones only if it is set.
  enum class Inversion { kAlways, kIfFlagged } inversion = Inversion::kAlways;
  /// The terms changed by flipImageX. All tools negate the slope T, newer ones also the step s, and the newest also add 1/2 to
  /// the center.
  enum class Flip { kSlope, kSlopeAndStep, kSlopeStepAndCenter } flip = Flip::kSlopeAndStep;
};

/// The lenses of sheets and arrays.
struct DisplayLenses {
  double pitch_mm = 1.0;
  double slant_deg = 0.0;  ///< angle of a sheet's lenses from the vertical
  LensPacking packing = LensPacking::kSquare;
  /// Left edge of the strip below a lens of a sheet, in pixels from the left edge of the top row; none: at the centre.
  std::optional<double> phase_px = {};
};

/// The videos that a device can play. The default is no restriction.
struct DisplayVideo {
  std::string codec = "hevc";  ///< h264, hevc, vp9, av1 or ffv1
  int longest_side = 8192;     ///< pixels
  bool quilts = true;          ///< plays videos of quilts, not only still images
};

struct Display {
  std::string name{};         ///< the preset's name, or the file's name without its ending
  std::string description{};  ///< one line
  DisplayKind kind = DisplayKind::kSlantedPanel;
  std::vector<std::string> serials{};  ///< prefixes of serial numbers of this device type; for a calibration, the serial number
  Vec2i pixels{1536, 2048};            ///< width and height of the panel or print
  double dpi = 324.0;                  ///< pixels per inch
  double view_cone_deg = 40.0;         ///< full angle
  std::optional<double> viewing_distance_mm{};  ///< none: the distance at which the panel's height spans 14 degrees
  std::optional<double> crosstalk_px{};         ///< sigma of the lens blur, in display pixels (optics/crosstalk.hpp)
  Calibration calibration{};                    ///< of slanted panels
  DisplayLenses lenses{};                       ///< of the other kinds
  std::optional<DisplayQuilt> quilt{};
  DisplayVideo video{};

  double pixel_mm() const { return 25.4 / dpi; }
  Vec2d size_mm() const { return Vec2d(pixels) * pixel_mm(); }
};

/// Returns the distance of the viewer: as given, or (height / 2) / tan(7 degrees).
double viewing_distance_mm(const Display& display);

/// Returns the model of a slanted panel for a viewer at `distance_mm`. Its Optics::panel is W x H pixels of pixel_mm().
SlantedPanel slanted_panel(const Display& display, double distance_mm);

/// Returns the optics of the display's own pixels, for its viewer. The cells of a sheet or an array converge to the viewer and
/// begin at the panel's centre. The result passes validate().
Optics native_optics(const Display& display);

/// Returns the optics of the display's quilt, a MultiView, or none without a quilt. A tile stretched to the display is one view
/// of the viewer.
std::optional<Optics> quilt_optics(const Display& display);

/// Return the periods P and the tilt T of a calibration; see Calibration.
double periods_of(const Display& display);
double tilt_of(const Display& display);

/// Returns the number of pixels below a lens, across, in whole pixels.
double pixels_below_lens(const Display& display);

/// Division of the print of a lenticular sheet into strips. The strip below lens k covers the pixels x of row y (continuous, y
/// down) with start + k cell <= x cos(slant) - y sin(slant) < start + (k + 1) cell. Strips are p (D + g) / D wide, with the
/// lens pitch p, the gap g and the viewing distance D, because rays from the eye through two neighbouring lens centres, p apart
/// at the distance D, are that far apart on the print, at D + g.
struct LensStrips {
  double start_px = 0.0, cell_px = 1.0;
  double cosine = 1.0, sine = 0.0;
};
LensStrips lens_strips(const Display& display);

/// Returns the number of views: of the quilt, or else the number of pixels below a lens (sub-pixels for slanted panels),
/// rounded down.
int views_of(const Display& display);

const char* to_string(DisplayKind kind);

}  // namespace lippmann
