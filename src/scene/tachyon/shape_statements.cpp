#include <fmt/format.h>

#include <limits>
#include <vector>

#include "scene/tachyon/parser.hpp"

namespace lippmann::tachyon {
namespace {

float size_after(Lexer& lexer, std::string_view keyword) {
  const float size = lexer.number_after(keyword);
  if (size < 0.0f) throw lexer.error(fmt::format("{} is {}", keyword, size), "a number >= 0");
  return size;
}

Vec3f normal_after(Lexer& lexer, std::string_view keyword) {
  const Vec3f normal = lexer.vector_after(keyword);
  if (normal == Vec3f(0.0f)) throw lexer.error(fmt::format("{} is zero", keyword), "a non-zero vector");
  return normal;
}

std::array<SceneBuilder::Vertex, 3> parse_smooth_corners(Lexer& lexer) {
  std::array<SceneBuilder::Vertex, 3> corners;
  corners[0].position = lexer.point_after("V0");
  corners[1].position = lexer.point_after("V1");
  corners[2].position = lexer.point_after("V2");
  corners[0].normal = lexer.vector_after("N0");
  corners[1].normal = lexer.vector_after("N1");
  corners[2].normal = lexer.vector_after("N2");
  return corners;
}

}  // namespace

void parse_tri(Lexer& lexer, ParserState& state) {
  const Vec3f v0 = lexer.point_after("V0"), v1 = lexer.point_after("V1"), v2 = lexer.point_after("V2");
  state.builder.add_triangle(parse_texture_reference(lexer, state), {v0, v1, v2});
}

void parse_stri(Lexer& lexer, ParserState& state) {
  const std::array<SceneBuilder::Vertex, 3> corners = parse_smooth_corners(lexer);
  state.builder.add_smooth_triangle(parse_texture_reference(lexer, state), corners);
}

void parse_vcstri(Lexer& lexer, ParserState& state) {
  std::array<SceneBuilder::Vertex, 3> corners = parse_smooth_corners(lexer);
  corners[0].color = lexer.vector_after("C0");
  corners[1].color = lexer.vector_after("C1");
  corners[2].color = lexer.vector_after("C2");
  state.builder.add_colored_triangle(parse_colorless_texture_body(lexer, state), corners);
}

void parse_sphere(Lexer& lexer, ParserState& state) {
  const Vec3f center = lexer.point_after("CENTER");
  const float radius = size_after(lexer, "RAD");
  state.builder.add_sphere(parse_texture_reference(lexer, state), center, radius);
}

void parse_plane(Lexer& lexer, ParserState& state) {
  const Vec3f point = lexer.point_after("CENTER"), normal = normal_after(lexer, "NORMAL");
  state.builder.add_plane(parse_texture_reference(lexer, state), point, normal);
}

void parse_ring(Lexer& lexer, ParserState& state) {
  const Vec3f center = lexer.point_after("CENTER"), normal = normal_after(lexer, "NORMAL");
  const float inner = size_after(lexer, "INNER"), outer = size_after(lexer, "OUTER");
  state.builder.add_ring(parse_texture_reference(lexer, state), center, normal, inner, outer);
}

void parse_box(Lexer& lexer, ParserState& state) {
  const Vec3f corner = lexer.point_after("MIN"), opposite = lexer.point_after("MAX");
  state.builder.add_box(parse_texture_reference(lexer, state), corner, opposite);
}

void parse_fcylinder(Lexer& lexer, ParserState& state) {
  const Vec3f base = lexer.point_after("BASE"), apex = lexer.point_after("APEX");
  const float radius = size_after(lexer, "RAD");
  state.builder.add_cylinder(parse_texture_reference(lexer, state), base, apex, radius);
}

void parse_polycylinder(Lexer& lexer, ParserState& state) {
  lexer.expect("POINTS");
  const int count = lexer.integer("POINTS", 1, std::numeric_limits<int>::max());
  std::vector<Vec3f> points;  // no reserve(): memory must not depend on an untrusted count
  for (int i = 0; i < count; ++i) points.push_back(lexer.point("POLYCYLINDER's points"));
  const float radius = size_after(lexer, "RAD");
  const int material = parse_texture_reference(lexer, state);
  for (std::size_t i = 0; i < points.size(); ++i) {
    state.builder.add_sphere(material, points[i], radius);
    if (i > 0) state.builder.add_cylinder(material, points[i - 1], points[i], radius);
  }
}

}  // namespace lippmann::tachyon
