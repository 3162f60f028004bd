// The OBJ reader must throw Error, or return a scene that passes validate().
//
// The bytes before the first zero byte are the scene. The bytes after it are the material file a.mtl. The folder also contains
// a texture, a.ppm.
//
// fuzz/obj_seeds SEEDS && fuzz_obj -dict=fuzz/obj.dict CORPUS SEEDS; or scripts/fuzz obj.
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/obj.hpp"

namespace {

using namespace lippmann;
namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& contents) { std::ofstream(file, std::ios::binary) << contents; }

class Folder {
 public:
  Folder() : folder_((fs::temp_directory_path() / "lippmann-fuzz-XXXXXX").string()) {
    if (!mkdtemp(folder_.data())) std::abort();
    write(path("a.ppm"), "P6 2 1 255 abcdef");
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  fs::path path(const char* name) const { return fs::path(folder_) / name; }

 private:
  std::string folder_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const Folder folder;
  const std::string input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), size);
  write(folder.path("a.obj"), input.substr(0, end));
  write(folder.path("a.mtl"), end < size ? input.substr(end + 1) : "");
  Scene scene;
  try {
    scene = load_obj(folder.path("a.obj"), Context{});
  } catch (const Error&) {
    return 0;
  }
  try {
    validate(scene, "a.obj");
  } catch (const Error& error) {
    std::cerr << "the reader returned an invalid scene: " << error.what() << '\n';
    std::abort();
  }
  return 0;
}
