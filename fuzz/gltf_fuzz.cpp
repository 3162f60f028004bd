// After a first byte 'W', the input is a whole .glb or .gltf file. Otherwise it becomes the two chunks of a .glb file: JSON up
// to the first zero byte, and then binary data. Accepted scenes must pass validate().
//
// fuzz_gltf_seeds SEEDS && fuzz_gltf -dict=fuzz/gltf.dict CORPUS SEEDS
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "lippmann/core/error.hpp"
#include "lippmann/scene/load.hpp"
#include "lippmann/scene/timeline.hpp"
#include "scene/gltf.hpp"

namespace {

using Contents = std::vector<std::byte>;

void append(Contents& to, const std::uint8_t* from, std::size_t size) {
  const auto* bytes = reinterpret_cast<const std::byte*>(from);
  to.insert(to.end(), bytes, bytes + size);
}

void append_word(Contents& to, std::size_t word) {
  for (int shift = 0; shift < 32; shift += 8) to.push_back(static_cast<std::byte>(word >> shift));
}

Contents packed(const std::uint8_t* data, std::size_t size) {
  const void* zero = std::memchr(data, 0, size);
  const std::size_t json = zero ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(zero) - data) : size;
  const std::size_t binary = zero ? size - json - 1 : 0;
  Contents result;
  append(result, reinterpret_cast<const std::uint8_t*>("glTF"), 4);
  append_word(result, 2);
  append_word(result, 12 + 8 + json + (zero ? 8 + binary : 0));
  append_word(result, json);
  append_word(result, 0x4e4f534a);
  append(result, data, json);
  if (!zero) return result;
  append_word(result, binary);
  append_word(result, 0x004e4942);
  append(result, data + json + 1, binary);
  return result;
}

lippmann::GltfLimits small_limits() {
  lippmann::GltfLimits limits;
  limits.json_values = 100'000;
  limits.unpacked_bytes = 64 << 20;
  return limits;
}

lippmann::LoadOptions small_options() {
  lippmann::LoadOptions options;
  options.frames_per_second = 25.0;
  options.texture_bytes = 16 << 20;
  return options;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1) return 0;
  Contents contents;
  if (data[0] == 'W')
    append(contents, data + 1, size - 1);
  else
    contents = packed(data + 1, size - 1);

  const lippmann::Context context;
  lippmann::Scene scene;
  try {
    scene = lippmann::parse_gltf(contents, "/nonexistent/a.glb", small_options(), context, small_limits());
  } catch (const lippmann::Error&) {
    return 0;
  }
  lippmann::validate(scene, "a.glb");  // not in the try block: an Error here is a defect of the reader
  for (const double time : {0.0, 0.37, 1e9}) {
    const lippmann::ResolvedScene resolved = lippmann::evaluate(scene, time);
    lippmann::finite_bounds(scene, resolved);
  }
  lippmann::moving_nodes(scene);
  return 0;
}
