#include "live/scene_file_state.hpp"

#include <system_error>

namespace lippmann {

namespace fs = std::filesystem;

SceneFileState scene_file_state(const std::string& scene) {
  const fs::path file = scene;
  SceneFileState state;
  if (!file.has_extension()) return state;
  const std::array<fs::path, 3> files{file, fs::path(file).replace_extension(".bin"), fs::path(file).replace_extension(".mtl")};
  for (std::size_t i = 0; i < files.size(); ++i) {
    std::error_code missing;
    if (!fs::is_regular_file(files[i], missing)) continue;
    const std::uintmax_t bytes = fs::file_size(files[i], missing);
    if (!missing) state.bytes[i] = bytes;
    const fs::file_time_type written = fs::last_write_time(files[i], missing);
    if (!missing) state.written[i] = written;
  }
  return state;
}

}  // namespace lippmann
