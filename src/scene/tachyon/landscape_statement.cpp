#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/tachyon/landscape.hpp"
#include "scene/tachyon/parser.hpp"

namespace lippmann::tachyon {
namespace {

using Vertex = SceneBuilder::Vertex;

float positive(Lexer& lexer, std::string_view keyword) {
  const float value = lexer.number(keyword);
  constexpr float kLargest = 1e18f;  // avoids overflow when corner coordinates are computed
  if (!(value > 0.0f && value <= kLargest))
    throw lexer.error(fmt::format("{} is {}", keyword, value), "a number above 0, at most 1e18");
  return value;
}

/// Normals are central differences of the heights. Along the border, normals are vertical.
std::vector<Vertex> landscape_vertices(const LandscapeSize& size, Vec3f center) {
  const std::vector<double> heights = landscape_heights(size);
  const double step_x = size.width / (size.columns - 1), step_z = size.depth / (size.rows - 1);
  const auto height = [&](int x, int z) {
    return heights[static_cast<std::size_t>(z) * static_cast<std::size_t>(size.columns) + static_cast<std::size_t>(x)];
  };
  std::vector<Vertex> vertices;
  vertices.reserve(heights.size());
  for (int z = 0; z < size.rows; ++z)
    for (int x = 0; x < size.columns; ++x) {
      Vertex vertex;
      vertex.position =
          Vec3f(glm::dvec3(center) + glm::dvec3(x * step_x - size.width / 2, height(x, z), z * step_z - size.depth / 2));
      const bool border = x == 0 || z == 0 || x == size.columns - 1 || z == size.rows - 1;
      vertex.normal = border ? Vec3f(0.0f, 1.0f, 0.0f)
                             : Vec3f(glm::normalize(glm::dvec3((height(x - 1, z) - height(x + 1, z)) / (2 * step_x), 1.0,
                                                               (height(x, z - 1) - height(x, z + 1)) / (2 * step_z))));
      vertices.push_back(vertex);
    }
  return vertices;
}

void add_landscape(SceneBuilder& builder, int material, const LandscapeSize& size, Vec3f center) {
  const std::vector<Vertex> vertices = landscape_vertices(size, center);
  SceneBuilder::IndexedTriangles triangles(builder, vertices);
  triangles.set_material(material, false);
  for (int z = 0; z + 1 < size.rows; ++z)
    for (int x = 0; x + 1 < size.columns; ++x) {
      const int corner = z * size.columns + x;
      triangles.add(corner, corner + size.columns + 1, corner + 1);
      triangles.add(corner, corner + size.columns, corner + size.columns + 1);
    }
}

}  // namespace

void parse_scape(Lexer& lexer, ParserState& state) {
  constexpr int kLargestSide = 2048;
  constexpr std::int64_t kMostSteps =
      std::int64_t{2} * kLargestSide * kLargestSide;  // for one scene, so that a tiny file cannot take very long
  LandscapeSize size;
  lexer.expect("RES");
  size.columns = lexer.integer("RES", 2, kLargestSide);
  size.rows = lexer.integer("RES", 2, kLargestSide);
  const std::int64_t larger = std::max(size.columns, size.rows);
  state.landscape_steps += larger * larger;
  if (state.landscape_steps > kMostSteps)
    throw lexer.error("the scene's landscapes are too large", "a sum of the squared larger sides of at most 8388608");
  lexer.expect("SCALE");
  size.width = positive(lexer, "SCALE");
  size.depth = positive(lexer, "SCALE");
  const Vec3f center = lexer.point_after("CENTER");
  add_landscape(state.builder, parse_texture_reference(lexer, state), size, center);
}

}  // namespace lippmann::tachyon
