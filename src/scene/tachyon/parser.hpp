// Reads the statements of a Tachyon scene file, one function per keyword, into a SceneBuilder.
//
// The order of words in a statement is fixed, as in Tachyon's own reader. Each function is called after its keyword has been
// read, and reads the rest of the statement. All throw Error naming file and line.
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

/// Global shading options (SHADER_MODE).
struct ShaderMode {
  bool shadows = true;        ///< MEDIUM: no shadows
  bool plain_colors = false;  ///< LOW: plain colours without lighting
  bool opacity_dims = false;  ///< TRANS_VMD: opacity scales a surface's own light
};

/// The parser's state.
struct ParserState {
  ParserState(SceneFolder& scene_folder, const Context& scene_context) : folder(scene_folder), context(scene_context) {}

  SceneFolder& folder;
  const Context& context;
  SceneBuilder builder;
  std::map<std::string, int, std::less<>> textures;  ///< material indices by TEXDEF or TEXALIAS name
  std::map<std::string, int, std::less<>> images;    ///< texture indices by image map name
  CameraRecord camera;
  ShaderMode shading;
  Background background;               ///< BACKGROUND
  std::optional<Background> gradient;  ///< BACKGROUND_GRADIENT, which overrides BACKGROUND in any order
  bool gradient_is_plane = false;      ///< SKY_ORTHO_PLANE: values are heights in the scene, not sines
  std::int64_t landscape_steps = 0;    ///< steps used so far by all landscapes
  Vec2i resolution{0, 0};
  LeftOut left_out;  ///< keywords that are read but ignored
  int include_depth = 0, includes = 0;
  int undefined_textures = 0, redefined_textures = 0;  ///< counts; only the first causes a warning
};

/// Reads a whole scene, from BEGIN_SCENE to END_SCENE.
void parse_scene(Lexer& lexer, ParserState& state);

/// Reads a whole scene as a Scene of one frame that passes validate() (tachyon.cpp).
Scene read_scene(Lexer& lexer, SceneFolder& folder, const Context& context, double frames_per_second);

/// Moves the scene's camera along a camera path (tachyon.cpp).
void animate_camera(Scene& scene, Lexer& path);

// Shading modes (shader_mode.cpp).
void parse_shader_mode(Lexer& lexer, ParserState& state);
/// Applies the modes to the finished scene.
void apply_shader_mode(const ShaderMode& mode, Scene& scene);

// Textures (texture_statements.cpp).
void parse_texdef(Lexer& lexer, ParserState& state);
void parse_texalias(Lexer& lexer, ParserState& state);
void parse_imagedef(Lexer& lexer, ParserState& state);
/// Reads the part of a texture after TEXTURE, or after TEXDEF and the name. Returns the material's index.
int parse_texture_body(Lexer& lexer, ParserState& state, std::string name);
/// Adds Tachyon's material for shapes with an undefined texture: matt white.
int add_default_material(ParserState& state);
/// Reads the body of a texture in VCSTRI, where vertices have the colours and the word VCST replaces COLOR and TEXFUNC.
int parse_colorless_texture_body(Lexer& lexer, ParserState& state);
/// Reads the end of a shape: a texture's name, or TEXTURE and a body.
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
