// A light field in memory: the views of one moment, and their cameras if known.
//
// Views are numbered as in layout/view_layout.hpp: column 0 is seen by the leftmost eye, row 0 by the lowest.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/posed_camera.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/view_cameras.hpp"

namespace lippmann {

/// A point of the point cloud that some formats, such as COLMAP, store with the pictures.
struct CloudPoint {
  Vec3d position_mm{0.0};
  std::array<unsigned char, 3> rgb{};  ///< sRGB codes
};

/// The part of a data set that a view belongs to.
enum class Split { kTraining, kValidation, kTest };

/// Depth of a single view.
struct ViewDepth {
  int view = 0;
  Image depth{};  ///< as LightField::depth, for this view
};

/// Entries of HCI's parameters.cfg that LightField has no other member for. The defaults are those of files that we write.
struct HciNotes {
  double fstop = 100.0;
  /// Pose of the middle camera in its scene: position, and Euler angles about x, then y, then z.
  std::optional<Vec3d> centre_camera_m = {};
  Vec3d centre_camera_rad{0.0};
  std::string scene{}, category = "synthetic", date{}, version = "v0", authors{}, contact{};
  Vec2d disparity_px{0.0}, frustum_disparity_px{0.0};  ///< least and greatest, between neighbouring cameras; both 0: unknown
  double depth_map_scale = 1.0;

  bool operator==(const HciNotes&) const = default;
};

struct LightField {
  Picture stack{};  ///< views stacked vertically, view 0 on top
  ViewGrid grid{};
  Vec2i view_size{0, 0};
  /// Width / height of the display, or else of the source picture.
  double aspect = 1.0;
  std::optional<ViewGrid> tiles = {};       ///< tiles of the quilt that the views came from
  int bits = 0;                             ///< significant bits per sample in the source; 0: all
  std::optional<Image> depth = {};          ///< stack of z in mm, above 0 in front of the plane z = 0; -inf: no surface
  std::optional<ViewCameras> cameras = {};  ///< none: unknown, or stored in `poses`
  /// Position of each view's eye, x right and y up. The file states neither unit nor origin (Stanford format).
  std::optional<std::vector<Vec2d>> positions = {};
  /// One camera per view, instead of `cameras`, if the cameras are rotated or do not show the same rectangle of a plane. Depth
  /// is then z in each camera's own frame, in mm.
  std::optional<std::vector<PosedCamera>> poses = {};
  /// Nearest and farthest planar depth in mm that the file states for each view (LLFF).
  std::optional<std::vector<Vec2d>> depth_bounds_mm = {};
  std::vector<CloudPoint> points = {};            ///< points of the file (COLMAP), in the coordinates of `poses` or `cameras`
  std::optional<std::vector<Split>> splits = {};  ///< one per view; none: the file has no split
  std::optional<std::vector<double>> times = {};  ///< one per view, in the file's unit (nerf)
  std::optional<ViewDepth> view_depth = {};       ///< depth of the only view that has depth, if the grid has more views
  /// Stack of opacities (1 channel, 0 to 1); none: opaque. Colours of codes are not multiplied by them, floats are.
  std::optional<Image> alpha = {};
  std::optional<HciNotes> hci = {};
  bool lacks_some_depth = false;  ///< true: `depth` is none because only some views have depth; the reader has warned
};

/// Returns one camera per view. Cameras of a common plane look along -z of the display frame. Throws Error naming `where` if
/// the cameras are unknown.
std::vector<PosedCamera> posed_cameras(const LightField& field, const std::string& where);

/// Returns width / height of a view's pixels. Rounds results near 1 to 1, because the view size is rounded to whole pixels.
double pixel_aspect(const LightField& field);

inline Vec2i stack_size(const LightField& field) { return {field.view_size.x, field.view_size.y * field.grid.count()}; }

Vec2i size_of(const Picture& picture);

/// Returns a black picture with the sample type of `like`.
Picture blank(const Picture& like, Vec2i size);

/// Copies to[to_pixel[i]] = from[from_pixel[i]]. An empty list means 0, 1, 2, ... Both pictures must have the same sample type.
void move_pixels(const Picture& from, const std::vector<std::uint32_t>& from_pixel, Picture& to,
                 const std::vector<std::uint32_t>& to_pixel);
void move_pixels(const Image& from, const std::vector<std::uint32_t>& from_pixel, Image& to,
                 const std::vector<std::uint32_t>& to_pixel);

/// Return one view of the stack, or the depth or the opacities of one view.
Picture view_of(const LightField& field, int view);
Image depth_of(const LightField& field, int view);
Image alpha_of(const LightField& field, int view);

/// Replace one view, or the depth or the opacities of one view. `picture` must have the size and sample type of the views,
/// `depth` and `alpha` 1 channel. If no view had opacities before, the others become opaque.
void set_view(LightField& field, int view, const Picture& picture);
void set_depth(LightField& field, int view, const Image& depth);
void set_alpha(LightField& field, int view, const Image& alpha);

/// Index of view v counted from the top left, row by row.
inline int from_top_left(const ViewGrid& grid, int v) {
  return (grid.rows - 1 - v / grid.columns) * grid.columns + v % grid.columns;
}

}  // namespace lippmann
