// Where rendered frames go: encoded and written in the background, a bounded number at a time, recorded when complete.
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
    const Optics& optics;                          ///< the films'
    Encoding encoding = Encoding::kSrgb;           ///< how the scene's values become codes
    std::optional<double> crosstalk_to_undo = {};  ///< a sigma in the optics' pixels or views (optics/crosstalk.hpp)
    std::vector<VideoFile> videos = {};
    FormatOptions writing = {};                 ///< what the formats of light fields are told
    std::vector<ExrAttribute> about = {};       ///< attributes of EXR files
    int threads = 1;                            ///< that render; a share as many again write
    std::function<void(Image)> done_with = {};  ///< is given the film of every written frame, on any thread; may be empty
    /// Hears that a frame's pictures and layers are there, and how many bytes they have: in order, one at a time, on any
    /// thread; may be empty.
    std::function<void(int frame, std::uintmax_t bytes)> written = {};
    std::optional<OneSet> one_set = {};  ///< where all frames are views of one data set
  };

  /// `folder` outlives the sink; nothing else records in it meanwhile. Throws Error for videos that cannot be begun.
  FrameSink(const Settings& settings, RenderFolder& folder);
  /// Drops what is not written yet; videos that finish() has not completed leave nothing.
  ~FrameSink();
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;

  /// Takes a frame; frames come in ascending order. Waits while too many are under way. Throws the Error of an earlier frame
  /// that could not be written, once.
  void add(RenderedFrame rendered);

  /// Takes a frame whose picture is there already: only videos need it, and read it back. Like add() otherwise.
  void add_kept(int frame);

  /// Waits until all is written. Throws as add() does.
  void wait();

  /// Completes the videos, after wait(): without it, nothing remains of them. Returns whether each has a side file now.
  bool finish_videos();

  /// What undoing crosstalk has come to, by frame, after wait(); empty where it was not asked for.
  const std::map<int, Precompensation>& precompensated() const;

  /// Spent so far encoding and writing, summed over threads.
  double write_seconds() const;

  /// How many frames of film may exist at a time for that many rendering threads, the one being traced included.
  static int frames_in_memory(int threads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace lippmann
