#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/tachyon.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {

class TachyonFiles {
 public:
  void write(const std::string& name, const std::string& contents) const {
    std::filesystem::create_directories((dir_ / name).parent_path());
    std::ofstream(dir_ / name, std::ios::binary) << contents;
  }
  std::filesystem::path path(const std::string& name) const { return dir_ / name; }

  Scene load(double frames_per_second = kTachyonFramesPerSecond) {
    Context context;
    context.warn = [this](std::string_view text) { warnings.push_back(without_folder(std::string(text))); };
    Scene scene = load_tachyon(path("scene.dat"), camera_path, context, frames_per_second);
    validate(scene, "scene.dat");
    return scene;
  }

  /// Loads the statements, which begin in line 4, with an image of 4 x 3 pixels.
  Scene load_statements(const std::string& statements) {
    write("scene.dat", kPrelude + statements + "\nEND_SCENE\n");
    return load();
  }

  std::string error_of_statements(const std::string& statements) { return error_of(kPrelude + statements + "\nEND_SCENE\n"); }

  std::string error_of(const std::string& text) {
    write("scene.dat", text);
    try {
      load();
    } catch (const Error& error) {
      return without_folder(error.what());
    }
    return "no error";
  }

  std::string without_folder(std::string text) const {
    const std::string folder = dir_.path().string() + "/";
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) text.erase(at, folder.size());
    return text;
  }

  static inline const std::string kCamera =
      "CAMERA ZOOM 1 ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH 6 CENTER 0 0 0 VIEWDIR 0 0 1 UPDIR 0 1 0 END_CAMERA\n";
  static inline const std::string kPrelude = "BEGIN_SCENE\nRESOLUTION 4 3\n" + kCamera;
  static inline const std::string kWhite = " TEXTURE AMBIENT 0 DIFFUSE 1 SPECULAR 0 OPACITY 1 COLOR 1 1 1 TEXFUNC 0 ";

  std::vector<std::string> warnings;
  std::optional<std::filesystem::path> camera_path;

 private:
  TempDir dir_;
};

class Tachyon : public testing::Test {
 protected:
  TachyonFiles files;
  const std::string white = TachyonFiles::kWhite;
};

template <class S>
const S& only_shape(const Scene& scene) {
  if (scene.shapes.size() != 1) throw std::logic_error("not one shape but " + std::to_string(scene.shapes.size()));
  return std::get<S>(scene.shapes.front());
}

inline const PhongSurface& phong(const Material& material) { return std::get<PhongSurface>(material.surface); }

inline std::array<float, 3> xyz(Vec3f v) { return {v.x, v.y, v.z}; }

}  // namespace lippmann::test
