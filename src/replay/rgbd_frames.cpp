#include "replay/rgbd_frames.hpp"

#include <fmt/format.h>

#include <utility>

#include "layout/rgbd_picture.hpp"
#include "lippmann/layout/open_light_field.hpp"

namespace lippmann {

RgbdFrames::RgbdFrames(const std::filesystem::path& in, const FormatOptions& options)
    : files_(light_fields_in(in, "rgbd")), options_(options), one_(files_.front() == in && !is_video_name(in)) {
  if (files_.front() == in && is_video_name(in)) video_.emplace(in);
}

std::optional<RgbdFrame> RgbdFrames::next() {
  if (video_) return next_of_video();
  if (count_ == files_.size()) return std::nullopt;
  const std::filesystem::path& file = files_[count_++];
  return RgbdFrame{file.filename(), rgbd_format().read(file, options_)};
}

std::optional<RgbdFrame> RgbdFrames::next_of_video() {
  std::optional<Image8> picture = video_->next();
  if (!picture) return std::nullopt;
  const std::string where = fmt::format("{}, frame {}", first().string(), count_);
  return RgbdFrame{fmt::format("frame_{:04}.png", count_++),
                   light_field_of_rgbd(*std::exchange(picture, {}), first(), where, options_)};
}

}  // namespace lippmann
