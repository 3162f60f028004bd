// Shows whether the files of a scene have changed.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>

namespace lippmann {

/// Sizes and times of a scene's file and of the files beside it that exporters write with the same name: .bin and .mtl. All are
/// 0 for missing files and for scenes that are built in.
struct SceneFileState {
  std::array<std::uintmax_t, 3> bytes{};
  std::array<std::filesystem::file_time_type, 3> written{};

  bool operator==(const SceneFileState&) const = default;
};

SceneFileState scene_file_state(const std::string& scene);

}  // namespace lippmann
