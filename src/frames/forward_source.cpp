#include "frames/forward_source.hpp"

#include <algorithm>
#include <utility>

namespace lippmann {

ForwardParams forward_params(const Sampling& sampling, const Interpolate& reuse) {
  ForwardParams forward;
  forward.splat = {reuse.splat, !reuse.no_z_buffer};
  forward.fill = reuse.fill;
  if (reuse.min_psnr_db) forward.floor = FloorParams{*reuse.min_psnr_db, sampling.seed};
  forward.order = sampling.order;
  forward.wants_provenance = wanted_aovs(sampling).wants(Aov::kProvenance);
  return forward;
}

ForwardSource trace_source(const MakerParts& parts, const Interpolate& reuse, int frame, const InBetweenMaker& maker) {
  const auto& [stage, sampling, pool, context] = parts;
  const FrameClock clock(pool);
  ForwardSource source;
  PointImage& image = source.image;
  image.moment = stage.moment_at(frame);
  stage.device.update(image.moment.resolved, pool);
  source.report.frame = frame;
  source.report.kind = "key";
  TouchedBlocks blocks;
  source.report.rays = trace_frame(stage.shot(image.moment), trace_params(sampling, stage), {pool, context},
                                   {image.film, nullptr, &image.points, reuse.min_psnr_db ? &blocks : nullptr});
  image.rays = std::move(blocks.rays);
  maker.prepare(image, pool);
  clock.add_to(source.report);
  return source;
}

FrameReport in_between_report(int frame, const InBetweenCounts& counts, const RayCounts& rays, Vec2i film) {
  FrameReport report;
  report.frame = frame;
  report.kind = "in-between";
  report.rays = rays;
  report.missed_pixels = counts.missed;
  report.newly_visible_pixels = counts.causes.newly_visible;
  report.not_covered_pixels = counts.causes.not_covered;
  report.retraced_pixels = counts.retraced;
  const std::uint64_t pixels = static_cast<std::uint64_t>(film.x) * static_cast<std::uint64_t>(film.y);
  report.reused_pixels = pixels - std::max(counts.missed, counts.retraced);
  return report;
}

}  // namespace lippmann
