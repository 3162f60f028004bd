#include "job/placed_job.hpp"

#include <utility>

#include "job/screen_for_stereo.hpp"
#include "job/screen_of_display.hpp"
#include "job/screen_of_params.hpp"
#include "lippmann/display/load_display.hpp"

namespace lippmann {
namespace {

std::unique_ptr<const Display> named_display(const std::string& name) {
  return name.empty() ? nullptr : std::make_unique<const Display>(load_display(name));
}

}  // namespace

Screen screen_of(const ResolvedJob& job, const Scene& scene, const Display* display) {
  const RenderParams& params = job.params();
  if (wants_stereo(params)) return screen_for_stereo(params, display);
  refuse_stereo_params(params.optics);
  return display ? screen_of_display(params, *display) : screen_of_params(params, scene);
}

PlacedJob place(const ResolvedJob& job, const Scene& scene) {
  PlacedJob placed_job;
  placed_job.display = named_display(job.params().optics.display);
  const Screen screen = screen_of(job, scene, placed_job.display.get());
  placed_job.array = fit_array(scene, screen.window_aspect, job.scene().view);
  const bool has_display = placed_job.display != nullptr, is_stereo = wants_stereo(job.params());
  Optics optics = screen.optics(placed_job.array);
  if (screen.keeps_viewer)
    placed_job.array.plane_height = placed_job.array.viewing_distance * window_size_mm(optics).y / viewing_distance_mm(optics);
  const bool fit_depth = fits_depth(job.params().optics.fit_depth, optics, has_display || is_stereo);
  placed_job.placed = placed_on(scene, placed_job.array, std::move(optics), fit_depth);
  placed_job.placed.for_display = has_display && !is_stereo;
  if (!placed_job.placed.cut.empty()) placed_job.array.how += " " + placed_job.placed.cut;
  return placed_job;
}

}  // namespace lippmann
