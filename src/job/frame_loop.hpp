// The loop over the frames of a run: each is kept from before or made, reported, and given to be written.
#pragma once

#include <vector>

#include "folder/frame_sink.hpp"
#include "folder/render_folder.hpp"
#include "frames/frame_maker.hpp"
#include "job/render_setup.hpp"
#include "job/report.hpp"
#include "job/run_progress.hpp"
#include "lippmann/core/context.hpp"

namespace lippmann {

/// The state that the parts of a run share.
struct Run {
  RenderSetup& setup;
  RenderFolder& folder;
  RunProgress& progress;
  RenderReport& report;
  const Context& context;
};

class FrameLoop {
 public:
  /// `maker` and what `run` refers to outlive this. Videos that finish() is not called for leave nothing.
  FrameLoop(const Run& run, FrameMaker& maker, const std::vector<VideoFile>& videos);

  /// Takes frames in order, until the context is cancelled. Throws Error for a frame that cannot be written.
  void take(const std::vector<int>& frames);

  /// Gives frames that are in the folder to the videos.
  void add_kept(const std::vector<int>& frames);

  /// Waits until all is written. Throws as take() does.
  void wait();

  /// Completes the videos, after wait().
  void finish_videos();

  /// Spent so far encoding and writing, summed over threads.
  double write_seconds() const { return sink_.write_seconds(); }

 private:
  void keep(const FrameReport& kept);
  bool make(int frame);
  RenderedFrame rendered(int frame);

  Run run_;
  FrameMaker& maker_;
  std::vector<VideoFile> videos_;
  FrameSink sink_;
};

}  // namespace lippmann
