// Encodes and writes rendered frames in the background, and records finished frames in the journal. The number of
// frames in memory is limited.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "folder/frame_files.hpp"
#include "folder/frame_layout.hpp"
#include "folder/picture_params.hpp"
#include "folder/render_folder.hpp"
#include "frames/frame.hpp"
#include "image/exr.hpp"
#include "lippmann/image/encoding.hpp"
#include "lippmann/layout/precompensation.hpp"
#include "video/video_writer.hpp"

namespace lippmann {

struct VideoFile {
  std::filesystem::path path;
  VideoOptions options;
};

class FrameSink {
 public:
  struct Settings {
    PictureParams pictures;
    const FrameLayout& layout;
    const Optics& optics;
    Encoding encoding = Encoding::kSrgb;  ///< encoding of the scene's values
    /// Crosstalk to correct: the standard deviation of the Gaussian blur (optics/crosstalk.hpp), in pixels, or in views
    /// for a quilt.
    std::optional<double> crosstalk_to_undo = {};
    std::vector<VideoFile> videos = {};
    FormatOptions writing = {};
    std::vector<ExrAttribute> about = {};
    /// Number of rendering threads. Writing uses additional threads, at most half this number.
    int threads = 1;
    /// Called with the film of every written frame, on any thread. May be empty.
    std::function<void(Image)> done_with = {};
    /// Called when the files of a frame are written, with their total size in bytes. The calls come one at a time and in the
    /// order of frames, but on any thread. May be empty.
    std::function<void(int frame, std::uintmax_t bytes)> written = {};
    std::optional<OneSet> one_set = {};  ///< all frames are views of a single data set
  };

  /// `folder` must outlive the sink. Nothing else may record files in it during the sink's lifetime. Throws Error if a
  /// video cannot be begun.
  FrameSink(const Settings& settings, RenderFolder& folder);
  /// Discards unwritten frames, and the videos unless finish_videos() was called.
  ~FrameSink();
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;

  /// Queues a frame, in ascending order. Blocks while the queue is full. If an earlier frame could not be written,
  /// throws its Error once.
  void add(RenderedFrame rendered);

  /// Adds a frame of an earlier run to the videos. Reads the frame's picture from its file. Blocks and throws like add().
  void add_kept(int frame);

  /// Waits until all frames are written. Throws the same Errors as add().
  void wait();

  /// Call this after wait(). Returns whether the videos have side files.
  bool finish_videos();

  /// Results of the crosstalk correction by frame. Call this after wait().
  const std::map<int, Precompensation>& precompensated() const;

  /// Seconds of encoding and writing so far, summed over threads.
  double write_seconds() const;

  /// Returns the maximum number of films in memory, including the film that is being traced.
  static int frames_in_memory(int threads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
