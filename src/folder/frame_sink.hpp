// Encodes and writes rendered frames in the background, a bounded number at a time, and records completed frames.
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

/// A video of all frames.
struct VideoFile {
  std::filesystem::path path;
  VideoOptions options;
};

class FrameSink {
 public:
  struct Settings {
    PictureParams pictures;
    const FrameLayout& layout;
    const Optics& optics;                          ///< optics of the films
    Encoding encoding = Encoding::kSrgb;           ///< encoding of the scene's values
    std::optional<double> crosstalk_to_undo = {};  ///< a sigma in the optics' pixels or views (optics/crosstalk.hpp)
    std::vector<VideoFile> videos = {};
    FormatOptions writing = {};                 ///< options of the light-field formats
    std::vector<ExrAttribute> about = {};       ///< attributes of EXR files
    int threads = 1;                            ///< rendering threads; writing uses up to half as many more
    std::function<void(Image)> done_with = {};  ///< called with the film of every written frame, on any thread; may be empty
    /// Called when a frame's files are written, with their size in bytes. Calls come in the order of frames, one at a time, on
    /// any thread. May be empty.
    std::function<void(int frame, std::uintmax_t bytes)> written = {};
    std::optional<OneSet> one_set = {};  ///< set if all frames are views of one data set
  };

  /// `folder` must outlive the sink, and nothing else may record in it during the sink's lifetime. Throws Error for videos that
  /// cannot be begun.
  FrameSink(const Settings& settings, RenderFolder& folder);
  /// Discards unwritten frames, and videos unless finish_videos() was called.
  ~FrameSink();
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;

  /// Queues a frame; frames must ascend. Blocks while the queue is full. If an earlier frame could not be written, throws its
  /// Error, but only once.
  void add(RenderedFrame rendered);

  /// Adds a frame whose picture exists, for the videos only, which read the picture from its file. Otherwise behaves like
  /// add().
  void add_kept(int frame);

  /// Waits until all frames are written. Throws the same Errors as add().
  void wait();

  /// Completes the videos; call after wait(). Returns whether each of the videos has a side file.
  bool finish_videos();

  /// Returns the results of undoing crosstalk, by frame; call after wait(). Empty if undoing crosstalk was not requested.
  const std::map<int, Precompensation>& precompensated() const;

  /// Returns the seconds spent so far on encoding and writing, summed over threads.
  double write_seconds() const;

  /// Returns the maximum number of films in memory for a number of rendering threads, including the one being traced.
  static int frames_in_memory(int threads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
