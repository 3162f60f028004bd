#include "job/scene_light.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <filesystem>
#include <optional>

#include "core/printable.hpp"
#include "core/suggest.hpp"
#include "job/param_text.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/image/encode.hpp"
#include "lippmann/stage/environment_file.hpp"
#include "lippmann/stage/lighting.hpp"
#include "scene/default_light.hpp"
#include "stage/surroundings.hpp"

namespace lippmann {
namespace {

constexpr std::string_view kNone = "none", kStudio = "studio";
constexpr const char* kAccepted =
    "none, studio, a colour as #rrggbb or R,G,B (linear light), or a panorama, .hdr, .exr, .pfm or .tif";

/// Parses sRGB codes, such as "#ffcc00".
std::optional<Vec3f> parse_hexadecimal(std::string_view text) {
  unsigned codes = 0;
  const char* const end = text.data() + text.size();
  if (text.size() != 7) return std::nullopt;
  if (const auto read = std::from_chars(text.data() + 1, end, codes, 16); read.ec != std::errc() || read.ptr != end)
    return std::nullopt;
  const auto channel = [&](int shift) { return static_cast<float>(linear_from_srgb(((codes >> shift) & 255u) / 255.0)); };
  return Vec3f(channel(16), channel(8), channel(0));
}

/// Parses linear light, such as "1,0.8,0.2".
Vec3f read_linear(std::string_view text, const std::string& where) {
  constexpr double kMax = 1e6;
  Vec3f color{0.0f};
  for (int c = 0; c < 3; ++c) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (c == 2)) throw usage_error(where, "a colour has three numbers", kAccepted);
    color[c] = static_cast<float>(read_number(text.substr(0, comma), 0.0, kMax, where));
    text.remove_prefix(c == 2 ? text.size() : comma + 1);
  }
  return color;
}

/// Returns nullopt if the value does not look like a colour. Throws if it looks like one but is invalid.
std::optional<Vec3f> read_color(std::string_view value, const std::string& where) {
  if (value.starts_with('#')) {
    const std::optional<Vec3f> color = parse_hexadecimal(value);
    if (!color) throw usage_error(where, fmt::format("'{}' is not a colour", value), kAccepted);
    return color;
  }
  const bool is_list = value.find(',') != std::string_view::npos && value.find_first_not_of("0123456789.,+-eE") == value.npos;
  return is_list ? std::optional(read_linear(value, where)) : std::nullopt;
}

Surrounding surrounding_of(const SceneParams& params) { return {params.environment_strength, params.environment_rotation_deg}; }

/// A name with an extension is treated as a missing file. A name without an extension may be a misspelt word.
Error no_such_environment(const std::string& value) {
  const std::filesystem::path path(value);
  if (path.has_extension()) return Error(value, "there is no such file", kAccepted);
  constexpr std::array<std::string_view, 2> kWords{kNone, kStudio};
  const std::string word = path.filename();
  return usage_error("--environment", fmt::format("there is no '{}'{}", printable(word), did_you_mean(word, kWords)),
                     kAccepted);
}

std::string requested_light(Scene& scene, const SceneParams& params, const Context& context) {
  const std::string& value = params.environment;
  if (value == kNone) return "The scene has only its own light, as requested by --environment none.";
  if (value == kStudio) {
    surround_with_studio(scene, params.environment_strength, params.environment_rotation_deg);
    return "The built-in studio lights the scene, as requested by --environment.";
  }
  if (const std::optional<Vec3f> color = read_color(value, "--environment")) {
    surround_with(scene, params.environment_strength * *color);
    return fmt::format("The colour {} surrounds the scene, as requested by --environment.", value);
  }
  if (!std::filesystem::exists(value)) throw no_such_environment(value);
  scene.background.map = read_environment(value, params.environment_strength, params.environment_rotation_deg, context);
  return fmt::format("The panorama {} lights the scene, as requested by --environment.", value);
}

}  // namespace

bool environment_is_file(std::string_view value) {
  return !value.empty() && value != kNone && value != kStudio && !read_color(value, "--environment");
}

std::string read_environment_choice(std::string_view value, const std::string& where) {
  read_color(value, where);
  return std::string(value);
}

std::string light_scene(Scene& scene, const SceneParams& params, Integrator integrator, const Context& context) {
  if (!params.environment.empty()) return requested_light(scene, params, context);
  if (!integrator.facts().is_lit_by_surroundings) {
    if (lacks_lamps(scene))
      context.warning(fmt::format("{} has no lights: a key light from above left of the viewer is added", params.name));
    return light_for_whitted(scene);
  }
  if (scene.kind == SceneKind::kWhitted && own_light(scene) != OwnLight::kNone) return "The scene has its own light.";
  return light_for_paths(scene, surrounding_of(params));
}

}  // namespace lippmann
