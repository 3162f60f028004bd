#include "scene/tachyon/parser.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "core/suggest.hpp"
#include "scene/directions.hpp"
#include "scene/tachyon/handedness.hpp"

namespace lippmann::tachyon {
namespace {

constexpr int kDeepestInclude = 16, kMostIncludes = 1000;
constexpr int kLargestResolution = 65536;

void parse_statements(Lexer& lexer, ParserState& state, bool must_end);

void parse_background(Lexer& lexer, ParserState& state) {
  state.background.horizon = state.background.zenith = lexer.vector("BACKGROUND");
}

/// For a ray with the direction d, let h be the dot product of d and UPDIR. The colour is BOTTOMCOLOR where h <= BOTTOMVAL,
/// TOPCOLOR where h >= TOPVAL, and a blend in between. For SKY_ORTHO_PLANE, d is the origin of the ray instead of its
/// direction.
void parse_background_gradient(Lexer& lexer, ParserState& state) {
  const std::string kind = upper(lexer.word("SKY_SPHERE"));
  if (kind != "SKY_SPHERE" && kind != "SKY_ORTHO_PLANE")
    throw lexer.error(fmt::format("BACKGROUND_GRADIENT {} is not known", shown(kind)), "SKY_SPHERE, SKY_ORTHO_PLANE");
  Background gradient;
  const Vec3f up = lexer.vector_after("UPDIR");
  if (up == Vec3f(0.0f)) throw lexer.error("UPDIR is zero", "a non-zero vector");
  const double length = glm::length(glm::dvec3(up));
  gradient.up = mirrored(direction_of(up));
  gradient.zenith_at = static_cast<float>(lexer.number_after("TOPVAL") / length);
  gradient.horizon_at = static_cast<float>(lexer.number_after("BOTTOMVAL") / length);
  if (!(std::isfinite(gradient.zenith_at) && std::isfinite(gradient.horizon_at)) || gradient.zenith_at == gradient.horizon_at)
    throw lexer.error("TOPVAL and BOTTOMVAL do not define a gradient", "two different heights");
  gradient.zenith = lexer.vector_after("TOPCOLOR");
  gradient.horizon = lexer.vector_after("BOTTOMCOLOR");
  state.gradient = gradient;
  state.gradient_is_plane = kind == "SKY_ORTHO_PLANE";
}

void parse_camera_statement(Lexer& lexer, ParserState& state) { state.camera = parse_camera(lexer, state.context); }

void parse_include(Lexer& lexer, ParserState& state) {
  const std::string name(lexer.word("INCLUDE's file name"));
  if (state.include_depth >= kDeepestInclude || ++state.includes > kMostIncludes)
    throw lexer.error(fmt::format("INCLUDE {} exceeds a limit", shown(name)),
                      fmt::format("at most {} nested files and {} in total", kDeepestInclude, kMostIncludes));
  const std::filesystem::path file = state.folder.resolve(name, lexer.where());
  Lexer included(file.string(), state.folder.read_text(file, lexer.where()));
  included.set_origin(lexer.origin());
  ++state.include_depth;
  parse_statements(included, state, false);
  --state.include_depth;
}

void parse_fog(Lexer& lexer, ParserState& state) {
  state.left_out.add("FOG", lexer.where());
  const std::string kind = upper(lexer.word("FOG's kind"));
  if (kind != "LINEAR" && kind != "EXP" && kind != "EXP2" && kind != "OFF")
    throw lexer.error(fmt::format("FOG {} is not known", shown(kind)), "LINEAR, EXP, EXP2, OFF");
  lexer.number_after("START"), lexer.number_after("END"), lexer.number_after("DENSITY");
  lexer.vector_after("COLOR");
}

void parse_sky_light(Lexer& lexer, ParserState& state) {
  state.left_out.add("SKY_LIGHT", lexer.where());
  lexer.number_after("NUMSAMPLES");
  lexer.vector_after("COLOR");
}

struct Statement {
  std::string_view keyword;
  void (*parse)(Lexer&, ParserState&);
};

constexpr Statement kStatements[] = {
    // sorted by keyword, for the binary search
    {"BACKGROUND", parse_background},
    {"BACKGROUND_GRADIENT", parse_background_gradient},
    {"BOX", parse_box},
    {"CAMERA", parse_camera_statement},
    {"DIRECTIONAL_LIGHT", parse_directional_light},
    {"FCYLINDER", parse_fcylinder},
    {"FOG", parse_fog},
    {"IMAGEDEF", parse_imagedef},
    {"INCLUDE", parse_include},
    {"LIGHT", parse_light},
    {"PLANE", parse_plane},
    {"POLYCYLINDER", parse_polycylinder},
    {"RING", parse_ring},
    {"SCAPE", parse_scape},
    {"SHADER_MODE", parse_shader_mode},
    {"SKY_LIGHT", parse_sky_light},
    {"SPHERE", parse_sphere},
    {"SPOTLIGHT", parse_spotlight},
    {"STRI", parse_stri},
    {"TEXALIAS", parse_texalias},
    {"TEXDEF", parse_texdef},
    {"TPOLYFILE", parse_tpolyfile},
    {"TRI", parse_tri},
    {"VCSTRI", parse_vcstri},
    {"VERTEXARRAY", parse_vertexarray},
};

/// Statements of Tachyon that this reader does not support. Their error message does not suggest another spelling.
constexpr std::string_view kUnsupported[] = {"CYLINDER",  "END_CLIPGROUP", "MGFFILE",
                                             "SCALARVOL", "SPHEREARRAY",   "START_CLIPGROUP"};

std::vector<std::string_view> statement_keywords() {
  std::vector<std::string_view> keywords;
  for (const Statement& statement : kStatements) keywords.push_back(statement.keyword);
  keywords.emplace_back("END_SCENE");
  return keywords;
}

Error unknown_statement(const Lexer& lexer, const std::string& word) {
  const std::vector<std::string_view> known = statement_keywords();
  const std::string accepted = fmt::format("{}", fmt::join(known, ", "));
  if (std::find(std::begin(kUnsupported), std::end(kUnsupported), word) != std::end(kUnsupported))
    return lexer.error(fmt::format("{} is not supported", word), accepted);
  const std::string nearest = nearest_name(word, known);
  return lexer.error(fmt::format("{} is not a statement of a scene{}", shown(word),
                                 nearest.empty() ? "" : fmt::format(" (did you mean {}?)", nearest)),
                     accepted);
}

/// Reads statements up to END_SCENE or the end of the file. If `must_end` is true, a missing END_SCENE is an Error.
void parse_statements(Lexer& lexer, ParserState& state, bool must_end) {
  while (must_end || !lexer.at_end()) {
    const std::string word = upper(lexer.word("END_SCENE"));
    if (word == "END_SCENE") return;
    const auto* const statement = std::lower_bound(std::begin(kStatements), std::end(kStatements), word,
                                                   [](const Statement& s, const std::string& w) { return s.keyword < w; });
    if (statement == std::end(kStatements) || statement->keyword != word) throw unknown_statement(lexer, word);
    statement->parse(lexer, state);
  }
}

}  // namespace

void parse_scene(Lexer& lexer, ParserState& state) {
  lexer.expect("BEGIN_SCENE");
  lexer.expect("RESOLUTION");
  state.resolution.x = lexer.integer("RESOLUTION", 1, kLargestResolution);
  state.resolution.y = lexer.integer("RESOLUTION", 1, kLargestResolution);
  parse_statements(lexer, state, true);
}

}  // namespace lippmann::tachyon
