// The NFF reader must throw Error, or return a scene that passes validate().
//
// fuzz/nff_seeds SEEDS && fuzz_nff -dict=fuzz/nff.dict CORPUS SEEDS; or scripts/fuzz nff.
#include <cstdlib>
#include <iostream>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/nff.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace lippmann;
  Scene scene;
  try {
    scene = parse_nff("scene.nff", std::string(reinterpret_cast<const char*>(data), size), Context{});
  } catch (const Error&) {
    return 0;
  }
  try {
    validate(scene, "scene.nff");
  } catch (const Error& error) {
    std::cerr << "the reader returned an invalid scene: " << error.what() << '\n';
    std::abort();
  }
  return 0;
}
