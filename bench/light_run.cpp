#include "bench/light_run.hpp"

#include <fmt/core.h>

#include <memory>
#include <utility>

#include "frames/frame_maker.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"
#include "lippmann/layout/film_views.hpp"
#include "lippmann/scene/load.hpp"

namespace lippmann::bench {
namespace {

/// Far from the seeds of the measured frames, so that they share no paths.
constexpr std::uint32_t kReferenceSeed = 1u << 20;

JobScene scene_of(const LightCase& row, const Context& context) {
  if (!row.build) return load_scene_of(ResolvedJob(row.params), context);
  Scene scene = row.build();
  validate(scene, row.name);
  return {std::move(scene), {}};
}

Frames means_of(const References& references) {
  Frames frames;
  for (const Reference& reference : references) frames.push_back(mean_of(reference));
  return frames;
}

}  // namespace

Sampling with_samples(Sampling sampling, int spp, Denoise denoise) {
  sampling.spp = spp, sampling.denoise = denoise;
  return sampling;
}

LightBench::LightBench(const LightCase& row, const Request& request, const Context& context)
    : row_(row),
      request_(request),
      context_(context),
      pool_(resolved_threads(context)),
      stage_(scene_of(row, context), ResolvedJob(row.params), pool_) {
  const Vec2i size = film_size();
  const LightField field = light_field_of(Image(size.x, size.y, 3), stage_.placed.optics);
  views_ = {field.grid, field.view_size};
  Sampling sampling = with_samples(row.params.sampling, row.reference_spp, Denoise::kNone);
  sampling.seed = kReferenceSeed;
  reference_maker_.emplace(stage_, sampling, reference_folder(request.references), pool_, context, request.say);
  const std::string name = std::filesystem::path(row.name).stem().string();
  for (int f = 0; f < row.count; ++f) references_.push_back(reference_maker_->frame(name, row.first + f));
}

Vec2i LightBench::film_size() const { return lippmann::film_size(stage_.placed.optics); }

void LightBench::judge(LightFigures& figures) const {
  figures.psnr_db = psnr_db(mean_squared_error(references_, figures.frames));
  figures.block_psnr_db = psnr_db(block_squared_error(references_, figures.frames, views_.view_size));
  figures.edge_psnr_db = psnr_db(edge_squared_error(references_, figures.frames, views_.view_size));
  figures.mean_light = mean_light_ratio(references_, figures.frames);
  const Frames converged = means_of(references_);
  figures.view_flicker = view_flicker(figures.frames, views_) - view_flicker(converged, views_);
  figures.frame_flicker = frame_flicker(figures.frames) - frame_flicker(converged);
  for (std::size_t f = 0; f < references_.size(); ++f)
    figures.psnr_db_by_frame.push_back(psnr_db(mean_squared_error({references_[f]}, {figures.frames[f]})));
}

std::vector<LightFigures> LightBench::measure(const std::vector<Sampling>& ways) {
  std::vector<std::unique_ptr<FrameMaker>> makers;
  for (const Sampling& way : ways) {
    RenderParams params = row_.params;
    params.sampling = way;
    makers.push_back(make_frame_maker(stage_, frame_params(ResolvedJob(params)), pool_, context_));
  }
  std::vector<LightFigures> figures(ways.size());
  for (int frame = row_.first; frame < row_.first + row_.count; ++frame)
    for (std::size_t w = 0; w < ways.size(); ++w) {
      begin_step(request_, context_, fmt::format("{}, frame {}: {} samples", row_.name, frame, samples_per_pixel(ways[w])));
      RenderedFrame made = makers[w]->make(frame);
      std::size_t nan_count = 0;
      figures[w].frames.push_back(
          to_codes(views_of_layer(made.pictures.film, stage_.placed.optics), stage_.scene.encoding, &nan_count));
      if (nan_count > 0) throw Error(row_.name, fmt::format("frame {}: {} samples are not numbers", frame, nan_count));
      figures[w].cpu_seconds += made.report.cpu_seconds;
      figures[w].reports.push_back(std::move(made.report));
      makers[w]->recycle(std::move(made.pictures.film));
    }
  for (LightFigures& way : figures) judge(way);
  return figures;
}

}  // namespace lippmann::bench
