#include "lippmann/formats/kept_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace lippmann {
namespace {

std::string counted(std::size_t count, std::string_view noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::string other_views(const LightField& field) {
  return field.grid.count() > 1 ? counted(static_cast<std::size_t>(field.grid.count() - 1), "other view") : "";
}

std::string cameras(const LightField& field) {
  return field.cameras ? "the cameras of " + counted(field.cameras->eyes_mm.size(), "view") : "";
}

std::string poses(const LightField& field) {
  if (!field.poses) return "";
  return fmt::format("the poses of {}, which do not share a plane and a window", counted(field.poses->size(), "camera"));
}

/// Cameras include the positions.
std::string positions(const LightField& field) {
  return field.positions && !field.cameras ? "camera positions without a unit" : "";
}

std::string off_axis(const LightField& field) {
  constexpr double kSeen_px = 0.01;
  if (!field.cameras) return "";
  Vec2d middle(0.0);
  for (const Vec2d& eye : field.cameras->eyes_mm) middle += eye / static_cast<double>(field.cameras->eyes_mm.size());
  const Vec2d axis_px = field.cameras->centre_px + middle * Vec2d(1.0, -1.0) / field.cameras->pixel_mm;
  const Vec2d off_px = glm::abs(axis_px - 0.5 * Vec2d(field.view_size));
  if (!(std::max(off_px.x, off_px.y) > kSeen_px)) return "";
  return fmt::format("the shift of the pictures by {:.4g} x {:.4g} pixels off the axes of their cameras", off_px.x, off_px.y);
}

std::string pixel_shape(const LightField& field) {
  const double aspect = pixel_aspect(field);
  return aspect == 1.0 ? "" : fmt::format("the shape of the pixels, {:.4g} times as wide as high", aspect);
}

std::string depth(const LightField& field) {
  return field.depth ? "the depth of " + counted(static_cast<std::size_t>(field.grid.count()), "view") : "";
}

std::string view_depth(const LightField& field) { return field.view_depth ? "the depth of one view" : ""; }

std::string depth_bounds(const LightField& field) { return field.depth_bounds_mm ? "nearest and farthest depths" : ""; }

std::string points(const LightField& field) { return field.points.empty() ? "" : counted(field.points.size(), "point"); }

std::string split(const LightField& field) { return field.splits ? "the split into training and test views" : ""; }

std::string validation(const LightField& field) {
  const auto count = field.splits ? std::ranges::count(*field.splits, Split::kValidation) : 0;
  return count > 0 ? "the difference between test views and " + counted(static_cast<std::size_t>(count), "validation view")
                   : "";
}

std::string times(const LightField& field) { return field.times ? "the times of the views" : ""; }

std::string alpha(const LightField& field) { return field.alpha ? "the transparency of the pictures" : ""; }

std::string hci_notes(const LightField& field) {
  if (!field.hci) return "";
  const HciNotes& notes = *field.hci;
  const HciNotes usual;
  const Vec3d on_axis(0.0, 0.0, field.cameras ? 1e-3 * field.cameras->distance_mm : 0.0);
  const bool is_posed = glm::distance(notes.centre_camera_m.value_or(on_axis), on_axis) > 1e-9 ||
                        notes.centre_camera_rad != usual.centre_camera_rad;
  std::string names;
  const auto add = [&](const char* name, bool differs) {
    if (differs) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  add("center_cam", is_posed);
  add("fstop", notes.fstop != usual.fstop);
  add("category", notes.category != usual.category);
  add("date", notes.date != usual.date);
  add("version", notes.version != usual.version);
  add("authors", notes.authors != usual.authors);
  add("contact", notes.contact != usual.contact);
  return names.empty() ? "" : "entries of parameters.cfg: " + names;
}

bool is_with_cameras(DataKind kind) {
  return kind == DataKind::kCameras || kind == DataKind::kDepth || kind == DataKind::kViewDepth || kind == DataKind::kHciNotes;
}

}  // namespace

const std::vector<KeptData>& kept_data() {
  using enum DataKind;
  static const std::vector<KeptData> rows{
      {kOtherViews,
       "views other than the middle one",
       {"integral", "quilt", "views", "hci", "stanford", "jpeg-pleno", "eslf", "miv", "nerf", "colmap", "llff", "stereo",
        "quad", "native", "cvkit", "lytro"},
       other_views},
      {kCameras,
       "cameras in one plane",
       {"views", "hci", "stanford", "eslf", "miv", "nerf", "colmap", "llff", "rgbd", "cvkit"},
       cameras},
      {kPoses, "cameras of any pose", {"miv", "nerf", "colmap", "llff", "cvkit"}, poses},
      {kPositions, "positions without a unit", {"views", "stanford", "eslf"}, positions},
      {kOffAxis, "off-axis pictures", {"views", "eslf", "miv", "nerf", "colmap", "rgbd", "cvkit"}, off_axis},
      {kPixelAspect,
       "non-square pixels",
       {"quilt", "views", "eslf", "miv", "nerf", "colmap", "stereo", "rgbd", "native", "cvkit"},
       pixel_shape},
      {kDepth, "depth maps", {"hci", "miv", "nerf", "rgbd", "cvkit"}, depth},
      {kViewDepth, "depth of one view", {"hci", "rgbd"}, view_depth},
      {kDepthBounds, "depth bounds", {"llff"}, depth_bounds},
      {kPoints, "points", {"colmap"}, points},
      {kSplit, "training and test views", {"nerf", "colmap", "llff"}, split},
      {kValidation, "validation views", {"nerf"}, validation},
      {kTimes, "times", {"nerf"}, times},
      {kAlpha,
       "transparency",
       {"integral", "quilt", "views", "hci", "stanford", "eslf", "miv", "nerf", "colmap", "llff", "quad", "cvkit", "lytro"},
       alpha},
      {kHciNotes, "other entries of `parameters.cfg`", {"hci", "stanford"}, hci_notes}};
  return rows;
}

bool keeps(std::string_view format, DataKind kind) {
  const KeptData& row = *std::ranges::find(kept_data(), kind, &KeptData::kind);
  return std::ranges::find(row.formats, format) != row.formats.end();
}

bool is_for_displays(std::string_view format) {
  constexpr std::array<std::string_view, 5> kFormats{"integral", "quilt", "stereo", "quad", "native"};
  return std::ranges::find(kFormats, format) != kFormats.end();
}

bool uses_depth(std::string_view format) {
  return keeps(format, DataKind::kDepth) || keeps(format, DataKind::kPoints) || keeps(format, DataKind::kDepthBounds);
}

std::vector<LostData> lost_data(const LightField& field, std::string_view format) {
  const bool has_square_pixels = field.cameras && std::abs(field.cameras->pixel_mm.x / field.cameras->pixel_mm.y - 1.0) < 1e-4;
  const bool writes_cameras = field.poses     ? keeps(format, DataKind::kPoses)
                              : field.cameras ? keeps(format, DataKind::kCameras) && (format != "stanford" || has_square_pixels)
                                              : false;
  // Below square lenses, a view has one pixel per lens, so the number of views determines the shape of its pixels.
  const double lens_aspect = static_cast<double>(field.grid.columns) / field.grid.rows;
  const bool has_lens_aspect = format == "integral" && std::abs(pixel_aspect(field) / lens_aspect - 1.0) < 0.01;
  std::vector<LostData> lost;
  for (const KeptData& row : kept_data()) {
    bool is_kept = keeps(format, row.kind);
    if (is_with_cameras(row.kind)) is_kept = is_kept && writes_cameras;
    if (row.kind == DataKind::kPixelAspect) is_kept = is_kept || has_lens_aspect;
    if (row.kind == DataKind::kCameras) is_kept = is_kept || is_for_displays(format);
    if (is_kept) continue;
    if (std::string found = row.found(field); !found.empty()) lost.push_back({row.kind, std::move(found)});
  }
  return lost;
}

}  // namespace lippmann
