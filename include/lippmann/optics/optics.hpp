// Every output picture as a set of rays that cross the display plane: panel, models, and the two contracts they all keep.
//
// Display frame: right-handed, millimetres, x right, y up, z towards the viewer. The lens (or display) plane is z = 0, the
// panel lies at z = -gap. Pixel (i, j): i from the left, j from the top; continuous pixel coordinates have their origin at the
// top left corner of the panel, so pixel centres are at + 0.5. Pixel pitch m: x = (x_px - W/2) m, y = (H/2 - y_px) m.
//
// Lens arrays are pinhole per lens. The ray of a panel point q below lens centre l leaves towards the viewer along l - q; what
// is traced is the same line from the viewer's side: it starts at z = z_front and runs towards -z, so that one ray covers the
// space in front of the array and behind it, the picture is orthoscopic and occlusion right across z = 0.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "lippmann/core/math.hpp"

namespace lippmann {

/// The panel as it is built, in whole square pixels. What is traced is its film (film_size): the same pixels, or the sub-pixels
/// of each side by side.
struct Panel {
  int width = 512, height = 512;  ///< pixels
  float pixel_pitch_mm = 0.125f;  ///< 0.125 makes an 8-pixel lens 1 mm wide
};

/// Cylindrical lenses; horizontal parallax only. Across-lens coordinate: xi = x cos(slant) + y sin(slant).
/// Lens k has its centre at xi = offset_mm + k lens_pitch_mm, all integers k: by default a lens boundary lies at x = 0.
struct LenticularSheet {
  float lens_pitch_mm = 1.0f;
  float gap_mm = 2.0f;
  float slant = 0.0f;                     ///< radians, |slant| < pi/2
  float offset_mm = 0.5f;                 ///< xi of the centre of lens 0
  float viewing_distance_mm = kInfinity;  ///< to which the cells converge; inf: straight below their lenses
  float eye_height_mm = 0.0f;             ///< y that rows converge to at a finite viewing distance
  float parallax = 1.0f;                  ///< see with_parallax
};

enum class LensPacking { kSquare, kHexagonal };

/// Spherical lenslets; full parallax. Hexagonal: rows lens_pitch * sqrt(3)/2 apart, odd rows shifted by half a pitch; a pixel
/// belongs to the lens whose cell centre is nearest.
struct MicrolensArray {
  LensPacking packing = LensPacking::kSquare;
  float lens_pitch_mm = 1.0f;
  float gap_mm = 2.0f;
  Vec2f offset_mm{0.5f, 0.5f};  ///< centre of lens (0, 0)
  float viewing_distance_mm = kInfinity;
  float parallax = 1.0f;  ///< see with_parallax
};

/// A grid of views (a quilt), every view an off-axis (sheared) pinhole through the same rectangle of z = 0. View 0 is the
/// leftmost and bottom left tile, the last one top right; view v: angle cone ((v + 1/2)/N - 1/2), eye at (distance tan(angle),
/// 0, distance). With a baseline the eyes stand in a camera grid instead, as data sets of vision research have them: columns
/// and rows baseline apart in the plane z = distance, the middle of the grid on the axis; views as before, column 0 at the left
/// and row 0 at the bottom.
struct MultiView {
  int columns = 8, rows = 6;         ///< tiles; the panel holds columns x rows of them, each of the same size
  float view_cone = radians(40.0f);  ///< full angle that the N views spread over
  bool cone_ends_included = false;   ///< v / (N - 1) instead of (v + 1/2) / N, as some tools do
  float distance_mm = 500.0f;        ///< from the viewer to the plane z = 0
  float baseline_mm = 0.0f;          ///< above 0: a camera grid, whose eyes are so far apart; the cone has no meaning then
  float pixel_height = 1.0f;         ///< in pixel widths: tiles whose pixels, stretched to a display, are not square there
  float parallax = 1.0f;             ///< see with_parallax
  Vec2f eye_shift{0.0f};             ///< all eyes, to the right and up, in steps from view to view (optics/angular_filter.hpp)
  float eye_height_mm = 0.0f;        ///< all eyes, above the middle of the plane z = 0
};

/// One pinhole at (0, eye_height, distance) through the rectangle of the panel in z = 0.
struct SingleView {
  float distance_mm = 500.0f;
  Vec2f pixel_offset{0.0f};  ///< sample points are shifted by this many pixels (x right, y down)
  float eye_height_mm = 0.0f;
};

/// Where the sub-pixels of each panel pixel lie, in panel pixels from the pixel's centre, x right, y up: [row from the bottom,
/// modulo 4][column modulo 2][red, green, blue]. Panels that arrange them otherwise than in stripes repeat within that.
using SubPixelOffsets = std::array<std::array<std::array<Vec2f, 3>, 2>, 4>;

/// Stripes, as on most panels: a third of a pixel apart, red on the left (or blue).
SubPixelOffsets striped_sub_pixels(bool blue_first = false);

/// A panel below slanted lenses that was calibrated: its own frame, every sub-pixel with its own ray (slanted_panel.hpp has the
/// formula). The film of a panel of W x H pixels is 3 W x H: film pixel (3 i + c, j) is the sub-pixel of colour c of panel
/// pixel (i, j). Phases: double, as the last one of thousands of lenses has to be as right as the first.
struct SlantedPanel {
  double periods = 244.041;  ///< P: lenses across the panel, along a row
  double tilt = -0.190476;   ///< T: the panel's widths that a lens shifts over the panel's height
  double center = 0.447;     ///< phase where a sub-pixel itself lies: of a striped panel, the calibration's less P / 3 W
  bool inverted = true;      ///< v = 1 - fract(phase), else fract(phase)
  float view_cone = radians(40.0f);  ///< full angle that v from 0 to 1 spreads over
  float distance_mm = 500.0f;        ///< from the viewer to the plane z = 0
  SubPixelOffsets sub_pixels = striped_sub_pixels();
  float parallax = 1.0f;       ///< see with_parallax
  float eye_height_mm = 0.0f;  ///< of the viewer, above the middle of the panel
};

struct Ray {
  Vec3f origin{0.0f};                  ///< mm
  Vec3f direction{0.0f, 0.0f, -1.0f};  ///< unit length, z < 0
};

/// Optics that are known by their rays alone: those of a simulated lens, a measured display, or any function from pixel to ray
/// (make_ray_table). Pixels are traced, and denoised over their neighbours on the panel: without an inverse and without views,
/// such pictures are not interpolated, laid out as views or replayed.
struct RayTable {
  /// Row by row from the top left, panel.width * samples_per_side to a row, panel.height * samples_per_side rows: the ray of a
  /// sample is that of the part of the pixel it lies in. Every ray starts at its own origin. Copies of optics share them.
  std::shared_ptr<const std::vector<Ray>> rays;
  int samples_per_side = 1;  ///< 4: 16 rays a pixel, among which the samples of a pixel choose
  float spread = 0.0f;       ///< mm per mm of depth by which neighbouring pixels' rays part: textures are filtered to it
};

using OpticsModel = std::variant<LenticularSheet, MicrolensArray, MultiView, SingleView, SlantedPanel, RayTable>;

/// One complete set of rays. For MultiView, panel.pixel_pitch_mm is the pitch within a row of a view in the plane z = 0.
struct Optics {
  Panel panel;
  OpticsModel model;
  float z_front_mm = kInfinity;  ///< rays start at this z; inf: one that suits the model, see resolved_z_front_mm
  float z_back_mm = kInfinity;   ///< rays end at z = -z_back
};

/// Rays of many pixels, each array `count` long.
struct RayArrays {
  float *origin_x, *origin_y, *origin_z;
  float *direction_x, *direction_y, *direction_z;
};

/// Calls ray_of_point(Vec2f) for the middle of every part of every pixel, in continuous pixel coordinates, row by row.
template <class RayOfPoint>
RayTable make_ray_table(const Panel& panel, int samples_per_side, const RayOfPoint& ray_of_point) {
  auto rays = std::make_shared<std::vector<Ray>>();
  const float part = 1.0f / static_cast<float>(samples_per_side);
  for (int j = 0; j < panel.height * samples_per_side; ++j)
    for (int i = 0; i < panel.width * samples_per_side; ++i) rays->push_back(ray_of_point((Vec2f(i, j) + 0.5f) * part));
  return {std::move(rays), samples_per_side, 0.0f};
}

/// Throws Error naming the field for sizes, pitches, gaps, angles and distances that make no rays (zero-area lenses, NaN,
/// panels above 2^31 pixels), saying what would be accepted.
void validate(const Optics& optics);

// ---- Contract 1: the ray of a pixel ---------------------------------------------------------------------------------

/// Where rays start, z_front_mm resolved: as given where it is finite; else at the viewing distance, and 4 panel diagonals in
/// front of a lens array that is viewed from infinity. Rays of views and of slanted panels start at their eye at the farthest,
/// those of a table at their own origins: then it is the z of the foremost one.
float resolved_z_front_mm(const Optics& optics);

/// The ray of a point of the film in continuous pixel coordinates (pixel (i, j) at its centre: i + 0.5, j + 0.5).
Ray ray_of_pixel(const Optics& optics, Vec2f pixel);

/// The same for `count` points, bit-identical to ray_of_pixel, vectorised. Many calls for one frame: see ray_generator.hpp.
void rays_of_pixels(const Optics& optics, const float* pixel_x, const float* pixel_y, int count, const RayArrays& rays);

// ---- Contract 2: all pixels that see a point ------------------------------------------------------------------------

/// Appends, in ascending lens (view) order, the continuous pixel coordinates from which a ray runs exactly through `point_mm`:
/// one per lens whose cell holds the image of the point, one per view for multi-view, one per lens (as a rule) for a slanted
/// panel, from left to right. Points are clipped to the panel.
/// At z = 0 every pixel below the lens that holds the point sees it; then all of that cell's pixel centres are given (below a
/// cylindrical lens: those in the panel row that runs through the point). A quilt's padding and rays' ends see nothing. Throws
/// Error for a table of rays, which has no inverse.
void pixels_seeing(const Optics& optics, Vec3f point_mm, std::vector<Vec2f>& pixels);

// ---- What others ask of an array ------------------------------------------------------------------------------------

/// Pixels per lens across and down where both are whole and aligned with the pixel grid ((N, 1) for a lenticular sheet), so
/// that pixel (i, j) has lens (i / N.x, j / N.y) and directional view (i mod N.x, j mod N.y); (0, 0) where no such structure
/// exists, as on a slanted panel. A multi-view panel and a single view give (1, 1).
Vec2i whole_pixels_per_lens(const Optics& optics);

/// The width that one pixel's sampling represents at depth z (mm), across and along the array: what textures are filtered to.
/// max(lens pitch, |z| m / g) where a lens has power, the panel's own spacing (scaled by perspective) where it has none. Of a
/// slanted panel: a pixel, which neighbouring lenses resolve together though one does not, or what a sub-pixel magnifies to.
Vec2f sample_footprint_mm(const Optics& optics, float z_mm);

/// Lenses side by side, as they are seen from in front. Numbers along a row of pixels, mm.
struct LensArray {
  double pitch_mm = 0.0;      ///< from lens to lens along the row, whatever the slant
  double row_pitch_mm = 0.0;  ///< from row to row of lenses; 0: cylinders, which have power across only
  double gap_mm = 0.0;
  double viewing_distance_mm = 0.0;  ///< to which the cells converge; may be inf
  double eye_height_mm = 0.0;
  double cell_mm = 0.0;        ///< width of the panel's part below one lens
  double slant_cosine = 1.0;   ///< cosine of a sheet's slant: pitch_mm times this is the pitch across its lenses
  float lens_pitch_mm = 0.0f;  ///< across the lenses
};

/// The lenses of a lenticular sheet or a microlens array; none of other optics.
std::optional<LensArray> lens_array(const Optics& optics);

/// Whether its pixels lie behind lenses of an array: a lenticular sheet or a microlens array.
inline bool has_lenses(const Optics& optics) { return lens_array(optics).has_value(); }

/// Views side by side.
struct ViewTiles {
  int columns = 1, rows = 1;
  bool camera_grid = false;  ///< columns and rows are those of the eyes, too; else all eyes stand in one row

  int count() const { return columns * rows; }
};

/// The tiles of a quilt; none of other optics, single views among them.
std::optional<ViewTiles> view_tiles(const Optics& optics);

/// One pinhole, whose picture is shown as it is.
bool is_single_view(const Optics& optics);

/// How many pixels of the film, side by side, make one of the panel: 3 of a slanted panel, else 1.
int sub_pixels_per_pixel(const Optics& optics);

/// Width and height of what is traced, in pixels of the film: the panel's, or their sub-pixels side by side.
Vec2i film_size(const Optics& optics);

/// Where the viewer stands whom the display is made for; inf: the cells of its lenses run parallel.
float viewing_distance_mm(const Optics& optics);

/// Viewing zone, full angle: 2 atan(cell / 2 gap) across; the cone for multi-view and slanted panels; 0 for a single view.
float viewing_zone(const Optics& optics);

/// Beyond |z| = this a panel pixel is wider than the lens pitch: p g / m. Of multi-view: where in front of the plane the middle
/// views are a pixel apart, m D / (e + m) with e between their eyes: beyond, views alias. inf for a single view and a table. A
/// slanted panel of N sub-pixels below a lens of pitch p sends them into N directions, 2 tan(cone / 2) / N apart: p N / (2
/// tan(cone / 2)).
float depth_budget_mm(const Optics& optics);

/// The same display, its views drawn that much nearer together (0 < parallax): a view from where the display sends its light at
/// an angle a is that of an eye at parallax tan(a) instead of tan(a), so that the scene looks `parallax` times as deep. The
/// plane z = 0, the view from the middle and all that the functions above say of the display stay as they are. Of a lens: its
/// pixels' offsets from the cell's centre count so much less. No effect on a single view or a table of rays.
Optics with_parallax(Optics optics, float parallax);

/// Width and height of what is seen of the plane z = 0: the panel, or one view of a quilt.
Vec2f window_size_mm(const Optics& optics);

}  // namespace lippmann
