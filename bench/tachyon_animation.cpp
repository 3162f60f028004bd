#include "bench/tachyon_animation.hpp"

#include <fmt/core.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "bench/program.hpp"
#include "core/platform.hpp"
#include "lippmann/core/error.hpp"

namespace lippmann::bench {
namespace {

constexpr int kTinySize = 8;

class CameraFile {
 public:
  explicit CameraFile(const BenchAnimation& animation)
      : path_(std::filesystem::temp_directory_path() / fmt::format("lippmann-reuse-bench-{}.cam", platform::process_id())) {
    std::ifstream all(animation.params.scene.camera_path);
    std::ofstream some(path_);
    std::string line;
    for (int frame = 0; frame < animation.first + animation.count && std::getline(all, line); ++frame)
      if (frame >= animation.first) some << line << '\n';
  }
  ~CameraFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  CameraFile(const CameraFile&) = delete;
  CameraFile& operator=(const CameraFile&) = delete;

  std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};

double seconds(const std::filesystem::path& scene, const CameraFile& cameras, int size) {
  const std::string pixels = std::to_string(size);
  return cpu_seconds_of({"tachyon", scene.filename().string(), "-camfile", cameras.path(), "-res", pixels, pixels, "-aasamples",
                         "0", "-numthreads", "1", "-nosave"},
                        scene.parent_path());
}

}  // namespace

std::optional<double> tachyon_seconds_per_frame(const BenchAnimation& animation, double pixels) {
  if (animation.params.scene.camera_path.empty()) return std::nullopt;
  const CameraFile cameras(animation);
  const std::filesystem::path scene = std::filesystem::absolute(animation.params.scene.name);
  const int size = static_cast<int>(std::lround(std::sqrt(pixels)));
  try {
    const double both = seconds(scene, cameras, size) - seconds(scene, cameras, kTinySize);
    return both / (animation.count + 1);  // tachyon renders the last frame of a path twice
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace lippmann::bench
