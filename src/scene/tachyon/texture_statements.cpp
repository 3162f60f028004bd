#include <fmt/format.h>

#include <limits>

#include "scene/tachyon/image_map.hpp"
#include "scene/tachyon/parser.hpp"

namespace lippmann::tachyon {
namespace {

constexpr int kConstantTexture = 0, kCylindricalImage = 7, kSphericalImage = 8, kPlanarImage = 9, kLastTexfunc = 10;

void parse_highlight(Lexer& lexer, PhongSurface& surface) {
  const std::string kind = upper(lexer.word("PLASTIC or METAL"));
  if (kind != "PLASTIC" && kind != "METAL")
    throw lexer.error(fmt::format("PHONG {} is not known", shown(kind)), "PLASTIC, METAL");
  surface.highlight_kind = kind == "METAL" ? Highlight::kMetal : Highlight::kPlastic;
  surface.highlight = lexer.number("PHONG");
  surface.highlight_size = lexer.number_after("PHONG_SIZE");
}

void parse_coefficients(Lexer& lexer, ParserState& state, PhongSurface& surface, std::string_view last) {
  surface.ambient = lexer.number_after("AMBIENT");
  surface.diffuse = lexer.number_after("DIFFUSE");
  surface.mirror = lexer.number_after("SPECULAR");
  const float opacity = lexer.number_after("OPACITY");
  if (opacity < 0.0f) throw lexer.error(fmt::format("OPACITY is {}", opacity), "a number >= 0");
  surface.opacity = std::min(opacity, 1.0f);
  std::string_view word = lexer.word(last);
  if (is_keyword(word, "TRANSMODE")) {
    const std::string mode = upper(lexer.word("TRANSMODE's name"));
    if (mode == "R3D") state.left_out.add("TRANSMODE R3D", lexer.where());
    word = lexer.word(last);
  }
  if (is_keyword(word, "OUTLINE")) {
    if (lexer.number("OUTLINE") != 0.0f) state.left_out.add("OUTLINE", lexer.where());
    lexer.number_after("OUTLINE_WIDTH");
    word = lexer.word(last);
  }
  if (is_keyword(word, "PHONG")) {
    parse_highlight(lexer, surface);
    word = lexer.word(last);
  }
  if (!is_keyword(word, last))
    throw lexer.error(fmt::format("expected {}, found {}", last, shown(word)),
                      fmt::format("TRANSMODE, OUTLINE, PHONG, {}", last));
}

int image_named(Lexer& lexer, ParserState& state) {
  const std::string_view name = lexer.word("the image map's file name");
  if (const auto known = state.images.find(name); known != state.images.end()) return known->second;
  const SideFile file = state.folder.find(name, lexer.where());
  const bool usable = file.problem.empty();
  if (!usable) state.context.warning(fmt::format("{}: the image map {}; white is shown.", lexer.where(), file.problem));
  const int texture =
      state.builder.add_texture(usable ? read_image_map(file.path, lexer.where()) : white_image_map(std::string(name)));
  state.images.emplace(name, texture);
  return texture;
}

/// Reads the parameters of an image map. The axis of cylinders and spheres is y. In Tachyon's world, u runs from x towards z.
/// In our mirrored world, u runs from x towards -z, which is v_axis x u_axis.
void parse_image_map(Lexer& lexer, ParserState& state, ProjectionKind kind, PhongSurface& surface) {
  surface.texture = image_named(lexer, state);
  ImageProjection projection;
  projection.kind = kind;
  projection.center = lexer.point_after("CENTER");
  projection.rotate = lexer.vector_after("ROTATE");
  projection.scale = lexer.vector_after("SCALE");
  if (kind == ProjectionKind::kPlane) {
    projection.u_axis = lexer.vector_after("UAXIS");
    projection.v_axis = lexer.vector_after("VAXIS");
  }
  surface.projection = projection;
}

void parse_texfunc(Lexer& lexer, ParserState& state, PhongSurface& surface) {
  const int function = lexer.integer("TEXFUNC", 0, std::numeric_limits<int>::max());
  switch (function) {
    case kConstantTexture:
      return;
    case kCylindricalImage:
      return parse_image_map(lexer, state, ProjectionKind::kCylinder, surface);
    case kSphericalImage:
      return parse_image_map(lexer, state, ProjectionKind::kSphere, surface);
    case kPlanarImage:
      return parse_image_map(lexer, state, ProjectionKind::kPlane, surface);
    default:
      throw lexer.error(fmt::format("TEXFUNC {} is not {}", function, function <= kLastTexfunc ? "supported" : "known"),
                        "TEXFUNC 0 (plain colour), 7, 8 and 9 (cylindrical, spherical and planar image map)");
  }
}

/// If the name is already defined, the first definition stays valid, as in Tachyon.
void define(Lexer& lexer, ParserState& state, std::string name, int material) {
  const auto [entry, is_new] = state.textures.emplace(std::move(name), material);
  if (is_new || entry->second == material || state.redefined_textures++ > 0) return;
  state.context.warning(
      fmt::format("{}: {} (and possibly others) is redefined with different values; the first definition applies.",
                  lexer.where(), shown(entry->first)));
}

int material_named(Lexer& lexer, ParserState& state, std::string_view name) {
  if (const auto known = state.textures.find(name); known != state.textures.end()) return known->second;
  if (state.undefined_textures++ == 0)
    state.context.warning(fmt::format("{}: the texture {} (and possibly others) is not defined; plain white is used.",
                                      lexer.where(), shown(name)));
  return add_default_material(state);
}

/// Reads a colour of 3, 6, 9 or 12 hexadecimal digits, and returns the leading 8 bits of red, green and blue. A single digit
/// per channel is doubled.
std::array<std::uint8_t, 3> parse_hex_color(Lexer& lexer) {
  const std::string_view word = lexer.word("a colour in hexadecimal digits");
  const bool digits = word.find_first_not_of("0123456789abcdefABCDEF") == word.npos;
  if (!digits || word.empty() || word.size() % 3 != 0 || word.size() > 12)
    throw lexer.error(fmt::format("{} is not a colour", shown(word)), "3, 6, 9 or 12 hexadecimal digits");
  const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
  const std::size_t width = word.size() / 3;
  std::array<std::uint8_t, 3> color;
  for (std::size_t k = 0; k < 3; ++k) {
    const int high = digit(word[k * width]), low = digit(word[k * width + (width > 1 ? 1 : 0)]);
    color[k] = static_cast<std::uint8_t>(16 * high + low);
  }
  return color;
}

}  // namespace

int add_default_material(ParserState& state) {
  PhongSurface surface;
  surface.color = Vec3f(1.0f);
  surface.ambient = 0.1f, surface.diffuse = 0.9f;
  return state.builder.add_material(surface, "default");
}

int parse_texture_body(Lexer& lexer, ParserState& state, std::string name) {
  PhongSurface surface;
  parse_coefficients(lexer, state, surface, "COLOR");
  surface.color = lexer.vector("COLOR");
  lexer.expect("TEXFUNC");
  parse_texfunc(lexer, state, surface);
  return state.builder.add_material(surface, std::move(name));
}

int parse_colorless_texture_body(Lexer& lexer, ParserState& state) {
  PhongSurface surface;
  surface.color = Vec3f(1.0f);
  std::string name = fmt::format("line {}", lexer.line());
  parse_coefficients(lexer, state, surface, "VCST");
  return state.builder.add_material(surface, std::move(name));
}

int parse_texture_reference(Lexer& lexer, ParserState& state) {
  const std::string_view word = lexer.word("TEXTURE or a texture's name");
  if (is_keyword(word, "TEXTURE")) return parse_texture_body(lexer, state, fmt::format("line {}", lexer.line()));
  return material_named(lexer, state, word);
}

void parse_texdef(Lexer& lexer, ParserState& state) {
  std::string name(lexer.word("TEXDEF's name"));
  const int material = parse_texture_body(lexer, state, name);
  define(lexer, state, std::move(name), material);
}

void parse_texalias(Lexer& lexer, ParserState& state) {
  std::string name(lexer.word("TEXALIAS's name"));
  const int material = material_named(lexer, state, lexer.word("the texture of TEXALIAS"));
  define(lexer, state, std::move(name), material);
}

void parse_imagedef(Lexer& lexer, ParserState& state) {
  constexpr int kLargestSide = 65536;
  Texture texture;
  texture.name = std::string(lexer.word("IMAGEDEF's name"));
  texture.srgb = false;
  lexer.expect("FORMAT");
  lexer.expect("RGB24");
  lexer.expect("RESOLUTION");
  texture.width = lexer.integer("RESOLUTION", 1, kLargestSide);
  texture.height = lexer.integer("RESOLUTION", 1, kLargestSide);
  const int depth = lexer.integer("RESOLUTION", 1, kLargestSide);
  if (depth != 1)
    throw lexer.error(fmt::format("IMAGEDEF {} is a volume, which is not supported", shown(texture.name)), "a depth of 1");
  lexer.expect("ENCODING");
  lexer.expect("HEX");
  const std::int64_t pixels = std::int64_t{texture.width} * texture.height;
  for (std::int64_t i = 0; i < pixels; ++i) {  // no resize(): memory must not depend on an untrusted resolution
    const std::array<std::uint8_t, 3> color = parse_hex_color(lexer);
    texture.rgba.insert(texture.rgba.end(), {color[0], color[1], color[2], std::uint8_t{255}});
  }
  std::string name = texture.name;
  if (state.images.count(name)) throw lexer.error(fmt::format("the image {} is already defined", shown(name)));
  state.images.emplace(std::move(name), state.builder.add_texture(std::move(texture)));
}

}  // namespace lippmann::tachyon
