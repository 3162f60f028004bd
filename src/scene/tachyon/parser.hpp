// Reads the statements of a Tachyon scene file into a SceneBuilder. There is one function per keyword.
//
// Each function is called after its keyword was read, and reads the rest of the statement, whose words have a fixed order. All
// functions throw Error naming file and line.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "lippmann/core/context.hpp"
#include "scene/left_out.hpp"
#include "scene/lexer.hpp"
#include "scene/tachyon/camera.hpp"
#include "scene/tachyon/scene_builder.hpp"
#include "scene/tachyon/scene_folder.hpp"

namespace lippmann::tachyon {

struct ShaderMode {
  bool shadows = true;
  bool plain_colors = false;  ///< colours without lighting
  bool opacity_dims = false;  ///< opacity multiplies a surface's own light
};

struct ParserState {
  ParserState(SceneFolder& scene_folder, const Context& scene_context) : folder(scene_folder), context(scene_context) {}

  SceneFolder& folder;
  const Context& context;
  SceneBuilder builder;
  std::map<std::string, int, std::less<>> textures;
  std::map<std::string, int, std::less<>> images;
  CameraRecord camera;
  ShaderMode shading;
  Background background;
  std::optional<Background> gradient;
  /// True for SKY_ORTHO_PLANE: the gradient's limits are heights in the scene, not sines of elevations.
  bool gradient_is_plane = false;
  std::int64_t landscape_steps = 0;
  Vec2i resolution{0, 0};
  LeftOut left_out;
  int include_depth = 0, includes = 0;
  int undefined_textures = 0, redefined_textures = 0;
};

void parse_scene(Lexer& lexer, ParserState& state);

Scene read_scene(Lexer& lexer, SceneFolder& folder, const Context& context, double frames_per_second);

void animate_camera(Scene& scene, Lexer& path);

void parse_shader_mode(Lexer& lexer, ParserState& state);
void apply_shader_mode(const ShaderMode& mode, Scene& scene);

void parse_texdef(Lexer& lexer, ParserState& state);
void parse_texalias(Lexer& lexer, ParserState& state);
void parse_imagedef(Lexer& lexer, ParserState& state);
/// Reads the rest of a texture after the word TEXTURE, or after TEXDEF and a name. Returns the index of a new material.
int parse_texture_body(Lexer& lexer, ParserState& state, std::string name);
int add_default_material(ParserState& state);
/// Reads the texture at the end of VCSTRI, which has no colour because the vertices have colours. The word VCST replaces COLOR
/// and TEXFUNC. Returns the material's index.
int parse_colorless_texture_body(Lexer& lexer, ParserState& state);
int parse_texture_reference(Lexer& lexer, ParserState& state);

void parse_box(Lexer& lexer, ParserState& state);
void parse_fcylinder(Lexer& lexer, ParserState& state);
void parse_plane(Lexer& lexer, ParserState& state);
void parse_polycylinder(Lexer& lexer, ParserState& state);
void parse_ring(Lexer& lexer, ParserState& state);
void parse_sphere(Lexer& lexer, ParserState& state);
void parse_stri(Lexer& lexer, ParserState& state);
void parse_tri(Lexer& lexer, ParserState& state);
void parse_vcstri(Lexer& lexer, ParserState& state);

void parse_tpolyfile(Lexer& lexer, ParserState& state);
void parse_vertexarray(Lexer& lexer, ParserState& state);

void parse_scape(Lexer& lexer, ParserState& state);

void parse_directional_light(Lexer& lexer, ParserState& state);
void parse_light(Lexer& lexer, ParserState& state);
void parse_spotlight(Lexer& lexer, ParserState& state);

}  // namespace lippmann::tachyon
