#include "live/live_passes.hpp"

#include <utility>

#include "folder/develop_frame.hpp"
#include "frames/frame_maker.hpp"
#include "job/test_pattern.hpp"
#include "job/undo_crosstalk.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/picture_file.hpp"
#include "lippmann/image/tone.hpp"
#include "live/view_rays.hpp"
#include "trace/first_hits.hpp"
#include "trace/trace_frame.hpp"
#include "view/disparity_codes.hpp"
#include "view/near_edges.hpp"

namespace lippmann {
namespace {

/// Number of pixels of a coarse image. One core traces them in a fraction of a second.
constexpr double kCoarsePixels = 48e3;
/// Samples per pixel of coarse, path-traced images. An image of few pixels with little noise shows more than a larger, noisy
/// image.
constexpr int kCoarsePaths = 4;

/// Returns the layout of a panel's image. The native layout converts a film of sub-pixels to pixels.
PictureParams layout_of_panel(const Optics& optics) {
  PictureParams as_shown;
  if (sub_pixels_per_pixel(optics) > 1) as_shown.layout = PictureLayout::kNative;
  return as_shown;
}

Image8 panel_codes(const LiveStage& live, RenderedFrame rendered) {
  const JobStage& stage = live.stage();
  const Optics& optics = stage.placed.optics;
  const FrameLayout as_shown(layout_of_panel(optics), optics, stage.display.get());
  develop_frame({as_shown, optics, tone_of(live.job().params().output.pictures), stage.scene.encoding,
                 crosstalk_to_undo(live.job().params(), optics, stage.display.get())},
                rendered);
  return to_codes(rendered.pictures.film, stage.scene.encoding);
}

LivePictures pictures_of(RenderedFrame rendered, const LiveStage& live, const PageFacts& facts) {
  Image8 panel = panel_codes(live, std::move(rendered));
  Image8 views = views_quilt({live.stage().placed.optics, to_linear(panel)}, facts, live.pool(), "preview");
  return {facts.view_size, std::move(views), std::move(panel)};
}

}  // namespace

std::optional<LivePictures> coarse_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context) {
  const RenderParams& params = live.job().params();
  if (live.job().is_test_pattern()) return std::nullopt;
  JobStage& stage = live.stage();
  const Vec2i size = coarse_view_size(facts, kCoarsePixels);
  const Optics rays = view_rays(stage.placed, facts, size);
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, live.pool());
  Sampling sampling = params.sampling;
  sampling.spp = facts_of(params.sampling).is_stochastic ? kCoarsePaths : 1;
  sampling.angular_filter = AngularFilter::kNone;
  sampling.lens = {};
  Image film;
  trace_frame({stage.device, rays, moment.world_from_display}, trace_params(sampling, stage), {live.pool(), context}, {film});
  if (context.cancelled) return std::nullopt;
  apply_tone(tone_of(params.output.pictures), film);
  return LivePictures{size, to_codes(film, stage.scene.encoding), std::nullopt};
}

std::optional<LivePictures> draft_pictures(LiveStage& live, const PageFacts& facts, int frame, const Context& context) {
  const RenderParams& params = live.job().params();
  if (!facts_of(params.sampling).is_stochastic || samples_per_pixel(params.sampling) <= 2 * kDraftSamples) return std::nullopt;
  FrameParams draft{params.sampling, AutoReuse{}};
  draft.sampling.spp = kDraftSamples;
  draft.sampling.aov.clear();
  check(draft, live.stage().placed.optics);
  RenderedFrame drawn = make_frame_maker(live.stage(), draft, live.pool(), context)->make(frame);
  if (context.cancelled) return std::nullopt;
  return pictures_of(std::move(drawn), live, facts);
}

std::optional<LivePictures> finished_pictures(LiveStage& live, const PageFacts& facts, int frame) {
  std::optional<RenderedFrame> rendered = live.frame(frame);
  if (!rendered) return std::nullopt;
  return pictures_of(std::move(*rendered), live, facts);
}

Image8 depth_picture(LiveStage& live, const PageFacts& facts, Vec2i view_size, int frame) {
  JobStage& stage = live.stage();
  const Optics rays = view_rays(stage.placed, facts, view_size);
  const Moment moment = stage.moment_at(frame);
  stage.device.update(moment.resolved, live.pool());
  FrameAovs layers;
  layers.want(Aov::kDepth);
  find_first_hits({stage.device, rays, moment.world_from_display}, live.job().params().sampling.order, nullptr, live.pool(),
                  layers);
  Image disparities = disparities_mm(layers[Aov::kDepth], facts.axes.vergence, stage.placed.depth_scale);
  spread_near_disparities(disparities, view_size, visible_jump_mm(facts, view_size));
  return disparity_codes(disparities, facts.disparity_scale_mm);
}

}  // namespace lippmann
