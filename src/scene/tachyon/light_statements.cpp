#include <fmt/format.h>

#include <algorithm>

#include "scene/tachyon/parser.hpp"

namespace lippmann::tachyon {
namespace {

float parse_visible_radius(Lexer& lexer) {
  const float radius = lexer.number_after("RAD");
  if (radius < 0.0f) throw lexer.error(fmt::format("RAD is {}", radius), "a number >= 0");
  return radius;
}

void parse_attenuated_color(Lexer& lexer, Light& light) {
  const std::string_view word = lexer.word("COLOR");
  if (is_keyword(word, "COLOR")) {
    light.color = lexer.vector("COLOR");
    return;
  }
  if (!is_keyword(word, "ATTENUATION"))
    throw lexer.error(fmt::format("expected COLOR, found {}", shown(word)), "ATTENUATION, COLOR");
  light.attenuation.x = lexer.number_after("CONSTANT");
  light.attenuation.y = lexer.number_after("LINEAR");
  light.attenuation.z = lexer.number_after("QUADRATIC");
  const Vec3f a = light.attenuation;
  if (std::min({a.x, a.y, a.z}) < 0.0f || a == Vec3f(0.0f))
    throw lexer.error(fmt::format("ATTENUATION is {}, {}, {}", a.x, a.y, a.z), "three numbers >= 0, at least one of them > 0");
  light.color = lexer.vector_after("COLOR");
}

Vec3f parse_direction(Lexer& lexer) {
  const Vec3f direction = lexer.vector_after("DIRECTION");
  if (direction == Vec3f(0.0f)) throw lexer.error("DIRECTION is zero", "a non-zero vector");
  return direction;
}

}  // namespace

void parse_light(Lexer& lexer, ParserState& state) {
  Light light;
  const Vec3f center = lexer.point_after("CENTER");
  light.visible_radius = parse_visible_radius(lexer);
  parse_attenuated_color(lexer, light);
  state.builder.add_light(std::move(light), center);
}

void parse_spotlight(Lexer& lexer, ParserState& state) {
  Light light;
  light.kind = LightKind::kSpot;
  const Vec3f center = lexer.point_after("CENTER");
  light.visible_radius = parse_visible_radius(lexer);
  const Vec3f direction = parse_direction(lexer);
  const float start = lexer.number_after("FALLOFF_START"), end = lexer.number_after("FALLOFF_END");
  if (!(0.0f <= start && start <= end && end <= 180.0f))
    throw lexer.error(fmt::format("the falloff runs from {} to {} degrees", start, end),
                      "0 <= FALLOFF_START <= FALLOFF_END <= 180");
  light.inner_cone = radians(start);
  light.outer_cone = std::min(radians(end), kPi);
  parse_attenuated_color(lexer, light);
  state.builder.add_light(std::move(light), center, direction);
}

void parse_directional_light(Lexer& lexer, ParserState& state) {
  Light light;
  light.kind = LightKind::kDirectional;
  const Vec3f direction = parse_direction(lexer);
  light.color = lexer.vector_after("COLOR");
  state.builder.add_light(std::move(light), Vec3f(0.0f), direction);
}

}  // namespace lippmann::tachyon
