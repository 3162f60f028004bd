#include "replay/replay_files.hpp"

#include <array>
#include <utility>

#include "image/exr.hpp"
#include "image/png.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "video/video_writer.hpp"

namespace lippmann {

ReplayFiles::ReplayFiles(Settings settings)
    : settings_(std::move(settings)), folder_(settings_.folder), video_folder_(settings_.video.parent_path()) {
  if (settings_.video.empty()) return;
  VideoOptions options;
  options.rate = frame_rate(settings_.frames_per_second);
  video_ = std::make_unique<VideoWriter>(settings_.video, options);
}

ReplayFiles::~ReplayFiles() = default;

void ReplayFiles::add(const std::string& name, const Image& picture, bool in_video) {
  written_.push_back(settings_.folder / (name + (settings_.exr ? ".exr" : ".png")));
  if (settings_.exr) write_exr(written_.back(), std::array{film_layer(picture, ExrSample::kFloat)});
  const bool to_video = in_video && video_;
  if (settings_.exr && !to_video) return;
  const Image8 codes = to_codes(picture, Encoding::kSrgb);
  if (!settings_.exr) write_png(written_.back(), codes);
  if (to_video) video_->add_frame(codes);
}

void ReplayFiles::add_depth(const std::string& name, const Image& depth) {
  written_.push_back(settings_.folder / (name + ".exr"));
  write_exr(written_.back(), std::array{depth_layer(depth)});
}

void ReplayFiles::finish() {
  if (!video_) return;
  video_->finish();
  written_.push_back(settings_.video);
}

}  // namespace lippmann
