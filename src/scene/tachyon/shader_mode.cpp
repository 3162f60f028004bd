#include <fmt/format.h>

#include "scene/tachyon/parser.hpp"

namespace lippmann::tachyon {
namespace {

void skip_ambient_occlusion(Lexer& lexer) {
  for (;;) {
    const std::string_view word = lexer.peek();
    const bool is_color = is_keyword(word, "AMBIENT_COLOR");
    if (!is_color && !is_keyword(word, "RESCALE_DIRECT") && !is_keyword(word, "SAMPLES") && !is_keyword(word, "MAXDIST"))
      return;
    lexer.word("SAMPLES");
    is_color ? (void)lexer.vector("AMBIENT_COLOR") : (void)lexer.number("SAMPLES");
  }
}

void parse_quality(Lexer& lexer, ParserState& state) {
  const std::string quality = upper(lexer.word("SHADER_MODE's quality"));
  if (quality == "LOWEST")
    state.context.warning(
        fmt::format("{}: SHADER_MODE LOWEST, which shows all surfaces white, is rendered as LOW.", lexer.where()));
  else if (quality != "FULL" && quality != "MEDIUM" && quality != "LOW")
    throw lexer.error(fmt::format("{} is not a quality of SHADER_MODE", shown(quality)), "FULL, MEDIUM, LOW, LOWEST");
  state.shading.shadows = quality == "FULL";
  state.shading.plain_colors = quality == "LOW" || quality == "LOWEST";
}

}  // namespace

void parse_shader_mode(Lexer& lexer, ParserState& state) {
  constexpr const char* kOptions =
      "SHADOW_FILTER_ON, SHADOW_FILTER_OFF, TRANS_ORIG, TRANS_VMD, TRANS_RASTER3D, TRANS_MAX_SURFACES, FOG_VMD, "
      "AMBIENT_OCCLUSION, END_SHADER_MODE";
  parse_quality(lexer, state);
  for (;;) {
    const std::string option = upper(lexer.word("END_SHADER_MODE"));
    if (option == "END_SHADER_MODE") return;
    if (option == "TRANS_VMD") {
      state.shading.opacity_dims = true;
    } else if (option == "TRANS_ORIG") {
      state.shading.opacity_dims = false;
    } else if (option == "SHADOW_FILTER_OFF" || option == "TRANS_RASTER3D") {
      state.left_out.add(option, lexer.where());
    } else if (option == "TRANS_MAX_SURFACES") {
      state.left_out.add(option, lexer.where());
      lexer.integer(option, 0, 1'000'000);
    } else if (option == "AMBIENT_OCCLUSION") {
      state.left_out.add(option, lexer.where());
      skip_ambient_occlusion(lexer);
    } else if (option != "SHADOW_FILTER_ON" && option != "FOG_VMD") {
      throw lexer.error(fmt::format("{} is not an option of SHADER_MODE", shown(option)), kOptions);
    }
  }
}

void apply_shader_mode(const ShaderMode& mode, Scene& scene) {
  if (!mode.shadows)
    for (Instance& instance : scene.instances) instance.casts_no_shadow = true;
  for (Material& material : scene.materials) {
    auto& surface = std::get<PhongSurface>(material.surface);
    if (mode.plain_colors) {
      surface.ambient = surface.opacity = 1.0f;
      surface.diffuse = surface.highlight = surface.mirror = 0.0f;
    }
    if (!mode.opacity_dims) continue;
    for (float* const share : {&surface.ambient, &surface.diffuse, &surface.highlight, &surface.mirror})
      *share *= surface.opacity;
  }
}

}  // namespace lippmann::tachyon
