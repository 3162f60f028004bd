// The loop over the frames of a run. A frame is kept from an earlier run, or rendered and passed to the writer.
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

struct Run {
  RenderSetup& setup;
  RenderFolder& folder;
  RunProgress& progress;
  RenderReport& report;
  const Context& context;
};

class FrameLoop {
 public:
  /// `maker` and the objects that `run` refers to must outlive this object. Unfinished videos are discarded unless
  /// finish_videos() is called.
  FrameLoop(const Run& run, FrameMaker& maker, const std::vector<VideoFile>& videos);

  /// Renders or keeps `frames` in order until the context is cancelled. Throws Error if a frame cannot be written.
  void take(const std::vector<int>& frames);

  /// Adds frames that already exist in the folder to the videos.
  void add_kept(const std::vector<int>& frames);

  /// Waits until all files are written. Throws Error if a frame cannot be written.
  void wait();

  /// Call this after wait().
  void finish_videos();

  /// Seconds of encoding and writing so far, summed over threads.
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
