// Reads the statements of a Tachyon scene file into a SceneBuilder. There is one function per keyword.
//
// The words of a statement have a fixed order, as in Tachyon's own reader. Each function is called after its keyword was read,
// and reads the rest of the statement. All functions throw Error naming file and line.
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
  bool shadows = true;        ///< false for MEDIUM
  bool plain_colors = false;  ///< true for LOW: colours without lighting
  bool opacity_dims = false;  ///< true for TRANS_VMD: opacity multiplies a surface's own light
};

struct ParserState {
  ParserState(SceneFolder& scene_folder, const Context& scene_context) : folder(scene_folder), context(scene_context) {}

  SceneFolder& folder;
  const Context& context;
  SceneBuilder builder;
  std::map<std::string, int, std::less<>> textures;  ///< material index by TEXDEF or TEXALIAS name
  std::map<std::string, int, std::less<>> images;    ///< texture index by image map name
  CameraRecord camera;
  ShaderMode shading;
  Background background;
  std::optional<Background> gradient;  ///< from BACKGROUND_GRADIENT, which overrides BACKGROUND
  /// True for SKY_ORTHO_PLANE: the gradient's limits are heights in the scene, not sines of elevations.
  bool gradient_is_plane = false;
  std::int64_t landscape_steps = 0;  ///< number of steps that all landscapes so far have used
  Vec2i resolution{0, 0};
  LeftOut left_out;  ///< keywords that are read but have no effect
  int include_depth = 0, includes = 0;
  /// Numbers of occurrences so far. Only the first occurrence causes a warning.
  int undefined_textures = 0, redefined_textures = 0;
};

/// Reads a whole scene, from BEGIN_SCENE to END_SCENE.
void parse_scene(Lexer& lexer, ParserState& state);

/// Reads a whole file as a Scene of one frame that passes validate() (tachyon.cpp).
Scene read_scene(Lexer& lexer, SceneFolder& folder, const Context& context, double frames_per_second);

/// Moves the scene's camera along the path that the lexer `path` reads (tachyon.cpp).
void animate_camera(Scene& scene, Lexer& path);

// Shading modes (shader_mode.cpp).
void parse_shader_mode(Lexer& lexer, ParserState& state);
/// Applies the modes to a scene whose statements have all been read.
void apply_shader_mode(const ShaderMode& mode, Scene& scene);

// Textures (texture_statements.cpp).
void parse_texdef(Lexer& lexer, ParserState& state);
void parse_texalias(Lexer& lexer, ParserState& state);
void parse_imagedef(Lexer& lexer, ParserState& state);
/// Reads the rest of a texture after the word TEXTURE, or after TEXDEF and a name. Returns the index of a new material.
int parse_texture_body(Lexer& lexer, ParserState& state, std::string name);
/// Adds the matt white material that Tachyon gives to shapes with an undefined texture. Returns its index.
int add_default_material(ParserState& state);
/// Reads the texture at the end of VCSTRI. This texture has no colour because the vertices have colours. The word VCST replaces
/// COLOR and TEXFUNC. Returns the material's index.
int parse_colorless_texture_body(Lexer& lexer, ParserState& state);
/// Reads the end of a shape: either a texture's name, or TEXTURE and a texture. Returns the material's index.
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

// Statements with many triangles (mesh_statements.cpp).
void parse_tpolyfile(Lexer& lexer, ParserState& state);
void parse_vertexarray(Lexer& lexer, ParserState& state);

// Fractal landscapes (landscape_statement.cpp).
void parse_scape(Lexer& lexer, ParserState& state);

// Lights (light_statements.cpp).
void parse_directional_light(Lexer& lexer, ParserState& state);
void parse_light(Lexer& lexer, ParserState& state);
void parse_spotlight(Lexer& lexer, ParserState& state);

}  // namespace lippmann::tachyon
