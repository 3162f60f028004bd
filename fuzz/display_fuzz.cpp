// Reads text that begins with '{' as a calibration in JSON, and other text as a display in TOML. The readers must throw Error,
// or return a display whose optics pass validate() and can be written as JSON.
//
// fuzz/display_seeds SEEDS && fuzz_display -dict=fuzz/display.dict CORPUS SEEDS; or scripts/fuzz display.
#include <cstdlib>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "display/display_json.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/display/load_display.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace lippmann;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Display display;
  try {
    display = text.starts_with('{') ? display_from_calibration(text, "visual.json") : display_from_toml(text, "display.toml");
  } catch (const Error&) {
    return 0;
  }
  try {
    validate(native_optics(display));
  } catch (const Error& error) {
    std::cerr << "an accepted display has invalid rays: " << error.what() << '\n';
    std::abort();
  }
  if (views_of(display) < 0 || display_json(display).dump().empty()) std::abort();
  return 0;
}
