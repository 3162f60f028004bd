// A light field in memory: the views of one moment, and what is known of the cameras that saw them. Every format that
// `convert` reads becomes one, and every format that it writes is made from one (layout/formats.hpp).
//
// Views are numbered as in layout/view_layout.hpp: column 0 is seen by the leftmost eye, row 0 by the lowest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/core/math.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/layout/posed_camera.hpp"
#include "lippmann/layout/view_layout.hpp"
#include "lippmann/optics/view_cameras.hpp"

namespace lippmann {

struct LightField {
  Picture stack;  ///< the views one below the other, view 0 on top
  ViewGrid grid;
  Vec2i view_size{0, 0};
  double aspect = 1.0;                 ///< width / height of the display they are made for, else of the picture they came from
  std::optional<ViewGrid> tiles = {};  ///< how the quilt that they came from lays them out
  int bits = 0;                        ///< how many a code has in the file they came from; 0: as many as in the stack
  std::optional<Image> depth = {};     ///< a stack likewise: z in mm, above 0 in front of z = 0; -inf: nothing there
  std::optional<ViewCameras> cameras = {};  ///< where they are known
  /// Position of each view's eye, right and up, in a unit and from an origin that the files do not state (Stanford).
  std::optional<std::vector<Vec2d>> positions = {};
  /// By view, of cameras that are turned or do not share a plane, instead of `cameras`. Depth is then z of each camera's own
  /// frame, in mm: the planar depth times -1.
  std::optional<std::vector<PosedCamera>> poses = {};
};

/// The cameras of a light field, by view; those of one plane look along -z of the display frame. Throws Error naming `where`
/// if they are unknown.
std::vector<PosedCamera> posed_cameras(const LightField& field, const std::string& where);

/// The size of the stack of all views.
inline Vec2i stack_size(const LightField& field) { return {field.view_size.x, field.view_size.y * field.grid.count()}; }

Vec2i size_of(const Picture& picture);

/// A black picture of the same kind of samples.
Picture blank(const Picture& like, Vec2i size);

/// to[to_pixel[i]] = from[from_pixel[i]]; an empty list counts up. Both of one kind of samples.
void move_pixels(const Picture& from, const std::vector<std::uint32_t>& from_pixel, Picture& to,
                 const std::vector<std::uint32_t>& to_pixel);
void move_pixels(const Image& from, const std::vector<std::uint32_t>& from_pixel, Image& to,
                 const std::vector<std::uint32_t>& to_pixel);

/// One view of a stack.
Picture view_of(const LightField& field, int view);
Image depth_of(const LightField& field, int view);

/// Puts a picture (or a depth image of 1 channel) in the place of a view. Both are of its size and kind.
void set_view(LightField& field, int view, const Picture& picture);
void set_depth(LightField& field, int view, const Image& depth);

/// View v of rows counted from the top: what other tools number from the top left, row by row.
inline int from_top_left(const ViewGrid& grid, int v) {
  return (grid.rows - 1 - v / grid.columns) * grid.columns + v % grid.columns;
}

}  // namespace lippmann
