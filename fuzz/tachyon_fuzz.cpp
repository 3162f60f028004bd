// The Tachyon reader must throw Error, or return a scene that passes validate().
//
// The bytes before the first zero byte are the scene. The bytes after it are its camera path. The folder also contains a file
// of every kind that a scene can refer to.
//
// fuzz/tachyon_seeds SEEDS && fuzz_tachyon -dict=fuzz/tachyon.dict CORPUS SEEDS; or scripts/fuzz tachyon.
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/tachyon/parser.hpp"

namespace {

using namespace lippmann;
namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& contents) { std::ofstream(file, std::ios::binary) << contents; }

class SideFiles {
 public:
  SideFiles() : folder_((fs::temp_directory_path() / "lippmann-fuzz-XXXXXX").string()) {
    if (!mkdtemp(folder_.data())) std::abort();
    write(path("a.ppm"), "P6 2 1 255 abcdef");
    write(path("a.tpoly"), "3 0 0 0 1 0 0 0 1 0");
    write(path("a.inc"), "SPHERE CENTER 0 0 0 RAD 1 a INCLUDE a.inc");
    write(path("b.inc"), "LIGHT CENTER 0 0 0 RAD 1 COLOR 1 1 1");
  }
  ~SideFiles() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  fs::path path(const char* name) const { return fs::path(folder_) / name; }

 private:
  std::string folder_;
};

Scene read(const std::string& text, const std::string& camera_path, const fs::path& where) {
  tachyon::SceneFolder folder(where);
  Lexer lexer("scene.dat", text);
  Scene scene = tachyon::read_scene(lexer, folder, Context{}, 25.0);
  if (!camera_path.empty()) {
    Lexer poses("scene.cam", camera_path);
    tachyon::animate_camera(scene, poses);
  }
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const SideFiles files;
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  Scene scene;
  try {
    scene = read(input.substr(0, end), end < size ? input.substr(end + 1) : "", files.path("scene.dat"));
  } catch (const Error&) {
    return 0;
  }
  try {
    validate(scene, "scene.dat");
  } catch (const Error& error) {
    std::cerr << "the importer returned an invalid scene: " << error.what() << '\n';
    std::abort();
  }
  return 0;
}
