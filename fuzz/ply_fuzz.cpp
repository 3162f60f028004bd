// The PLY reader must throw Error, or return a scene that passes validate().
//
// fuzz/ply_seeds SEEDS && fuzz_ply -dict=fuzz/ply.dict CORPUS SEEDS; or scripts/fuzz ply.
#include <cstdlib>
#include <iostream>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/ply.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace lippmann;
  Scene scene;
  try {
    scene = parse_ply("scene.ply", std::string(reinterpret_cast<const char*>(data), size), Context{});
  } catch (const Error&) {
    return 0;
  }
  try {
    validate(scene, "scene.ply");
  } catch (const Error& error) {
    std::cerr << "the reader returned an invalid scene: " << error.what() << '\n';
    std::abort();
  }
  return 0;
}
