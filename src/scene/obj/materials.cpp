// Based on: Alias/Wavefront, "MTL material format", version 4.2, 1995, and its extension for physically based rendering (Pr,
// Pm).
//
// We deviate: a Phong exponent Ns becomes the roughness sqrt(alpha) of a microfacet lobe with the same width, alpha^2 = 2 / (Ns
// + 2), after B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", 2007, section 5.
#include "scene/obj/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/file_content.hpp"
#include "core/printable.hpp"
#include "lippmann/core/error.hpp"
#include "scene/left_out.hpp"
#include "scene/lexer.hpp"
#include "scene/side_file.hpp"
#include "scene/text_file.hpp"

namespace lippmann::obj {
namespace {

constexpr std::size_t kLargestText = std::size_t{64} << 20;
constexpr float kLargestMaterialNumber = 1e6f;

MetallicRoughness matt_grey() {
  MetallicRoughness surface;
  surface.base_color = Vec4f(Vec3f(0.8f), 1.0f);
  surface.metallic = 0.0f;
  surface.double_sided = true;
  return surface;
}

float roughness_of(float phong_exponent) { return std::pow(2.0f / (phong_exponent + 2.0f), 0.25f); }

std::string_view next_word(std::string_view& text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t\r", begin), text.size());
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

bool is_number(std::string_view word) {
  return !word.empty() && word.find_first_not_of("0123456789+-.eE") == std::string_view::npos;
}

/// Returns the file name in a map statement such as "-s 1 1 1 -clamp on name". The options have no effect; their names are
/// added to `left_out`.
std::string map_file(std::string_view statement, const std::string& where, LeftOut& left_out) {
  std::string_view rest = statement;
  for (;;) {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r"), rest.size()));
    std::string_view after = rest;
    const std::string_view option = next_word(after);
    if (option.size() < 2 || option[0] != '-') break;
    left_out.add(option, where);
    const bool vector = option == "-o" || option == "-s" || option == "-t";
    for (int i = 0; i < (vector ? 3 : option == "-mm" ? 2 : 1); ++i) {
      std::string_view behind = after;
      if (!is_number(next_word(behind)) && vector && i > 0) break;
      after = behind;
    }
    rest = after;
  }
  std::string name(rest);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

struct Draft {
  MetallicRoughness surface = matt_grey();
  float roughness = -1.0f;
  float exponent = 0.0f;
  bool dull = false;  ///< Ks is black, so that there is no reflection

  MetallicRoughness finished() const {
    MetallicRoughness result = surface;
    result.roughness = roughness >= 0.0f ? roughness : roughness_of(exponent);
    if (dull && roughness < 0.0f) result.specular = 0.0f;
    result.blend = result.base_color.a < 1.0f;
    return result;
  }
};

float number(Lexer& lexer, std::string_view wanted) {
  if (lexer.at_line_end()) throw lexer.error(fmt::format("{} lacks a number", wanted));
  return std::max(0.0f, lexer.number(wanted, kLargestMaterialNumber));
}
float share(Lexer& lexer, std::string_view wanted) { return std::min(1.0f, number(lexer, wanted)); }

/// A single number is used for all three channels.
Vec3f color(Lexer& lexer, std::string_view wanted) {
  const float red = number(lexer, wanted);
  if (lexer.at_line_end()) return Vec3f(red);
  const float green = number(lexer, wanted), blue = number(lexer, wanted);
  return {red, green, blue};
}

bool parse_value(std::string_view keyword, Lexer& lexer, Draft& draft) {
  MetallicRoughness& s = draft.surface;
  if (keyword == "Kd")
    s.base_color = Vec4f(color(lexer, "Kd"), s.base_color.a);
  else if (keyword == "Ks")
    draft.dull = color(lexer, "Ks") == Vec3f(0.0f);
  else if (keyword == "Ke")
    s.emissive = color(lexer, "Ke");
  else if (keyword == "Ns")
    draft.exponent = number(lexer, "Ns");
  else if (keyword == "Ni")
    s.ior = std::max(1.0f, number(lexer, "Ni"));
  else if (keyword == "d" && lexer.peek() != "-halo")
    s.base_color.a = share(lexer, "d");
  else if (keyword == "Tr")
    s.base_color.a = 1.0f - share(lexer, "Tr");
  else if (keyword == "Pr")
    draft.roughness = share(lexer, "Pr");
  else if (keyword == "Pm")
    s.metallic = share(lexer, "Pm");
  else
    return keyword == "Ka" || keyword == "illum";  // ambient light and illumination models are accepted but ignored
  return true;
}

}  // namespace

Materials::Materials(SideFolders folders, std::uint64_t texture_bytes, Scene& scene, const Context& context)
    : folders_(std::move(folders)),
      textures_(folders_, texture_bytes, scene, context),
      scene_(scene),
      context_(context),
      text_left_(kLargestText) {}

bool Materials::exists(std::string_view name, const std::string& where) const {
  return find_side_file(folders_, name, where).problem.empty();
}

void Materials::read_library(std::string_view names, const std::string& where) {
  if (names.find(' ') == std::string_view::npos || exists(names, where)) return read_file(std::string(names), where);
  for (std::string_view name = next_word(names); !name.empty(); name = next_word(names)) read_file(std::string(name), where);
}

void Materials::read_file(const std::string& name, const std::string& where) {
  if (!read_.insert(name).second) return;
  const SideFile file = find_side_file(folders_, name, where);
  if (!file.problem.empty()) return context_.warning(fmt::format("{}: {}; its surfaces are grey.", where, file.problem));
  std::string text = read_text_file(file.path, where, text_left_, "at most 64 MiB of materials");
  text_left_ -= text.size();
  if (const auto stand_in = stand_in_for_file(std::as_bytes(std::span(text)));
      stand_in && text.find_first_not_of(" \t\r\n") != text.npos)
    return context_.warning(fmt::format("{}: {} is {}; its surfaces are grey (accepted: {}).", where, shown(name),
                                        stand_in->what, stand_in->advice));
  Lexer lexer(file.path.string(), utf8_text(std::move(text)));
  int index = -1;
  Draft draft;
  LeftOut left_out, options;
  const auto finish = [&] {
    if (index >= 0) scene_.materials[static_cast<std::size_t>(index)].surface = draft.finished();
  };
  while (!lexer.at_end()) {
    const std::string_view keyword = lexer.word("a statement");
    if (keyword == "newmtl") {
      finish();
      draft = {};
      index = static_cast<int>(scene_.materials.size());
      const std::string material(lexer.rest_of_line());
      scene_.materials.push_back({material, draft.surface});
      known_.insert_or_assign(material, index);
    } else if (keyword == "map_Kd") {
      draft.surface.base_color_map.texture =
          textures_.add(map_file(lexer.rest_of_line(), lexer.where(), options), lexer.where());
    } else if (keyword == "map_Ke") {
      draft.surface.emissive_map.texture = textures_.add(map_file(lexer.rest_of_line(), lexer.where(), options), lexer.where());
      if (draft.surface.emissive == Vec3f(0.0f)) draft.surface.emissive = Vec3f(1.0f);
    } else {
      if (!parse_value(keyword, lexer, draft)) left_out.add(keyword, lexer.where());
      lexer.rest_of_line();
    }
  }
  finish();
  left_out.warn(context_, "statement", "statements");
  options.warn(context_, "map option", "map options");
}

int Materials::find(std::string_view name, const std::string& where) {
  if (const auto known = known_.find(name); known != known_.end()) return known->second;
  if (!name.empty()) context_.warning(fmt::format("{}: there is no material {}; it is grey.", where, shown(name)));
  const int index = static_cast<int>(scene_.materials.size());
  scene_.materials.push_back({std::string(name), matt_grey()});
  known_.emplace(name, index);
  return index;
}

}  // namespace lippmann::obj
