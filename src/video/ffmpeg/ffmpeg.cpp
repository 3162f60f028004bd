#include "video/ffmpeg/ffmpeg.hpp"

#include <array>
#include <mutex>

namespace lippmann {

Error ffmpeg_error(const std::filesystem::path& path, const std::string& action, int code) {
  std::array<char, AV_ERROR_MAX_STRING_SIZE> text{};
  av_strerror(code, text.data(), text.size());
  return Error(path.string(), action + ": " + text.data());
}

void silence_ffmpeg() {
  static std::once_flag once;
  std::call_once(once, [] { av_log_set_level(AV_LOG_QUIET); });
}

}  // namespace lippmann
