// cameras.json of MIV and RVS (MPEG's immersive video and its view synthesizer): one entry per view.
//
// Positions are metres forward, left, up; angles degrees; depth codes of b bits (2^b - 1) (1/z - 1/far) / (1/near - 1/far), 0:
// nothing there.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lippmann/layout/light_field.hpp"

namespace lippmann {

struct MivCamera {
  std::string name;  ///< the name of the view's picture, without its ending
  double position_m[3] = {0.0, 0.0, 0.0}, rotation_deg[3] = {0.0, 0.0, 0.0};
  double near_m = 0.1, far_m = 100.0;
  Vec2i resolution{0, 0};
  Vec2d focal_px{0.0}, principal_point_px{0.0};
};

/// Throws Error naming `where` for what is no such file, holds no camera or more than 4096, or cameras that are not
/// perspective, have names that are paths, or numbers that are none.
std::vector<MivCamera> parse_miv_cameras(const std::string& text, const std::string& where);

/// `depth`: whether maps of depth lie beside the views.
std::string miv_cameras_text(const std::vector<MivCamera>& cameras, const std::string& content, bool depth);

/// Sorts cameras in the order of views: row by row upwards, each to the right.
void sort_as_views(std::vector<MivCamera>& cameras);

/// The grid of sorted cameras: `views`; or as many rows as there are heights, if all hold as many views; else one row. Throws a
/// usage Error for `views` of another number, naming `where`.
ViewGrid grid_of_cameras(const std::vector<MivCamera>& cameras, std::optional<ViewGrid> views, const std::string& where);

/// By view. Eyes all in one plane; the plane in which the views coincide lies distance_mm before it.
std::vector<MivCamera> miv_cameras(const ViewCameras& cameras, Vec2i view_size, const std::vector<std::string>& names,
                                   double near_m, double far_m);

/// The inverse, of cameras in the order of views; none where they are not parallel, not in one plane, or do not look through
/// one rectangle.
std::optional<ViewCameras> cameras_of_miv(const std::vector<MivCamera>& cameras);

}  // namespace lippmann
