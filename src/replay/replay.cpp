#include "replay/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "replay/rendered_frames.hpp"
#include "replay/replay_files.hpp"
#include "replay/viewing.hpp"

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

/// Everything that the pictures of one replay share.
class Replay {
 public:
  Replay(const ReplayParams& params, const Context& context)
      : params_(params),
        context_(context),
        frames_(find_rendered_frames(params.in, params.report)),
        view_(params.view),
        pool_(resolved_threads(context)) {
    view_.eye_mm = params.eye_mm.value_or(default_eye_mm(frames_.optics));
    validate(view_);
    if (params.one_per_lens) view_.size = lens_grid(frames_.optics);
    check_size();
    if (params.ipd_mm && !(std::abs(*params.ipd_mm) <= 1e6))
      throw usage_error("--ipd", fmt::format("{} mm is no distance of eyes", *params.ipd_mm));
  }

  Replayed run() {
    ReplayFiles files(file_settings());
    for (std::size_t i = 0; i < frames_.files.size() && !context_.cancelled; ++i) {
      if (params_.ipd_mm) make_pair(i, files);
      if (!params_.ipd_mm && params_.sweep == 0) files.add("eye_" + label(i), view_of(i, view_.eye_mm), true);
    }
    for (int i = 0; i < params_.sweep && !context_.cancelled; ++i) make_sweep(i, files);
    if (!context_.cancelled) files.finish();
    return {files.written(), view_.eye_mm, warn_of_flips()};
  }

 private:
  void check_size() const {
    const Vec2i size = view_.size;
    if (size == Vec2i(0)) return;
    if (size.x < 1 || size.y < 1 || size.x > kMaxSide || size.y > kMaxSide || std::int64_t{size.x} * size.y > kMaxPixels)
      throw usage_error("--size", fmt::format("{}x{} pixels", size.x, size.y),
                        fmt::format("sides from 1 to {}, at most {} pixels", kMaxSide, kMaxPixels));
  }

  ReplayFiles::Settings file_settings() const {
    const fs::path beside = frames_.files.front().parent_path();
    return {params_.folder.empty() ? beside / "replay" : params_.folder, params_.exr, params_.video,
            params_.frames_per_second.value_or(frames_.frames_per_second)};
  }

  std::string label(std::size_t frame) const { return frame_label(frames_.files[frame]); }

  /// The panel of a frame; the last one asked for is kept.
  const RenderedPanel& panel(std::size_t frame) {
    if (!panel_ || panel_frame_ != frame) panel_ = read_rendered_panel(frames_, frame), panel_frame_ = frame;
    return *panel_;
  }

  Image view_of(std::size_t frame, Vec3d eye_mm) {
    EyeView view = view_;
    view.eye_mm = eye_mm;
    return eye_view(panel(frame), view, pool_);
  }

  void make_pair(std::size_t frame, ReplayFiles& files) {
    const Vec3d half(0.5 * *params_.ipd_mm, 0.0, 0.0);
    const Image left = view_of(frame, view_.eye_mm - half), right = view_of(frame, view_.eye_mm + half);
    files.add("left_" + label(frame), left);
    files.add("right_" + label(frame), right);
    files.add("pair_" + label(frame), side_by_side(left, right), !params_.sweep);
  }

  /// The i-th of equal parts of the zone, from its middle; of many frames, the animation goes on meanwhile.
  void make_sweep(int i, ReplayFiles& files) {
    const double share = (i + 0.5) / params_.sweep;
    Vec3d eye = view_.eye_mm;
    eye.x = zone_x_mm(frames_.optics, share, eye.z);
    const auto frame = static_cast<std::size_t>(i) * frames_.files.size() / static_cast<std::size_t>(params_.sweep);
    files.add(fmt::format("sweep_{:04}", i), view_of(frame, eye), true);
  }

  double warn_of_flips() const {
    const double share = share_out_of_zone(frames_.optics, viewer_at(view_.eye_mm));
    if (share > 0.0)
      context_.warning(
          fmt::format("The eye at ({:.4g}, {:.4g}, {:.4g}) mm is out of the viewing zone of {:.3g} % of the "
                      "display: there it sees neighbouring lenses' pictures.",
                      view_.eye_mm.x, view_.eye_mm.y, view_.eye_mm.z, 100.0 * share));
    return share;
  }

  const ReplayParams& params_;
  const Context& context_;
  RenderedFrames frames_;
  EyeView view_;
  ThreadPool pool_;
  std::optional<RenderedPanel> panel_;
  std::size_t panel_frame_ = 0;
};

}  // namespace

Replayed replay(const ReplayParams& params, const Context& context) { return Replay(params, context).run(); }

}  // namespace lippmann
