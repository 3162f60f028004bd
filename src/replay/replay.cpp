#include "replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/optics/viewing.hpp"
#include "lippmann/replay/all_in_focus.hpp"
#include "lippmann/replay/disparity.hpp"
#include "lippmann/replay/epipolar_image.hpp"
#include "lippmann/replay/light_field_frames.hpp"
#include "lippmann/replay/refocus.hpp"
#include "optics/model.hpp"
#include "replay/replay_files.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxSide = 65536;
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;

Image side_by_side(const Image& left, const Image& right) {
  Image pair(2 * left.width, left.height, 3);
  for (int y = 0; y < left.height; ++y) {
    std::copy_n(left.pixel(0, y), 3 * left.width, pair.pixel(0, y));
    std::copy_n(right.pixel(0, y), 3 * left.width, pair.pixel(left.width, y));
  }
  return pair;
}

/// The nearest depth of the focal stack is white, the farthest black. sRGB codes are linear in depth.
Image depth_preview(const Image& depth, const std::vector<double>& depths_mm) {
  const double near = std::max(depths_mm.front(), depths_mm.back()), far = std::min(depths_mm.front(), depths_mm.back());
  Image grey(depth.width, depth.height, 3);
  for (std::size_t i = 0; i < grey.data.size(); ++i) {
    const double share = near > far ? (depth.data[i / 3] - far) / (near - far) : 0.0;
    grey.data[i] = static_cast<float>(linear_from_srgb(std::clamp(share, 0.0, 1.0)));
  }
  return grey;
}

double depth_mm(const Optics& optics, const FocusPlane& plane, const char* parameter) {
  const double z_mm = plane.in_px ? depth_of_disparity_px(optics, plane.value, parameter) : plane.value;
  validate_depth(optics, z_mm, parameter);
  return z_mm;
}

class Replay {
 public:
  Replay(const ReplayParams& params, const Context& context)
      : params_(params),
        context_(context),
        frames_(find_light_field_frames(params.in, with_warnings(params.field, context))),
        view_(params.view),
        pool_(resolved_threads(context)) {
    if (!frames_.assumption.empty()) context.warning(frames_.assumption);
    view_.eye_mm = params.eye_mm.value_or(default_eye_mm(frames_.optics));
    validate(view_);
    if (params.one_per_lens) view_.size = lens_grid(frames_.optics);
    check_size();
    check_products();
  }

  Replayed run() {
    ReplayFiles files(file_settings());
    for (std::size_t i = 0; i < frames_.files.size() && !context_.cancelled; ++i) {
      if (params_.ipd_mm) make_pair(i, files);
      if (refocus_mm_) keep(files, "refocus_" + label(i), refocused(i, *refocus_mm_));
      if (params_.focal_stack) make_stack(i, files);
      if (params_.epi_row) keep(files, "epi_row_" + label(i), epipolar_row(panel(i), *params_.epi_row, view_.filter, context_));
      if (params_.epi_column)
        keep(files, "epi_column_" + label(i), epipolar_column(panel(i), *params_.epi_column, view_.filter, context_));
      if (!has_other_products()) keep(files, "eye_" + label(i), view_of(i, view_.eye_mm), true);
    }
    for (int i = 0; i < params_.sweep && !context_.cancelled; ++i) make_sweep(i, files);
    if (!context_.cancelled) files.finish();
    if (!has_eye_views()) return {files.written(), std::nullopt, 0.0};
    return {files.written(), view_.eye_mm, warn_of_flips()};
  }

 private:
  void check_size() const {
    const Vec2i size = view_.size;
    if (size == Vec2i(0)) return;
    if (size.x < 1 || size.y < 1 || size.x > kMaxSide || size.y > kMaxSide || std::int64_t{size.x} * size.y > kMaxPixels)
      throw usage_error("size", fmt::format("cannot be {}x{} pixels", size.x, size.y),
                        fmt::format("sides from 1 to {}, at most {} pixels", kMaxSide, kMaxPixels));
  }

  bool has_other_products() const {
    return params_.ipd_mm || params_.sweep > 0 || params_.refocus || params_.focal_stack || params_.epi_row ||
           params_.epi_column;
  }

  bool has_eye_views() const { return !has_other_products() || params_.ipd_mm || params_.sweep > 0; }

  void check_products() {
    if (params_.ipd_mm && !(std::abs(*params_.ipd_mm) <= 1e6))
      throw usage_error("ipd", fmt::format("{} mm is out of range", *params_.ipd_mm), "-1000000 to 1000000");
    if (params_.refocus) refocus_mm_ = depth_mm(frames_.optics, *params_.refocus, "refocus");
    for (int i = 0; params_.focal_stack && i < params_.focal_stack->count; ++i)
      stack_mm_.push_back(depth_mm(frames_.optics, params_.focal_stack->plane(i), "focal-stack"));
    if (params_.all_in_focus && !params_.focal_stack)
      throw usage_error("all-in-focus", "needs a range of depths", "`focal-stack` Z0:Z1:N");
    if (!params_.video.empty() && has_other_products() && !params_.ipd_mm && params_.sweep == 0)
      throw usage_error("video", "has no effect without eye views",
                        "`ipd` or `sweep`, or no `refocus`, `focal-stack` and `epi`");
  }

  ReplayFiles::Settings file_settings() const {
    return {params_.folder.empty() ? frames_.folder / "replay" : params_.folder, params_.exr, params_.video,
            params_.frames_per_second.value_or(frames_.frames_per_second)};
  }

  std::string label(std::size_t frame) const { return frame_label(frames_.files[frame]); }

  const RenderedPanel& panel(std::size_t frame) {
    if (!panel_ || panel_frame_ != frame) panel_ = frames_.read(frame), panel_frame_ = frame;
    return *panel_;
  }

  Image view_of(std::size_t frame, Vec3d eye_mm) {
    EyeView view = view_;
    view.eye_mm = eye_mm;
    return eye_view(panel(frame), view, pool_, context_);
  }

  Image refocused(std::size_t frame, double z_mm, Image* disagreement = nullptr) {
    return refocus(panel(frame), z_mm, view_.size, pool_, disagreement, context_);
  }

  /// A cancelled replay writes nothing, because the image may be unfinished.
  void keep(ReplayFiles& files, const std::string& name, const Image& picture, bool in_video = false) const {
    if (!context_.cancelled) files.add(name, picture, in_video);
  }

  void make_pair(std::size_t frame, ReplayFiles& files) {
    const std::vector<Vec3d> pair = eyes();
    const Image left = view_of(frame, pair[0]), right = view_of(frame, pair[1]);
    if (context_.cancelled) return;  // a pair must not contain unfinished images
    files.add("left_" + label(frame), left);
    files.add("right_" + label(frame), right);
    files.add("pair_" + label(frame), side_by_side(left, right), !params_.sweep);
  }

  void make_stack(std::size_t frame, ReplayFiles& files) {
    std::optional<AllInFocus> sharpest;
    Image disagreement;
    for (std::size_t i = 0; i < stack_mm_.size(); ++i) {
      const Image picture = refocused(frame, stack_mm_[i], &disagreement);
      if (context_.cancelled) return;
      if (!params_.all_in_focus) files.add(fmt::format("stack_{}_{:02}", label(frame), i), picture);
      if (!sharpest) sharpest.emplace(frames_.optics, Vec2i(picture.width, picture.height));
      sharpest->add(picture, disagreement, stack_mm_[i]);
    }
    if (!params_.all_in_focus) return;
    files.add("all_in_focus_" + label(frame), sharpest->picture());
    files.add_depth("depth_" + label(frame), sharpest->depth());
    files.add("depth_" + label(frame), depth_preview(sharpest->depth(), stack_mm_));
  }

  /// Makes image i of the sweep. The viewing zone is divided into equal parts, and the eye is in the middle of part i. The
  /// animation advances during the sweep.
  void make_sweep(int i, ReplayFiles& files) {
    const double share = (i + 0.5) / params_.sweep;
    Vec3d eye = view_.eye_mm;
    eye.x = zone_x_mm(frames_.optics, share, eye.z);
    const auto frame = static_cast<std::size_t>(i) * frames_.files.size() / static_cast<std::size_t>(params_.sweep);
    keep(files, fmt::format("sweep_{:04}", i), view_of(frame, eye), true);
  }

  /// Returns both eyes of a pair, the single eye, or the middle eye of a sweep.
  std::vector<Vec3d> eyes() const {
    if (!params_.ipd_mm) return {view_.eye_mm};
    const Vec3d half(0.5 * *params_.ipd_mm, 0.0, 0.0);
    return {view_.eye_mm - half, view_.eye_mm + half};
  }

  /// Warns about eyes outside the viewing zone. Returns the largest fraction of the display on which an eye sees a neighbouring
  /// viewing zone.
  double warn_of_flips() const {
    double most = 0.0;
    for (const Vec3d& eye : eyes()) {
      const double share = share_out_of_zone(frames_.optics, viewer_at(eye));
      most = std::max(most, share);
      if (share > 0.0)
        context_.warning(fmt::format(
            "For {3:.3g} % of the display, the eye at ({0:.4g}, {1:.4g}, {2:.4g}) mm is outside the viewing zone and "
            "sees {4}.",
            eye.x, eye.y, eye.z, 100.0 * share, view_out_of_zone()));
    }
    return most;
  }

  const char* view_out_of_zone() const {
    const OpticsFacts facts = optics_facts(frames_.optics);
    if (facts.repeats_beyond_zone) return "the pictures of neighbouring lenses";
    return facts.tiles && facts.tiles->camera_grid ? "the outermost cameras' pictures" : "the views of the next cone";
  }

  const ReplayParams& params_;
  const Context& context_;
  LightFieldFrames frames_;
  EyeView view_;
  ThreadPool pool_;
  std::optional<RenderedPanel> panel_;
  std::size_t panel_frame_ = 0;
  std::optional<double> refocus_mm_;
  std::vector<double> stack_mm_;
};

}  // namespace

Replayed replay(const ReplayParams& params, const Context& context) { return Replay(params, context).run(); }

}  // namespace lippmann
