#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "scene/tachyon/parser.hpp"

namespace lippmann::tachyon {
namespace {

constexpr int kAnyCount = std::numeric_limits<int>::max();
using Vertex = SceneBuilder::Vertex;
using IndexedTriangles = SceneBuilder::IndexedTriangles;

std::vector<Vertex> parse_vertices(Lexer& lexer) {
  lexer.expect("NUMVERTS");
  const int count = lexer.integer("NUMVERTS", 1, kAnyCount);
  std::vector<Vertex> vertices;  // no reserve(): memory must not depend on an untrusted count
  lexer.expect("COORDS");
  for (int i = 0; i < count; ++i) vertices.push_back({.position = lexer.point("COORDS")});
  lexer.expect("NORMALS");
  for (Vertex& vertex : vertices) vertex.normal = lexer.vector("NORMALS");
  return vertices;
}

void add_indexed(Lexer& lexer, IndexedTriangles& triangles, int i0, int i1, int i2) {
  if (!triangles.add(i0, i1, i2))
    throw lexer.error(fmt::format("a triangle of the vertices {}, {} and {} is outside its VERTEXARRAY", i0, i1, i2),
                      "indices from 0 below NUMVERTS");
}

void parse_trimesh(Lexer& lexer, IndexedTriangles& triangles) {
  const int count = lexer.integer("TRIMESH", 0, kAnyCount);
  for (int i = 0; i < count; ++i) {
    const int i0 = lexer.integer("TRIMESH", 0, kAnyCount);
    const int i1 = lexer.integer("TRIMESH", 0, kAnyCount);
    const int i2 = lexer.integer("TRIMESH", 0, kAnyCount);
    add_indexed(lexer, triangles, i0, i1, i2);
  }
}

/// Every vertex of a strip forms a triangle with the two vertices before it, with alternating winding.
void parse_tristrip(Lexer& lexer, IndexedTriangles& triangles) {
  const int count = lexer.integer("TRISTRIP", 0, kAnyCount);
  int before_last = 0, last = 0;
  for (int i = 0; i < count; ++i) {
    const int index = lexer.integer("TRISTRIP", 0, kAnyCount);
    if (i >= 2 && i % 2 == 0) add_indexed(lexer, triangles, before_last, last, index);
    if (i >= 2 && i % 2 == 1) add_indexed(lexer, triangles, last, before_last, index);
    before_last = last;
    last = index;
  }
}

/// Returns Tachyon's matrix for rotations about x, y and z. It is not a proper rotation: the term sin y in the third row should
/// be negative. We keep Tachyon's sign so that pictures are the same.
glm::dmat3 tpoly_rotation(Vec3f degrees) {
  const glm::dvec3 angle = glm::dvec3(degrees) * (std::numbers::pi / 180.0);
  const glm::dvec3 s = glm::sin(angle), c = glm::cos(angle);
  const glm::dvec3 row0(c.y * c.z, s.x * s.y * c.z - c.x * s.z, s.x * s.z + c.x * c.z * s.y);
  const glm::dvec3 row1(c.y * s.z, c.x * c.z + s.x * s.y * s.z, c.x * s.y * s.z - s.x * c.z);
  const glm::dvec3 row2(s.y, s.x * c.y, c.x * c.y);
  return glm::transpose(glm::dmat3(row0, row1, row2));
}

struct Placement {
  Vec3f scale;
  glm::dmat3 rotation;
  Vec3f center;

  Vec3f operator()(Vec3f p, const Lexer& lexer) const {
    const Vec3f placed(rotation * (glm::dvec3(scale) * glm::dvec3(p)) + glm::dvec3(center));
    if (std::isfinite(placed.x) && std::isfinite(placed.y) && std::isfinite(placed.z)) return placed;
    throw lexer.error("SCALE puts a corner out of range");
  }
};

}  // namespace

void parse_vertexarray(Lexer& lexer, ParserState& state) {
  constexpr std::string_view kBlocks = "COLORS, TEXTURE, TRIMESH, TRISTRIP, END_VERTEXARRAY";
  std::vector<Vertex> vertices = parse_vertices(lexer);
  IndexedTriangles triangles(state.builder, vertices);
  std::optional<int> material;
  bool colored = false;
  const auto use = [&](int next) {
    material = next;
    triangles.set_material(colored ? state.builder.whitened(next) : next, colored);
  };
  for (;;) {
    const std::string block = upper(lexer.word("END_VERTEXARRAY"));
    if (block == "END_VERTEXARRAY") return;
    if (block == "COLORS") {
      for (Vertex& vertex : vertices) vertex.color = lexer.vector("COLORS");
      colored = true;
      use(material ? *material : add_default_material(state));
    } else if (block == "TEXTURE") {
      use(parse_texture_body(lexer, state, fmt::format("line {}", lexer.line())));
    } else if (block == "TRIMESH" || block == "TRISTRIP") {
      if (!material) use(add_default_material(state));
      block == "TRIMESH" ? parse_trimesh(lexer, triangles) : parse_tristrip(lexer, triangles);
    } else {
      throw lexer.error(fmt::format("{} is not a block of VERTEXARRAY", shown(block)), std::string(kBlocks));
    }
  }
}

void parse_tpolyfile(Lexer& lexer, ParserState& state) {
  Placement place;
  place.scale = lexer.vector_after("SCALE");
  place.rotation = tpoly_rotation(lexer.vector_after("ROT"));
  place.center = lexer.point_after("CENTER");
  lexer.expect("FILE");
  const std::string_view name = lexer.word("TPOLYFILE's file name");
  const std::filesystem::path file = state.folder.resolve(name, lexer.where());
  Lexer polygons(file.string(), state.folder.read_text(file, lexer.where()));
  const int material = parse_texture_reference(lexer, state);
  while (!polygons.at_end()) {
    polygons.integer("the number of a polygon's corners", 3, 3);
    std::array<Vec3f, 3> corners;
    for (Vec3f& corner : corners) corner = place(polygons.vector("a polygon's corners"), polygons);
    state.builder.add_triangle(material, {corners[1], corners[0], corners[2]});
  }
}

}  // namespace lippmann::tachyon
