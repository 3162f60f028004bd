// The reader of IES photometric files must throw Error, or return a light distribution that is finite and not negative in every
// direction.
//
// fuzz/ies_seeds SEEDS && fuzz_ies -dict=fuzz/ies.dict CORPUS SEEDS; or scripts/fuzz ies.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "scene/ies.hpp"
#include "scene/photometric_web.hpp"

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "the reader returned a web " << what << '\n';
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace lippmann;
  IesProfile profile;
  try {
    profile = parse_ies("lamp.ies", std::string(reinterpret_cast<const char*>(data), size));
  } catch (const Error&) {
    return 0;
  }
  Scene scene;
  scene.webs.push_back(profile.web);
  try {
    validate(scene, "lamp.ies");
  } catch (const Error& error) {
    require(false, error.what());
  }
  for (float x = -1.0f; x <= 1.0f; x += 0.25f)
    for (float y = -1.0f; y <= 1.0f; y += 0.25f) {
      const float light = profile.mean_candela * intensity(profile.web, glm::normalize(Vec3f(x, y, x + y + 0.1f)));
      require(std::isfinite(light) && light >= 0.0f, "with light that is negative or not finite");
    }
  return 0;
}
