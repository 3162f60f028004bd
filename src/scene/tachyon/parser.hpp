// Reads the statements of a Tachyon scene file, one function per keyword, into a SceneBuilder.
//
// The order of the words in a statement is fixed, as in Tachyon's own reader. Every function below is called after its keyword
// has been read and reads to the end of its statement; each throws Error that names file and line.
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

/// How everything is shaded (SHADER_MODE).
struct ShaderMode {
  bool shadows = true;        ///< MEDIUM has none
  bool plain_colors = false;  ///< LOW: colours as they are, without light
  bool opacity_dims = false;  ///< TRANS_VMD: a surface's own light counts as its opacity
};

/// What has been read so far.
struct ParserState {
  ParserState(SceneFolder& scene_folder, const Context& scene_context) : folder(scene_folder), context(scene_context) {}

  SceneFolder& folder;
  const Context& context;
  SceneBuilder builder;
  std::map<std::string, int, std::less<>> textures;  ///< TEXDEF and TEXALIAS names to materials
  std::map<std::string, int, std::less<>> images;    ///< image maps by the name that the scene calls them
  CameraRecord camera;
  ShaderMode shading;
  Background background;               ///< BACKGROUND
  std::optional<Background> gradient;  ///< BACKGROUND_GRADIENT, which wins wherever it stands
  bool gradient_is_plane = false;      ///< its values are heights in the scene (SKY_ORTHO_PLANE), not sines
  std::int64_t landscape_steps = 0;    ///< taken so far
  Vec2i resolution{0, 0};
  LeftOut left_out;  ///< keywords of what is read and not shown
  int include_depth = 0, includes = 0;
  int undefined_textures = 0, redefined_textures = 0;  ///< how often; the first is a warning
};

/// Reads a whole scene, BEGIN_SCENE to END_SCENE.
void parse_scene(Lexer& lexer, ParserState& state);

/// The same as a Scene of one frame that passes validate() (tachyon.cpp).
Scene read_scene(Lexer& lexer, SceneFolder& folder, const Context& context, double frames_per_second);

/// Moves the scene's camera along a camera path (tachyon.cpp).
void animate_camera(Scene& scene, Lexer& path);

// Modes of rendering (shader_mode.cpp).
void parse_shader_mode(Lexer& lexer, ParserState& state);
/// Does to the finished scene what its modes say.
void apply_shader_mode(const ShaderMode& mode, Scene& scene);

// Textures (texture_statements.cpp).
void parse_texdef(Lexer& lexer, ParserState& state);
void parse_texalias(Lexer& lexer, ParserState& state);
void parse_imagedef(Lexer& lexer, ParserState& state);
/// What follows the keywords TEXTURE and TEXDEF name; the material's index.
int parse_texture_body(Lexer& lexer, ParserState& state, std::string name);
/// What Tachyon gives to shapes without a texture that it knows: matt white.
int add_default_material(ParserState& state);
/// The body of a texture in VCSTRI, where the vertices bring the colour and the word VCST stands for COLOR and TEXFUNC.
int parse_colorless_texture_body(Lexer& lexer, ParserState& state);
/// At the end of a shape: a texture's name, or TEXTURE and a body.
int parse_texture_reference(Lexer& lexer, ParserState& state);

// Shapes (shape_statements.cpp).
void parse_box(Lexer& lexer, ParserState& state);
void parse_fcylinder(Lexer& lexer, ParserState& state);
void parse_plane(Lexer& lexer, ParserState& state);
void parse_polycylinder(Lexer& lexer, ParserState& state);
void parse_ring(Lexer& lexer, ParserState& state);
void parse_sphere(Lexer& lexer, ParserState& state);
void parse_stri(Lexer& lexer, ParserState& state);
void parse_tri(Lexer& lexer, ParserState& state);
void parse_vcstri(Lexer& lexer, ParserState& state);

// Shapes of many triangles (mesh_statements.cpp).
void parse_tpolyfile(Lexer& lexer, ParserState& state);
void parse_vertexarray(Lexer& lexer, ParserState& state);

// Fractal landscapes (landscape_statement.cpp).
void parse_scape(Lexer& lexer, ParserState& state);

// Lights (light_statements.cpp).
void parse_directional_light(Lexer& lexer, ParserState& state);
void parse_light(Lexer& lexer, ParserState& state);
void parse_spotlight(Lexer& lexer, ParserState& state);

}  // namespace lippmann::tachyon
