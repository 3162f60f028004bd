// Describes every output picture as a set of rays through the display plane: the panel, the optics models, and the mappings
// from a pixel to its ray and from a point to the pixels that see it.
//
// Display frame: right-handed, millimetres, x right, y up, z towards the viewer. The lens (or display) plane is z = 0, the
// panel lies at z = -gap. Pixel (i, j): i from the left, j from the top; continuous pixel coordinates have their origin at the
// top left corner of the panel, so pixel centres are at +0.5. With pixel pitch m and W x H pixels: x = (x_px - W/2) m, y = (H/2
// - y_px) m.
//
// Lens arrays are modelled as one pinhole per lens. Light from a panel point q leaves lens centre l along l - q towards the
// viewer. We trace the same line from the viewer's side: the line starts at z = z_front_mm (in struct Optics) and runs towards
// -z. Thus one ray covers the space in front of the array and behind it.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// The physical panel, which consists of square pixels. Rendering works on the film of the panel (film_size()). Its pixels are
/// the pixels of the panel, or, for a slanted panel, its sub-pixels side by side.
struct Panel {
  int width = 512, height = 512;
  float pixel_pitch_mm = 0.125f;  ///< by default, 8 pixels are as wide as a lens of 1 mm
};

/// Cylindrical lenses, with parallax only across the lenses. The coordinate across the lenses is xi = x cos(slant) + y
/// sin(slant). Lens k has its centre at xi = offset_mm + k lens_pitch_mm, for all integers k. By default, the boundary between
/// two lenses lies at x = 0.
struct LenticularSheet {
  float lens_pitch_mm = 1.0f;
  float gap_mm = 2.0f;
  float slant = 0.0f;      ///< angle between the lenses and the vertical in radians, |slant| < pi/2
  float offset_mm = 0.5f;  ///< xi coordinate of the centre of lens 0
  /// Viewing distance that the panel is made for. A cell is the panel area that belongs to one lens. Lines from the cells'
  /// centres through their lenses meet at this distance. If it is infinite, each cell lies straight below its lens.
  float viewing_distance_mm = kInfinity;
  /// Y coordinate of the intended viewer, if viewing_distance_mm is finite. The rays of all pixel rows converge to this height.
  float eye_height_mm = 0.0f;
  float parallax = 1.0f;
};

enum class LensPacking { kSquare, kHexagonal };

/// Spherical lenslets, with parallax in both directions. In hexagonal packing, rows are lens_pitch * sqrt(3)/2 apart, and odd
/// rows are shifted by half a pitch. The cell of a lens is the panel area below it. A pixel belongs to the lens with the
/// nearest cell centre.
struct MicrolensArray {
  LensPacking packing = LensPacking::kSquare;
  float lens_pitch_mm = 1.0f;
  float gap_mm = 2.0f;
  Vec2f offset_mm{0.5f, 0.5f};  ///< centre of lens (0, 0)
  float viewing_distance_mm = kInfinity;
  float parallax = 1.0f;
};

/// A grid of views (a quilt). Every view is an off-axis (sheared) pinhole through the same rectangle in z = 0. View 0 is the
/// leftmost view, and its tile is at the bottom left. The last view has the tile at the top right. View v of N has the angle
/// cone ((v + 1/2)/N - 1/2) and its eye at (distance tan(angle), 0, distance).
///
/// If baseline_mm is above 0, the eyes form a camera grid instead, centred at (0, 0, distance). Its columns and rows are a
/// baseline apart. Column 0 is at the left, and row 0 at the bottom.
struct MultiView {
  int columns = 8, rows = 6;         ///< number of tiles, which have equal sizes and fill the panel
  float view_cone = radians(40.0f);  ///< full angle that the N views cover
  /// True: the angle of view v uses v / (N - 1) instead of (v + 1/2) / N, as in some tools.
  bool cone_ends_included = false;
  float distance_mm = 500.0f;  ///< distance from the eyes to the plane z = 0
  float baseline_mm = 0.0f;    ///< if above 0: eye spacing of a camera grid, which ignores view_cone
  /// Height of a pixel in pixel widths. Differs from 1 for quilts whose tiles are stretched on the display.
  float pixel_height = 1.0f;
  float parallax = 1.0f;
  Vec2f eye_shift{0.0f};       ///< shifts all eyes right and up, in units of the view spacing (optics/angular_filter.hpp)
  float eye_height_mm = 0.0f;  ///< height of all eyes above the middle of the plane z = 0
};

/// One pinhole at (0, eye_height, distance) through the rectangle of the panel in z = 0.
struct SingleView {
  float distance_mm = 500.0f;  ///< distance from the viewer to the plane z = 0
  Vec2f pixel_offset{0.0f};    ///< shift of sample points, in pixels right and down
  float eye_height_mm = 0.0f;
};

/// Positions of sub-pixels relative to the centre of their panel pixel, in units of a panel pixel, x right, y up. The indices
/// are [row from the bottom, modulo 4][column modulo 2][red, green, blue].
using SubPixelOffsets = std::array<std::array<std::array<Vec2f, 3>, 2>, 4>;

/// Returns vertical stripes a third of a pixel apart, as on most panels. Red is on the left, or blue if `blue_first`.
SubPixelOffsets striped_sub_pixels(bool blue_first = false);

/// A calibrated panel below slanted lenses, where every sub-pixel has its own ray (formula in slanted_panel.hpp). The film of a
/// panel of W x H pixels has 3 W x H pixels: film pixel (3 i + c, j) is the sub-pixel of colour c of panel pixel (i, j). Phases
/// are doubles, because their integer parts count up to thousands of lenses.
struct SlantedPanel {
  double periods = 244.041;  ///< P: number of lenses across the panel, along a row
  double tilt = -0.190476;   ///< T: horizontal shift of a lens from the bottom to the top of the panel, in panel widths
  /// Offset that is subtracted from the phase of every sub-pixel (formula in slanted_panel.hpp). For striped panels of W
  /// pixels, it is `center` of the calibration file minus P / (3 W), the phase between neighbouring sub-pixels.
  double center = 0.447;
  bool inverted = true;              ///< true: view v = 1 - fract(phase); false: v = fract(phase)
  float view_cone = radians(40.0f);  ///< full angle between the views v = 0 and v = 1
  float distance_mm = 500.0f;
  SubPixelOffsets sub_pixels = striped_sub_pixels();
  float parallax = 1.0f;
  float eye_height_mm = 0.0f;  ///< height of the viewer above the middle of the panel
};

/// A plenoptic camera. A thin main lens in the plane z = distance is focused on the plane z = 0. Behind it are a microlens
/// array and the sensor, which is the panel. The picture is upright, as if the sensor were turned by 180 degrees.
/// optics/plenoptic.hpp has the formulas.
struct PlenopticCamera {
  LensPacking packing = LensPacking::kSquare;
  float lens_pitch_mm = 0.5f;
  float gap_mm = 1.0f;    ///< distance from the microlens array to the sensor
  Vec2f offset_mm{0.0f};  ///< centre of lens (0, 0) relative to the axis of the main lens
  float focal_length_mm = 50.0f;
  float f_number = 2.0f;       ///< f-number of the main lens; light outside its aperture is blocked
  float distance_mm = 500.0f;  ///< distance from the main lens to the plane z = 0; greater than the focal length
  /// Distance from the main lens's image of the plane z = 0 to the array, positive away from the main lens. 0 is a plenoptic
  /// camera 1.0. Other values are a plenoptic camera 2.0: Keplerian above 0, Galilean below 0.
  float array_shift_mm = 0.0f;
};

struct Ray {
  Vec3f origin{0.0f};                  ///< in mm
  Vec3f direction{0.0f, 0.0f, -1.0f};  ///< unit length, z < 0
};

/// Optics defined only by a table of rays: a simulated lens, a measured display, or any function from pixel to ray
/// (make_ray_table()). Such optics do not support interpolation, view layouts and replay, because these need an inverse mapping
/// or views.
struct RayTable {
  /// Row by row from the top left: panel.height * samples_per_side rows of panel.width * samples_per_side rays. A sample of a
  /// pixel uses the ray of the part of the pixel that contains the sample. Every ray starts at its own origin. Copies of the
  /// optics share the table.
  std::shared_ptr<const std::vector<Ray>> rays{};
  int samples_per_side = 1;  ///< parts of a pixel along each side, for example 4 for 16 rays per pixel
  float spread = 0.0f;       ///< spread between the rays of neighbouring pixels, in mm per mm of depth; sets the texture filter
};

using OpticsModel =
    std::variant<LenticularSheet, MicrolensArray, MultiView, SingleView, SlantedPanel, RayTable, PlenopticCamera>;

/// A panel and its model, which together define all rays. For MultiView, panel.pixel_pitch_mm is the horizontal pixel pitch of
/// a view in the plane z = 0.
struct Optics {
  Panel panel{};
  OpticsModel model{};
  float z_front_mm = kInfinity;  ///< rays start at this z; if infinite, resolved_z_front_mm() chooses it
  float z_back_mm = kInfinity;   ///< rays end at z = -z_back_mm
};

/// Rays of many pixels. Each array has one element per ray.
struct RayArrays {
  float *origin_x = nullptr, *origin_y = nullptr, *origin_z = nullptr;
  float *direction_x = nullptr, *direction_y = nullptr, *direction_z = nullptr;
};

/// Returns a table of rays. Calls ray_of_point(Vec2f) for the middle of every part of every pixel, in continuous pixel
/// coordinates, row by row.
template <class RayOfPoint>
RayTable make_ray_table(const Panel& panel, int samples_per_side, const RayOfPoint& ray_of_point) {
  auto rays = std::make_shared<std::vector<Ray>>();
  const float part = 1.0f / static_cast<float>(samples_per_side);
  for (int j = 0; j < panel.height * samples_per_side; ++j)
    for (int i = 0; i < panel.width * samples_per_side; ++i) rays->push_back(ray_of_point((Vec2f(i, j) + 0.5f) * part));
  return {std::move(rays), samples_per_side, 0.0f};
}

/// Throws Error naming the field and its accepted range if sizes, pitches, gaps, angles or distances are invalid.
void validate(const Optics& optics);

/// Returns the z where rays start: z_front_mm if it is finite, else the viewing distance if it is finite, else 4 panel
/// diagonals. Rays of views and slanted panels start no farther away than their eye. For a table of rays, returns the largest z
/// of their origins.
float resolved_z_front_mm(const Optics& optics);

/// Returns the ray of a point of the film in continuous pixel coordinates (pixel (i, j) has its centre at (i + 0.5, j + 0.5)).
Ray ray_of_pixel(const Optics& optics, Vec2f pixel);

/// Computes `count` rays, vectorised and bit-identical to ray_of_pixel(). If you call it many times per frame, use
/// ray_generator.hpp.
void rays_of_pixels(const Optics& optics, const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays);

/// Returns whether the ray of a point of the film misses the aperture of a plenoptic camera's main lens. Such points stay
/// black. ray_of_pixel() ignores the aperture.
bool is_blocked(const Optics& optics, Vec2f pixel);

/// Appends the continuous pixel coordinates of all rays that run exactly through `point_mm`, in ascending order of lenses or
/// views. Positions outside the panel are left out. There are:
/// - for lens arrays, one position for each lens whose cell contains the image of the point;
/// - for multi-view, one position for each view;
/// - for slanted panels, usually one position for each lens, from left to right.
/// All pixels below a lens see a point of the lens plane z = 0, so all pixel centres of its cell are appended (for a
/// cylindrical lens, only those in the panel row through the point). The padding of a quilt sees nothing. Points beyond the
/// ends of the rays are not seen. Throws Error for a table of rays and a plenoptic camera, which have no inverse.
void pixels_seeing(const Optics& optics, Vec3f point_mm, std::vector<Vec2f>& pixels);

/// Returns the pixels per lens across and down if both are whole and aligned with the pixel grid ((N, 1) for a lenticular
/// sheet). Pixel (i, j) then has lens (i / N.x, j / N.y) and directional view (i mod N.x, j mod N.y). Returns (0, 0) without
/// such a structure, as for a slanted panel, and (1, 1) for multi-view and single views.
Vec2i whole_pixels_per_lens(const Optics& optics);

/// Returns the width and height of the area that one pixel sample covers at depth z (mm), which is the size of the texture
/// filter. Along an axis with lens power, the size is max(lens pitch, |z| m / g) with the pixel pitch m and the gap g. Along
/// other axes, it is the pixel pitch, scaled by perspective.
Vec2f sample_footprint_mm(const Optics& optics, float z_mm);

/// A lens array seen from the front. pitch_mm is measured along a row of pixels, row_pitch_mm perpendicular to it.
struct LensArray {
  double pitch_mm = 0.0;      ///< distance between lenses along a row of pixels, for any slant
  double row_pitch_mm = 0.0;  ///< distance between rows of lenses; 0: cylindrical lenses
  double gap_mm = 0.0;
  double viewing_distance_mm = 0.0;  ///< intended distance of the viewer, or infinity
  double eye_height_mm = 0.0;
  double cell_mm = 0.0;        ///< width of the panel area below one lens
  double slant_cosine = 1.0;   ///< cosine of a sheet's slant: lens_pitch_mm = pitch_mm * slant_cosine
  float lens_pitch_mm = 0.0f;  ///< distance between lenses, measured perpendicular to them
};

/// Returns the lenses of a lenticular sheet or a microlens array, or nothing for other optics.
std::optional<LensArray> lens_array(const Optics& optics);

/// Returns whether the optics are a lenticular sheet or a microlens array.
inline bool has_lenses(const Optics& optics) { return lens_array(optics).has_value(); }

/// The images of a plenoptic camera's main lens on its sensor, one below each microlens.
struct SensorLenses {
  double pitch_px = 0.0, row_pitch_px = 0.0;
  Vec2d centre_px{0.0};  ///< centre of one of the images
  LensPacking packing = LensPacking::kSquare;
};

/// Returns the images on the sensor of a plenoptic camera, or nothing for other optics.
std::optional<SensorLenses> sensor_lenses(const Optics& optics);

/// The arrangement of views in a quilt.
struct ViewTiles {
  int columns = 1, rows = 1;
  bool camera_grid = false;  ///< true: the eyes form a grid with the same columns and rows; false: all eyes lie in one row

  int count() const { return columns * rows; }
};

/// Returns the tiles of a quilt, or nothing for other optics, including single views.
std::optional<ViewTiles> view_tiles(const Optics& optics);

/// Returns whether the optics are a single pinhole.
bool is_single_view(const Optics& optics);

/// Returns the number of film pixels that lie side by side in a panel pixel: 3 for a slanted panel, otherwise 1.
int sub_pixels_per_pixel(const Optics& optics);

/// Returns the width and height of the film in pixels: the panel's pixels, or their sub-pixels side by side.
Vec2i film_size(const Optics& optics);

/// Returns the viewing distance that the display is made for, which may be infinite.
float viewing_distance_mm(const Optics& optics);

/// Returns the full horizontal angle of the viewing zone. For lens arrays, it is 2 atan(cell / (2 gap)), where the cell is the
/// width of the panel area below one lens. It is the view cone for multi-view and slanted panels, and 0 for a single view.
float viewing_zone(const Optics& optics);

/// Returns the |z| beyond which views alias, with the pixel pitch m, the lens pitch p, the gap g and the eye distance D:
/// - Lens arrays: p g / m. At this depth, a panel pixel seen through its lens is as wide as the lens pitch.
/// - Multi-view: m D / (e + m), where e is the distance between the two middle eyes. At this depth in front of the plane z = 0,
///   points move by one pixel between the two middle views.
/// - Slanted panels: p N / (2 tan(cone / 2)), because the N sub-pixels below a lens have slopes 2 tan(cone / 2) / N apart.
/// - Single views and tables of rays: infinity.
float depth_budget_mm(const Optics& optics);

/// Returns the same display with the differences between its views scaled by `parallax`, which is above 0. A view emitted at
/// the angle a shows the scene from the slope parallax * tan(a) instead of tan(a), so the scene looks `parallax` times as deep.
/// The plane z = 0 and the middle view do not change. Has no effect on single views and tables of rays.
Optics with_parallax(Optics optics, float parallax);

/// Returns the width and height of the visible part of the plane z = 0: the panel, or one view of a quilt.
Vec2f window_size_mm(const Optics& optics);

}  // namespace lippmann
