#include "frames/frame_maker.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/printable.hpp"
#include "frames/error_bounded_frames.hpp"
#include "frames/exact_frames.hpp"
#include "frames/forward_frames.hpp"
#include "frames/forward_source.hpp"
#include "frames/traced_frames.hpp"
#include "lippmann/core/error.hpp"
#include "scene/deform.hpp"
#include "scene/splats.hpp"

namespace lippmann {
namespace {

/// Interpolation moves points with their nodes, so it supports only rigid objects.
void refuse_deforming_meshes(const Scene& scene) {
  const std::vector<bool> moves = moving_instances(scene);
  for (std::size_t i = 0; i < scene.instances.size(); ++i)
    if (moves[i] && is_posed(scene, scene.instances[i]))
      throw usage_error("reuse",
                        fmt::format("interpolated frames need rigid objects, and {} changes its shape (skin or morph targets)",
                                    shown(scene.instances[i].name)),
                        "copy, none or auto for this scene");
}

/// A point image has one point per pixel, but a ray can hit many splats.
void refuse_splats(const Scene& scene) {
  if (has_splats(scene))
    throw usage_error("reuse", "interpolated frames need one surface behind each pixel, and splats have many",
                      "copy, none or auto for this scene");
}

struct MakerOf {
  const MakerParts& parts;

  std::unique_ptr<FrameMaker> operator()(const AutoReuse&) const { return (*this)(TraceAll{}); }
  std::unique_ptr<FrameMaker> operator()(const TraceAll&) const { return make_traced_frames(parts); }
  std::unique_ptr<FrameMaker> operator()(const CopySettled& reuse) const { return make_exact_frames(parts, reuse); }
  std::unique_ptr<FrameMaker> operator()(const Interpolate& reuse) const {
    refuse_deforming_meshes(parts.stage.scene);
    refuse_splats(parts.stage.scene);
    if (reuse.min_psnr_db) return make_error_bounded_frames(parts, reuse);
    return make_forward_frames(parts, reuse);
  }
};

struct WorkingBytes {
  const Sampling& sampling;
  int frames;

  double operator()(const AutoReuse&) const { return (*this)(TraceAll{}); }
  double operator()(const TraceAll&) const { return traced_frames_bytes_per_pixel(sampling); }
  double operator()(const CopySettled&) const { return frames > 1 ? kExactFramesBytesPerPixel : 0.0; }
  double operator()(const Interpolate& reuse) const {
    return reuse.min_psnr_db ? error_bounded_frames_bytes_per_pixel() : forward_frames_bytes_per_pixel(reuse);
  }
};

struct SegmentLength {
  int operator()(const AutoReuse&) const { return 1; }
  int operator()(const TraceAll&) const { return 1; }
  int operator()(const CopySettled& reuse) const { return reuse.keyframes.value_or(1); }
  int operator()(const Interpolate& reuse) const {
    return reuse.min_psnr_db ? error_bounded_frames_per_segment(reuse) : key_frame_interval(reuse);
  }
};

}  // namespace

std::unique_ptr<FrameMaker> make_frame_maker(Stage& stage, const FrameParams& params, const ThreadPool& pool,
                                             const Context& context) {
  MakerParts parts{stage, params.sampling, pool, context};
  // A projected point belongs to one eye position, so views must not be filtered over angles.
  if (std::holds_alternative<Interpolate>(params.reuse)) parts.sampling.angular_filter = AngularFilter::kNone;
  return std::visit(MakerOf{parts}, resolved_reuse(params));
}

double working_bytes_per_pixel(const FrameParams& params, int frames) {
  return std::visit(WorkingBytes{params.sampling, frames}, resolved_reuse(params));
}

int frames_per_segment(const FrameParams& params) { return std::visit(SegmentLength{}, resolved_reuse(params)); }

}  // namespace lippmann
