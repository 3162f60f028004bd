#include "compare/frame_source.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "core/folder_entries.hpp"
#include "core/printable.hpp"
#include "core/recorded_file.hpp"
#include "core/text_pattern.hpp"
#include "formats/frame_names.hpp"
#include "formats/light_field_source.hpp"
#include "image/read_image.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "video/video_reader.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pictures_in(const fs::path& folder) {
  std::vector<fs::path> pictures;
  for (const fs::directory_entry& entry : entries_of(folder))
    if (!entry.is_directory() && is_picture_name(entry.path())) pictures.push_back(entry.path());
  const auto is_frame = [](const fs::path& path) { return path.filename().string().starts_with("frame_"); };
  if (std::any_of(pictures.begin(), pictures.end(), is_frame))
    std::erase_if(pictures, [&](const fs::path& path) { return !is_frame(path); });
  std::sort(pictures.begin(), pictures.end(),
            [](const fs::path& a, const fs::path& b) { return natural_less(a.stem().string(), b.stem().string()); });
  return pictures;
}

class PictureFiles : public FrameSource {
 public:
  PictureFiles(SourceKind kind, std::vector<fs::path> files, PictureWarning warn)
      : kind_(kind), files_(std::move(files)), warn_(std::move(warn)) {}

  SourceKind kind() const override { return kind_; }

  std::optional<Item> next() override {
    if (position_ == files_.size()) return std::nullopt;
    const fs::path file = files_[position_++];
    if (position_ == 1) warn_of_left_out(file);
    return Item{file.stem().string(), [file, this] { return load(file); }};
  }

  std::vector<std::string> names() const override {
    std::vector<std::string> names;
    for (const fs::path& file : files_) names.push_back(file.stem().string());
    return names;
  }

 private:
  /// Called only for the first image of a folder, because all images have the same channels.
  void warn_of_left_out(const fs::path& file) const {
    if (!warn_) return;
    const LeftOutChannels left_out = left_out_channels(file);
    if (left_out.alpha) warn_(fmt::format("{}: alpha is not compared.", file.string()));
    if (!left_out.others.empty())
      warn_(fmt::format("{}: only its colours are compared, not {}.", file.string(),
                        shown(fmt::format("{}", fmt::join(left_out.others, ", ")))));
  }

  Image8 load(const fs::path& file) const {
    if (sample_kind(file) != SampleKind::kFloat) return read_image8(file, warn_);
    const Image picture = read_rgb(file, warn_);
    const auto strange =
        std::count_if(picture.data.begin(), picture.data.end(), [](float sample) { return !std::isfinite(sample); });
    if (strange > 0 && warn_)
      warn_(fmt::format("{}: {} of its {} samples are NaN or infinite; they are compared as black or white.", file.string(),
                        strange, picture.data.size()));
    return to_codes(picture, Encoding::kSrgb);
  }

  SourceKind kind_;
  std::vector<fs::path> files_;
  PictureWarning warn_;
  std::size_t position_ = 0;
};

class VideoFrames : public FrameSource {
 public:
  VideoFrames(const fs::path& path, const std::optional<std::vector<int>>& wanted)
      : path_(path), reader_(path), wanted_(wanted) {}

  SourceKind kind() const override { return SourceKind::kVideo; }

  std::optional<Item> next() override {
    if (wanted_ && taken_ == wanted_->size()) return std::nullopt;
    if (wanted_)
      while (count_ < (*wanted_)[taken_] && reader_.next()) ++count_;
    std::optional<Image8> picture = reader_.next();
    if (!picture && wanted_)
      throw Error(path_.string(), fmt::format("has no frame {}, which `frames` requests", (*wanted_)[taken_]),
                  "`frames` with frames that exist");
    if (!picture) return std::nullopt;
    ++taken_;
    return Item{fmt::format("frame_{:04}", count_++), [picture = std::move(*picture)] { return picture; }};
  }

 private:
  fs::path path_;
  VideoReader reader_;
  std::optional<std::vector<int>> wanted_;
  std::size_t taken_ = 0;
  int count_ = 0;
};

void keep_wanted(const fs::path& folder, const std::vector<int>& wanted, std::vector<fs::path>& files) {
  std::set<int> missing(wanted.begin(), wanted.end());
  std::erase_if(files, [&](const fs::path& file) {
    const std::optional<int> number = frame_number(file);
    return !number || !std::binary_search(wanted.begin(), wanted.end(), *number) || missing.erase(*number) == 0;
  });
  if (!missing.empty())
    throw Error(folder.string(), fmt::format("has no frame {}, which `frames` requests", *missing.begin()),
                "`frames` with frames that exist");
}

std::unique_ptr<FrameSource> open_folder(const fs::path& folder, const std::optional<std::vector<int>>& wanted,
                                         const PictureWarning& warn) {
  if (!wanted) require_recorded_frames(folder);
  std::vector<fs::path> files;
  try {
    files = pictures_in(folder_of_pictures(folder));
  } catch (const fs::filesystem_error& failure) {
    throw Error(folder.string(), "cannot be listed: " + failure.code().message());
  }
  if (files.empty()) throw Error(folder.string(), "has no pictures", "a folder of pictures");
  const auto twice =
      std::adjacent_find(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) { return a.stem() == b.stem(); });
  if (twice != files.end())
    throw Error(folder.string(), fmt::format("has two pictures for one frame: {} and {}", twice->filename().string(),
                                             std::next(twice)->filename().string()));
  if (wanted) keep_wanted(folder, *wanted, files);
  return std::make_unique<PictureFiles>(SourceKind::kFolder, std::move(files), warn);
}

}  // namespace

std::optional<int> frame_number(const fs::path& file) {
  static const TextPattern numbered("frame_([0-9]{1,9})(?:_.*)?|.*?([0-9]{1,9})");
  const auto found = numbered.match(file.stem().string());
  if (!found) return std::nullopt;
  return std::stoi(found->groups[1].empty() ? found->groups[2] : found->groups[1]);
}

std::unique_ptr<FrameSource> open_frames(const fs::path& path, const std::optional<std::vector<int>>& wanted,
                                         const PictureWarning& warn) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) throw Error(path.string(), "there is no such file or folder");
  if (fs::is_directory(path, ignored)) return open_folder(path, wanted, warn);
  if (is_video_name(path)) return std::make_unique<VideoFrames>(path, wanted);
  if (wanted) throw usage_error("frames", path.string() + " is a single picture", "`frames` with a folder or a video");
  return std::make_unique<PictureFiles>(SourceKind::kPicture, std::vector{path}, warn);
}

}  // namespace lippmann
