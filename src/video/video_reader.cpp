#include "video/video_reader.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/recorded_file.hpp"
#include "core/regular_file.hpp"
#include "lippmann/core/error.hpp"
#include "video/video_module.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::unique_ptr<VideoDecoder> open(const fs::path& path) {
  require_regular_file(path, "a video");
  require_as_recorded(path);
  return video_module().decoder(path);
}

}  // namespace

VideoReader::VideoReader(const fs::path& path) : decoder_(open(path)) {}
VideoReader::~VideoReader() = default;
std::optional<Image8> VideoReader::next() { return decoder_->next(); }

bool is_video_name(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  const std::array known = {".mp4", ".mkv", ".mov", ".webm", ".avi", ".m4v"};
  return std::find(known.begin(), known.end(), extension) != known.end();
}

}  // namespace lippmann
