// Converts light fields with all kinds of data between all formats. Data must either come back, or be named as left out.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/regular_file.hpp"
#include "layout/light_fields.hpp"
#include "layout/posed_cameras.hpp"
#include "lippmann/formats/convert.hpp"
#include "lippmann/formats/formats.hpp"
#include "lippmann/formats/kept_data.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message, test::numbered_field, test::TempDir;
using testing::HasSubstr;

constexpr Vec2i kViewSize{8, 6};

/// Returns views with all data that need no cameras.
LightField base_field(ViewGrid grid) {
  LightField field = numbered_field(grid, kViewSize);
  const auto count = static_cast<std::size_t>(grid.count());
  field.alpha = Image(kViewSize.x, kViewSize.y * grid.count(), 1);
  for (std::size_t i = 0; i < field.alpha->data.size(); ++i) field.alpha->data[i] = static_cast<float>(i % 256) / 255.0f;
  field.splits = std::vector<Split>(count, Split::kTraining);
  field.splits->back() = Split::kValidation;
  field.times.emplace();
  for (std::size_t view = 0; view < count; ++view) field.times->push_back(0.25 * static_cast<double>(view));
  field.positions.emplace();
  for (std::size_t view = 0; view < count; ++view) field.positions->emplace_back(3.0 * static_cast<double>(view) - 1.5, 2.0);
  field.hci = HciNotes{.scene = "cotton", .authors = "Ada", .disparity_px = {-1.5, 2.0}};
  return field;
}

void add_depth(double plane_mm, LightField& field) {
  field.depth = Image(kViewSize.x, kViewSize.y * field.grid.count(), 1);
  for (std::size_t i = 0; i < field.depth->data.size(); ++i)
    field.depth->data[i] = static_cast<float>(plane_mm - (i % 3 == 0 ? 400.0 : 800.0));
}

LightField with_cameras(ViewGrid grid) {
  LightField field = base_field(grid);
  field.cameras = {500.0, Vec2d(0.5), 0.5 * Vec2d(kViewSize), {}};
  for (int view = 0; view < grid.count(); ++view)
    field.cameras->eyes_mm.emplace_back(20.0 * view - 10.0 * (grid.count() - 1), 0.0);
  field.points = {{{1.0, 0.5, -250.0}, {1, 2, 3}}, {{-0.5, 0.25, -100.0}, {255, 0, 128}}};
  field.depth_bounds_mm = std::vector<Vec2d>(static_cast<std::size_t>(grid.count()), Vec2d(350.0, 900.0));
  add_depth(500.0, field);
  return field;
}

LightField with_poses(ViewGrid grid) {
  LightField field = with_cameras(grid);
  field.cameras.reset(), field.positions.reset(), field.hci.reset();
  field.poses.emplace();
  for (int view = 0; view < grid.count(); ++view) {
    const double turn = 0.3 * view;
    const glm::dmat3 rotation(Vec3d(std::cos(turn), 0.0, -std::sin(turn)), Vec3d(0.0, 1.0, 0.0),
                              Vec3d(std::sin(turn), 0.0, std::cos(turn)));
    field.poses->push_back({kViewSize, Vec2d(20.0), 0.5 * Vec2d(kViewSize), rotation, Vec3d(30.0 * view, 5.0, 500.0)});
  }
  add_depth(0.0, field);
  return field;
}

LightField with_depth_of(int view, ViewGrid grid) {
  LightField field = with_cameras(grid);
  field.view_depth = ViewDepth{view, depth_of(field, view)};
  field.depth.reset();
  return field;
}

/// Returns one light field for each set of data that excludes another one. Single views have fewer sets.
std::vector<LightField> all_fields(ViewGrid grid) {
  std::vector<LightField> fields{with_cameras(grid)};
  fields.emplace_back(with_cameras(grid)).cameras->centre_px += Vec2d(1.0, -0.5);
  if (grid.count() == 1) return fields;
  fields.push_back(base_field(grid)), fields.push_back(with_poses(grid));
  for (const int view : {0, 1}) fields.push_back(with_depth_of(view, grid));
  LightField& wide = fields.emplace_back(with_cameras(grid));
  wide.cameras->pixel_mm = {1.0, 0.5}, wide.aspect *= 2.0;
  return fields;
}

Display panel() {
  Display display;
  display.pixels = {60, 41}, display.dpi = 100.0;
  display.calibration.pitch = 26.8, display.calibration.slope = -5.3, display.calibration.center = 0.37;
  display.quilt = DisplayQuilt{2, 1, 2 * kViewSize.x, kViewSize.y, 1.0};
  return display;
}

std::vector<LightFieldFormat> written_formats() {
  std::vector<LightFieldFormat> formats = light_field_formats();
  std::erase_if(formats, [](const LightFieldFormat& format) { return format.write == nullptr; });
  return formats;
}

/// Returns the view of `in` that a view of `out` shows. Only formats with one view leave out views.
int source_view(const LightField& in, const LightField& out, int view) {
  if (out.grid.count() == in.grid.count()) return view;
  return in.view_depth ? in.view_depth->view : in.grid.count() / 2;
}

/// The cameras relative to the first camera of `out`.
struct Seen {
  std::vector<PosedCamera> cameras;
  Vec3d point_mm{0.0};  ///< the first point of the cloud
};

Seen seen(const LightField& field, int first) {
  Seen seen{posed_cameras(field, "a"), {}};
  const PosedCamera origin = seen.cameras.at(static_cast<std::size_t>(first));
  const auto moved = [&](Vec3d place) { return glm::transpose(origin.rotation) * (place - origin.position_mm); };
  for (PosedCamera& camera : seen.cameras)
    camera.position_mm = moved(camera.position_mm), camera.rotation = glm::transpose(origin.rotation) * camera.rotation;
  if (!field.points.empty()) seen.point_mm = moved(field.points.front().position_mm);
  return seen;
}

bool has_cameras(const LightField& field) { return field.cameras || field.poses; }

bool same_cameras(const LightField& in, const LightField& out, bool also_axes) {
  if (!has_cameras(out)) return false;
  const int first = source_view(in, out, 0);
  const Seen a = seen(in, first), b = seen(out, 0);
  for (int view = 0; view < out.grid.count(); ++view) {
    const PosedCamera& before = a.cameras.at(static_cast<std::size_t>(source_view(in, out, view)));
    const PosedCamera& after = b.cameras.at(static_cast<std::size_t>(view));
    const Vec3d turned = before.rotation[2] - after.rotation[2];
    if (glm::distance(before.position_mm, after.position_mm) > 1e-3 || glm::length(turned) > 1e-6) return false;
    if (glm::distance(before.focal_px, after.focal_px) > 1e-3 * before.focal_px.x) return false;
    if (also_axes && glm::distance(before.principal_px, after.principal_px) > 1e-3) return false;
  }
  return true;
}

/// `from`, `to`: views of depth_in and depth_out. Maps of 16 bits are exact to 1e-3.
bool same_depth(const LightField& in, const Image& depth_in, const LightField& out, const Image& depth_out) {
  if (depth_in.data.size() != depth_out.data.size() || !has_cameras(out)) return false;
  for (std::size_t i = 0; i < depth_in.data.size(); ++i) {
    const double before = planar_depth_mm(in, depth_in.data[i]), after = planar_depth_mm(out, depth_out.data[i]);
    if (!(std::abs(after / before - 1.0) < 1e-3)) return false;
  }
  return true;
}

bool same_depths(const LightField& in, const LightField& out) {
  if (!out.depth) return false;
  for (int view = 0; view < out.grid.count(); ++view)
    if (!same_depth(in, depth_of(in, source_view(in, out, view)), out, depth_of(out, view))) return false;
  return true;
}

bool same_view_depth(const LightField& in, const LightField& out) {
  if (out.grid.count() == 1) return out.depth && same_depth(in, in.view_depth->depth, out, *out.depth);
  return out.view_depth && out.view_depth->view == in.view_depth->view &&
         same_depth(in, in.view_depth->depth, out, out.view_depth->depth);
}

bool same_points(const LightField& in, const LightField& out) {
  return out.points.size() == in.points.size() && has_cameras(out) &&
         glm::distance(seen(in, 0).point_mm, seen(out, 0).point_mm) < 1e-3;
}

bool same_alpha(const LightField& in, const LightField& out) {
  if (!out.alpha) return false;
  for (int view = 0; view < out.grid.count(); ++view) {
    const Image before = alpha_of(in, source_view(in, out, view)), after = alpha_of(out, view);
    for (std::size_t i = 0; i < before.data.size(); ++i)
      if (std::abs(before.data[i] - after.data[i]) > 0.1 / 255.0) return false;
  }
  return true;
}

template <class T>
bool same_values(const std::vector<T>& in, const std::optional<std::vector<T>>& out, double tolerance) {
  return out && std::ranges::equal(in, *out, [&](const T& a, const T& b) {
           if constexpr (std::is_same_v<T, double>)
             return std::abs(a - b) <= tolerance;
           else
             return glm::distance(a, b) <= tolerance;
         });
}

bool same_training_views(const LightField& in, const LightField& out) {
  return out.splits && std::ranges::equal(*in.splits, *out.splits,
                                          [](Split a, Split b) { return (a == Split::kTraining) == (b == Split::kTraining); });
}

/// Returns whether data that `in` has came back.
bool came_back(DataKind kind, const LightField& in, const LightField& out) {
  switch (kind) {
    case DataKind::kOtherViews:
      return out.grid.count() == in.grid.count();
    case DataKind::kCameras:
    case DataKind::kPoses:
      return same_cameras(in, out, false);
    case DataKind::kOffAxis:
      return same_cameras(in, out, true);
    case DataKind::kPositions:
      return same_values(*in.positions, out.positions, 1e-6);
    case DataKind::kPixelAspect:
      return std::abs(out.aspect / in.aspect - 1.0) < 0.01;
    case DataKind::kDepth:
      return same_depths(in, out);
    case DataKind::kViewDepth:
      return same_view_depth(in, out);
    case DataKind::kDepthBounds:
      return same_values(*in.depth_bounds_mm, out.depth_bounds_mm, 1e-6);
    case DataKind::kPoints:
      return same_points(in, out);
    case DataKind::kSplit:
      return same_training_views(in, out);
    case DataKind::kValidation:
      return out.splits && out.splits == in.splits;
    case DataKind::kTimes:
      return same_values(*in.times, out.times, 1e-9);
    case DataKind::kAlpha:
      return same_alpha(in, out);
    case DataKind::kHciNotes:
      return out.hci && out.hci->authors == in.hci->authors && out.hci->scene == in.hci->scene &&
             out.hci->disparity_px == in.hci->disparity_px;
  }
  return false;
}

/// Returns why llff refuses the cameras; empty if it accepts them.
std::string llff_refusal(const LightField& field) {
  for (const PosedCamera& camera : posed_cameras(field, "a")) {
    if (std::abs(camera.focal_px.x / camera.focal_px.y - 1.0) > 1e-6) return "not square";
    if (glm::distance(camera.principal_px, 0.5 * Vec2d(kViewSize)) > 1e-3) return "away from the middle";
  }
  return "";
}

/// Returns a part of the message with which a format refuses a light field; empty if it accepts it.
std::string refusal(const LightField& field, std::string_view to) {
  if (to == "stereo" && field.grid != ViewGrid{2, 1}) return "a stereo picture has the views of two eyes";
  if (to == "quad" && field.grid != ViewGrid{4, 1}) return "a quad has 4 views";
  if ((to == "miv" || to == "cvkit" || to == "nerf" || to == "colmap" || to == "llff") && !has_cameras(field))
    return "cannot be written";
  if (to == "llff") return llff_refusal(field);
  if (to == "hci" && field.cameras && std::abs(field.cameras->pixel_mm.x / field.cameras->pixel_mm.y - 1.0) > 1e-4)
    return "not square";
  if (to == "rgbd" && !field.cameras) return field.poses ? "share a plane" : "unknown";
  if (to == "rgbd" && !field.depth && !field.view_depth) return "no depth";
  return "";
}

/// Returns whether a format keeps data in another form: `native` and `stereo` resample views, `rgbd` has one view, and `llff`
/// states all cameras as poses.
bool changes_form(std::string_view format, DataKind kind) {
  return format == "native" || (format == "stereo" && kind == DataKind::kPixelAspect) ||
         (format == "rgbd" && kind == DataKind::kViewDepth) || (format == "llff" && kind == DataKind::kCameras);
}

FormatOptions options_for(const LightFieldFormat& format, ViewGrid grid) {
  FormatOptions options;
  options.with_depth = true;
  if (format.reads.views && format.name != "plenoptic") options.views = grid;
  if (format.name == "native") options.display = panel();
  return options;
}

/// Converts `in`, which lies in `path`, to a format, and compares the lost data with those that are named.
void expect_kept_or_named(const LightField& in, const LightFieldFormat& from, const fs::path& path, const LightFieldFormat& to,
                          const fs::path& folder) {
  const std::string what = fmt::format("{} to {}", from.name, to.name);
  ConvertParams params{.from = std::string(from.name), .to = std::string(to.name), .options = options_for(from, in.grid)};
  if (to.name == "native") params.options.display = panel();
  const fs::path out = folder / (to.is_folder ? "out" : "out.png");
  if (const std::string refused = refusal(in, to.name); !refused.empty()) {
    EXPECT_THAT(error_message([&] { convert(path, out, params); }), HasSubstr(refused)) << what;
    return;
  }
  const Converted converted = convert(path, out, params);
  const LightField back =
      to.read(to.is_folder ? out : converted.written.front(), options_for(to, to.name == "rgbd" ? ViewGrid{1, 1} : in.grid));
  std::vector<std::string> lost;
  for (const KeptData& row : kept_data()) {
    const std::string found = row.found(in);
    if (found.empty() || (row.kind == DataKind::kPixelAspect && to.name == "native")) continue;
    if (row.kind == DataKind::kCameras && is_for_displays(to.name)) continue;
    if (!came_back(row.kind, in, back)) lost.push_back(found);
  }
  EXPECT_EQ(converted.left_out, lost) << what;
}

TEST(KeptData, every_pair_keeps_or_names_all_data) {
  const std::vector<LightFieldFormat> formats = written_formats();
  std::set<std::pair<std::string_view, DataKind>> tried;
  for (const ViewGrid grid : {ViewGrid{2, 1}, ViewGrid{4, 1}, ViewGrid{1, 1}})
    for (const LightField& field : all_fields(grid))
      for (const LightFieldFormat& from : formats) {
        if (!refusal(field, from.name).empty() || from.name == "native") continue;
        const TempDir dir;
        const std::vector<fs::path> written = from.write(field, dir / (from.is_folder ? "in" : "in.png"), {});
        const fs::path path = from.is_folder ? dir / "in" : written.front();
        const LightField in = from.read(path, options_for(from, from.name == "rgbd" ? ViewGrid{1, 1} : field.grid));
        for (const KeptData& row : kept_data())
          if (!row.found(in).empty()) tried.emplace(from.name, row.kind);
        for (const LightFieldFormat& to : formats) {
          if (grid.count() > 2 && to.name != "quad" && from.name != "quad") continue;
          const TempDir out;
          expect_kept_or_named(in, from, path, to, out / "");
          if (HasFailure()) return;
        }
      }
  for (const KeptData& row : kept_data())
    for (const std::string_view format : row.formats)
      EXPECT_TRUE(changes_form(format, row.kind) || tried.contains({format, row.kind}))
          << format << " does not bring back " << row.name;
}

TEST(KeptData, rows_name_formats_that_are_written) {
  std::set<std::string_view> names;
  for (const LightFieldFormat& format : written_formats()) names.insert(format.name);
  for (const KeptData& row : kept_data())
    for (const std::string_view format : row.formats) EXPECT_TRUE(names.contains(format)) << row.name << ": " << format;
}

/// The table has a row for each list of formats. The row of rgbd states that it has one view.
TEST(KeptData, documentation_has_the_table) {
  const std::string text = read_file_text(fs::path(LIPPMANN_SOURCE) / "docs/reference/layouts.md", 1 << 20);
  std::set<std::string> names;
  for (const KeptData& row : kept_data()) {
    if (row.kind == DataKind::kOtherViews || !names.insert(std::string(row.name)).second) continue;
    std::string data(row.name), formats = fmt::format("`{}`", fmt::join(row.formats, "`, `"));
    for (const KeptData& other : kept_data())
      if (other.formats == row.formats && names.insert(std::string(other.name)).second) data += "; " + std::string(other.name);
    if (2 * row.formats.size() > written_formats().size() + 3) {
      std::vector<std::string_view> others;
      for (const LightFieldFormat& format : written_formats())
        if (!keeps(format.name, row.kind)) others.push_back(format.name);
      formats = fmt::format("all but `{}`", fmt::join(others, "`, `"));
    }
    EXPECT_THAT(text, HasSubstr(fmt::format("\n| {} | {} |\n", data, formats)));
  }
}

}  // namespace
}  // namespace lippmann
