// Renders frames of an animation into memory.
#pragma once

#include <map>
#include <vector>

#include "frames/frame_maker.hpp"
#include "job/job_stage.hpp"
#include "job/reuse_params.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/image/metrics.hpp"

namespace lippmann::test {

struct MadeFrames {
  std::map<int, RenderedFrame> frames;
  std::vector<FrameReport> sources;
  int pixels = 0;

  const FrameReport& report(int number) const { return frames.at(number).report; }
  const std::vector<float>& film(int number) const { return frames.at(number).pictures.film.data; }

  std::map<int, std::vector<float>> films() const {
    std::map<int, std::vector<float>> all;
    for (const auto& [number, frame] : frames) all[number] = frame.pictures.film.data;
    return all;
  }
};

inline MadeFrames make_frames(const RenderParams& given, const std::vector<int>& frames, int threads = 2) {
  const ResolvedJob job(given);
  const Context context;
  const ThreadPool pool(threads);
  JobStage stage(job, pool, context);
  const auto maker = make_frame_maker(stage, frame_params(job), pool, context);
  MadeFrames made;
  for (const int frame : frames) made.frames[frame] = maker->make(frame);
  made.sources = maker->sources();
  made.pixels = stage.placed.optics.panel.width * stage.placed.optics.panel.height;
  return made;
}

inline std::vector<int> frames_from(int first, int last) {
  std::vector<int> frames;
  for (int frame = first; frame <= last; ++frame) frames.push_back(frame);
  return frames;
}

inline RenderParams small_scene(const char* name = "teapot") {
  RenderParams params;
  params.scene.name = name;
  params.optics.lenses = {16, 0};
  params.reuse.choice = ReuseChoice::kNone;
  return params;
}

inline RenderParams with_reuse(RenderParams params, const ReuseParams& reuse) {
  params.reuse = reuse;
  return params;
}

inline double psnr_between(const MadeFrames& reference, const MadeFrames& made, int number) {
  const auto codes = [&](const MadeFrames& of) { return to_codes(of.frames.at(number).pictures.film, Encoding::kSrgb); };
  return measure_difference(codes(reference), codes(made)).psnr_db;
}

}  // namespace lippmann::test
