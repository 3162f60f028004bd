// Describes every output picture as a set of rays through the display plane: the panel, the optics models, and the two mappings
// that all models provide.
//
// Display frame: right-handed, millimetres, x right, y up, z towards the viewer. The lens (or display) plane is z = 0, the
// panel lies at z = -gap. Pixel (i, j): i from the left, j from the top; continuous pixel coordinates have their origin at the
// top left corner of the panel, so pixel centres are at +0.5. With pixel pitch m: x = (x_px - W/2) m, y = (H/2 - y_px) m.
//
// Lens arrays are modelled as one pinhole per lens. Light from a panel point q leaves lens centre l along l - q towards the
// viewer. We trace the same line from the viewer's side: it starts at z = z_front and runs towards -z. Thus one ray covers the
// space in front of the array and behind it, the picture is orthoscopic, and points in front of the display plane correctly
// hide those behind it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// The physical panel in whole square pixels. Rendering works on its film (film_size), which has the same pixels, or each
/// pixel's sub-pixels side by side.
struct Panel {
  int width = 512, height = 512;  ///< size in pixels
  float pixel_pitch_mm = 0.125f;  ///< the default makes a lens of 8 pixels 1 mm wide
};

/// Cylindrical lenses; horizontal parallax only. The coordinate across the lenses is xi = x cos(slant) + y sin(slant). Lens k
/// has its centre at xi = offset_mm + k lens_pitch_mm for all integers k; by default a lens boundary lies at x = 0.
struct LenticularSheet {
  float lens_pitch_mm = 1.0f;
  float gap_mm = 2.0f;
  float slant = 0.0f;      ///< angle between the lenses and the vertical in radians, |slant| < pi/2
  float offset_mm = 0.5f;  ///< xi coordinate of the centre of lens 0
  /// Distance at which the cells converge; inf: each cell lies straight below its lens.
  float viewing_distance_mm = kInfinity;
  float eye_height_mm = 0.0f;  ///< height (y) of the point at which rows converge, for a finite viewing distance
  float parallax = 1.0f;       ///< see with_parallax
};

enum class LensPacking { kSquare, kHexagonal };

/// Spherical lenslets; full parallax. Hexagonal packing: rows are lens_pitch * sqrt(3)/2 apart, and odd rows are shifted by
/// half a pitch. A pixel belongs to the lens with the nearest cell centre.
struct MicrolensArray {
  LensPacking packing = LensPacking::kSquare;
  float lens_pitch_mm = 1.0f;
  float gap_mm = 2.0f;
  Vec2f offset_mm{0.5f, 0.5f};  ///< centre of lens (0, 0)
  float viewing_distance_mm = kInfinity;
  float parallax = 1.0f;  ///< see with_parallax
};

/// A grid of views (a quilt). Every view is an off-axis (sheared) pinhole through the same rectangle in z = 0. View 0 is the
/// leftmost one and the bottom left tile; the last view is the top right tile. View v of N has the angle cone ((v + 1/2)/N -
/// 1/2) and its eye at (distance tan(angle), 0, distance). If baseline_mm is set, the eyes form a camera grid instead, as in
/// computer vision data sets: columns and rows are a baseline apart in the plane z = distance, centred on the axis, with column
/// 0 at the left and row 0 at the bottom.
struct MultiView {
  int columns = 8, rows = 6;         ///< number of tiles, which have equal sizes and fill the panel
  float view_cone = radians(40.0f);  ///< full angle that the N views cover
  /// True: angles use v / (N - 1) instead of (v + 1/2) / N, as in some tools.
  bool cone_ends_included = false;
  float distance_mm = 500.0f;  ///< distance from the eyes to the plane z = 0
  float baseline_mm = 0.0f;    ///< > 0: camera grid with this eye spacing; view_cone is ignored
  /// Height of a pixel in pixel widths; not 1 for quilts whose tiles are stretched on the display.
  float pixel_height = 1.0f;
  float parallax = 1.0f;       ///< see with_parallax
  Vec2f eye_shift{0.0f};       ///< shifts all eyes right and up, in units of the view spacing (optics/angular_filter.hpp)
  float eye_height_mm = 0.0f;  ///< height of all eyes above the middle of the plane z = 0
};

/// One pinhole at (0, eye_height, distance) through the rectangle of the panel in z = 0.
struct SingleView {
  float distance_mm = 500.0f;
  Vec2f pixel_offset{0.0f};  ///< sample points are shifted by this many pixels (x right, y down)
  float eye_height_mm = 0.0f;
};

/// Positions of the sub-pixels relative to the centre of their panel pixel, in panel pixels, x right, y up. The indices are
/// [row from the bottom, modulo 4][column modulo 2][red, green, blue], because arrangements other than stripes repeat with that
/// period.
using SubPixelOffsets = std::array<std::array<std::array<Vec2f, 3>, 2>, 4>;

/// Returns vertical stripes, as on most panels: a third of a pixel apart, with red (or blue) on the left.
SubPixelOffsets striped_sub_pixels(bool blue_first = false);

/// A calibrated panel below slanted lenses, where every sub-pixel has its own ray (formula in slanted_panel.hpp). The film of a
/// panel of W x H pixels is 3 W x H: film pixel (3 i + c, j) is the sub-pixel of colour c of panel pixel (i, j). Phases are
/// doubles because they must be as exact at the last of thousands of lenses as at the first.
struct SlantedPanel {
  double periods = 244.041;  ///< P: number of lenses across the panel, along a row
  double tilt = -0.190476;   ///< T: the lenses' horizontal shift over the panel's height, in panel widths
  /// Phase at the sub-pixel's position. For striped panels it is the calibration's value minus P / 3 W.
  double center = 0.447;
  bool inverted = true;              ///< true: v = 1 - fract(phase); false: v = fract(phase)
  float view_cone = radians(40.0f);  ///< full angle covered by v = 0 ... 1
  float distance_mm = 500.0f;        ///< distance from the viewer to the plane z = 0
  SubPixelOffsets sub_pixels = striped_sub_pixels();
  float parallax = 1.0f;       ///< see with_parallax
  float eye_height_mm = 0.0f;  ///< height of the viewer above the middle of the panel
};

/// A plenoptic camera: a thin main lens in the plane z = distance, focused on the plane z = 0, and behind it a microlens array
/// in front of the sensor, which is the panel. Its picture is upright, as if the sensor were turned by 180 degrees, so that
/// offsets on the sensor have the signs of what they show. optics/plenoptic.hpp has the formulas.
struct PlenopticCamera {
  LensPacking packing = LensPacking::kSquare;
  float lens_pitch_mm = 0.5f;
  float gap_mm = 1.0f;            ///< from the array to the sensor
  Vec2f offset_mm{0.0f};          ///< centre of lens (0, 0), from the main lens's axis
  float focal_length_mm = 50.0f;  ///< of the main lens
  float f_number = 2.0f;          ///< of the main lens; light that misses its aperture is blocked
  float distance_mm = 500.0f;     ///< from the main lens to the plane z = 0; more than the focal length
  float array_shift_mm = 0.0f;    ///< from the main lens's image of the plane z = 0 to the array, away from the main lens. 0:
                                  ///< plenoptic 1.0; else 2.0, Keplerian above 0 and Galilean below
};

struct Ray {
  Vec3f origin{0.0f};                  ///< in mm
  Vec3f direction{0.0f, 0.0f, -1.0f};  ///< unit length, z < 0
};

/// Optics defined by their rays alone: a simulated lens, a measured display, or any function from pixel to ray
/// (make_ray_table). They can be rendered, and denoised over neighbouring pixels. Interpolation, view layouts and replay are
/// not possible, because they need an inverse mapping or views.
struct RayTable {
  /// Row by row from the top left: panel.height * samples_per_side rows of panel.width * samples_per_side rays. Each pixel is
  /// divided into samples_per_side^2 parts, and a sample of the pixel takes the ray of the part that it lies in. Every ray
  /// starts at its own origin. Copies of optics share the table.
  std::shared_ptr<const std::vector<Ray>> rays{};
  int samples_per_side = 1;  ///< parts of a pixel across and down; 4: 16 rays per pixel
  float spread = 0.0f;       ///< spread between the rays of neighbouring pixels, in mm per mm of depth; sets the texture filter
};

using OpticsModel =
    std::variant<LenticularSheet, MicrolensArray, MultiView, SingleView, SlantedPanel, RayTable, PlenopticCamera>;

/// A panel and its model, which together define all rays. For MultiView, panel.pixel_pitch_mm is the horizontal pixel pitch of
/// a view in the plane z = 0.
struct Optics {
  Panel panel{};
  OpticsModel model{};
  float z_front_mm = kInfinity;  ///< rays start at this z; inf: chosen by the model, see resolved_z_front_mm
  float z_back_mm = kInfinity;   ///< rays end at z = -z_back
};

/// Rays of many pixels, each array `count` long.
struct RayArrays {
  float *origin_x = nullptr, *origin_y = nullptr, *origin_z = nullptr;
  float *direction_x = nullptr, *direction_y = nullptr, *direction_z = nullptr;
};

/// Makes a table by calling ray_of_point(Vec2f) for the middle of every part of every pixel, row by row. The argument is in
/// continuous pixel coordinates.
template <class RayOfPoint>
RayTable make_ray_table(const Panel& panel, int samples_per_side, const RayOfPoint& ray_of_point) {
  auto rays = std::make_shared<std::vector<Ray>>();
  const float part = 1.0f / static_cast<float>(samples_per_side);
  for (int j = 0; j < panel.height * samples_per_side; ++j)
    for (int i = 0; i < panel.width * samples_per_side; ++i) rays->push_back(ray_of_point((Vec2f(i, j) + 0.5f) * part));
  return {std::move(rays), samples_per_side, 0.0f};
}

/// Throws Error naming the field and its accepted range if sizes, pitches, gaps, angles or distances are invalid (zero-area
/// lenses, NaN, panels above 2^31 pixels).
void validate(const Optics& optics);

// ---- Contract 1: the ray of a pixel ---------------------------------------------------------------------------------

/// Returns the z where rays start: z_front_mm if it is finite, else the viewing distance, or 4 panel diagonals for a lens array
/// viewed from infinity. Rays of views and slanted panels start no farther away than their eye. Rays of a table start at their
/// own origins; for a table, the result is the largest z of these.
float resolved_z_front_mm(const Optics& optics);

/// Returns the ray of a point of the film in continuous pixel coordinates (pixel (i, j) has its centre at (i + 0.5, j + 0.5)).
Ray ray_of_pixel(const Optics& optics, Vec2f pixel);

/// Computes `count` rays, vectorised and bit-identical to ray_of_pixel(). If you call it many times per frame, use
/// ray_generator.hpp.
void rays_of_pixels(const Optics& optics, const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays);

/// Returns whether no light reaches a point of the film, which stays black: its ray misses the aperture of a plenoptic
/// camera's main lens. ray_of_pixel() returns the ray without the aperture.
bool is_blocked(const Optics& optics, Vec2f pixel);

// ---- Contract 2: all pixels that see a point ------------------------------------------------------------------------

/// Appends the continuous pixel coordinates of all rays that run exactly through `point_mm`, clipped to the panel, in ascending
/// lens (view) order. There is one for each lens whose cell holds the image of the point, one for each view for multi-view, and
/// usually one for each lens, from left to right, for a slanted panel.
/// At z = 0, every pixel below the lens at that point sees it, so all pixel centres of that cell are appended (for a
/// cylindrical lens: those in the panel row through the point). The padding of a quilt sees nothing, and points beyond the ends
/// of the rays are not seen. Throws Error for a table of rays and a plenoptic camera, which have no inverse.
void pixels_seeing(const Optics& optics, Vec3f point_mm, std::vector<Vec2f>& pixels);

// ---- Queries ------------------------------------------------------------------------------------

/// Returns the pixels per lens across and down if both are whole and aligned with the pixel grid ((N, 1) for a lenticular
/// sheet). Pixel (i, j) then has lens (i / N.x, j / N.y) and directional view (i mod N.x, j mod N.y). Returns (0, 0) without
/// such a structure, as for a slanted panel, and (1, 1) for multi-view and single views.
Vec2i whole_pixels_per_lens(const Optics& optics);

/// Returns the width of the area that one pixel sample covers at depth z (mm), across and along the array. It sets the texture
/// filter. Along axes with lens power it is max(lens pitch, |z| m / g), along others the panel's own pixel spacing (scaled by
/// perspective). For a slanted panel it is the larger of a pixel, which neighbouring lenses resolve together, and a magnified
/// sub-pixel.
Vec2f sample_footprint_mm(const Optics& optics, float z_mm);

/// A lens array seen from the front. pitch_mm is measured along a row of pixels, row_pitch_mm perpendicular to it.
struct LensArray {
  double pitch_mm = 0.0;      ///< distance between lenses along a row of pixels, for any slant
  double row_pitch_mm = 0.0;  ///< distance between rows of lenses; 0: cylindrical lenses
  double gap_mm = 0.0;
  double viewing_distance_mm = 0.0;  ///< distance at which the cells converge; may be inf
  double eye_height_mm = 0.0;
  double cell_mm = 0.0;        ///< width of the panel area below one lens
  double slant_cosine = 1.0;   ///< cosine of a sheet's slant; pitch_mm times this is lens_pitch_mm
  float lens_pitch_mm = 0.0f;  ///< distance between lenses, measured perpendicular to them
};

/// Returns the lenses of a lenticular sheet or a microlens array; none for other optics.
std::optional<LensArray> lens_array(const Optics& optics);

/// Returns whether the optics are a lenticular sheet or a microlens array.
inline bool has_lenses(const Optics& optics) { return lens_array(optics).has_value(); }

/// The images of a plenoptic camera's main lens on its sensor: one below each microlens, in upright rows.
struct SensorLenses {
  double pitch_px = 0.0, row_pitch_px = 0.0;
  Vec2d centre_px{0.0};  ///< of one image
  LensPacking packing = LensPacking::kSquare;
};

/// Returns none for other optics.
std::optional<SensorLenses> sensor_lenses(const Optics& optics);

/// The arrangement of views in a quilt.
struct ViewTiles {
  int columns = 1, rows = 1;
  bool camera_grid = false;  ///< true: the eyes form the same grid; false: all eyes lie in one row

  int count() const { return columns * rows; }
};

/// Returns the tiles of a quilt; none for other optics, including single views.
std::optional<ViewTiles> view_tiles(const Optics& optics);

/// Returns whether the optics are a single pinhole; its picture is shown unchanged.
bool is_single_view(const Optics& optics);

/// Returns the number of film pixels per panel pixel, side by side: 3 for a slanted panel, else 1.
int sub_pixels_per_pixel(const Optics& optics);

/// Returns the width and height of the film in pixels: the panel's pixels, or their sub-pixels side by side.
Vec2i film_size(const Optics& optics);

/// Returns the design viewing distance; inf: the cells of the lenses are parallel.
float viewing_distance_mm(const Optics& optics);

/// Returns the full angle of the viewing zone: 2 atan(cell / 2 gap) across; the cone for multi-view and slanted panels; 0 for a
/// single view.
float viewing_zone(const Optics& optics);

/// Returns the |z| beyond which views alias. Lens arrays: beyond p g / m, a panel pixel seen through its lens is wider than the
/// lens pitch. Multi-view: beyond m D / (e + m) in front of the plane, the middle views, whose eyes are e apart, differ by more
/// than a pixel. Slanted panels: the N sub-pixels below a lens of pitch p have directions 2 tan(cone / 2) / N apart, which
/// gives p N / (2 tan(cone / 2)). Single views and tables: inf.
float depth_budget_mm(const Optics& optics);

/// Returns the same display with its views drawn closer together (parallax > 0; values above 1 spread them). A view emitted at
/// angle a shows the scene as seen from parallax tan(a) instead of tan(a), so the scene looks `parallax` times as deep. The
/// plane z = 0, the middle view and the results of the queries above do not change. For lenses, it scales the pixels' offsets
/// from the cell centre. No effect on single views and tables of rays.
Optics with_parallax(Optics optics, float parallax);

/// Returns the width and height of the visible part of the plane z = 0: the panel, or one view of a quilt.
Vec2f window_size_mm(const Optics& optics);

}  // namespace lippmann
