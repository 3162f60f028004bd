// Based on: E. Haines, "Neutral File Format", version 3.9, 1996. Line ends only matter in the statement "l", whose last
// parameters may be absent.
#include "scene/nff.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <vector>

#include "core/printable.hpp"
#include "scene/directions.hpp"
#include "scene/lexer.hpp"
#include "scene/nff/builder.hpp"
#include "scene/polygon.hpp"
#include "scene/text_file.hpp"

namespace lippmann {
namespace nff {
namespace {

constexpr std::size_t kLargestFile = std::size_t{256} << 20;
constexpr float kLargestNumber = 1e18f;  // squares and products of two such numbers are finite floats
constexpr int kMostCones = 100'000;      // limits memory: a cone needs about 5 KB
constexpr int kMostCorners = 1 << 30, kLargestResolution = 65536;

struct View {
  std::optional<Vec3f> from, at, up;
  std::optional<float> angle;
  Vec2i resolution{0, 0};
};

struct PointLight {
  Vec3f position{0.0f};
  std::optional<Vec3f> color;
};

struct State {
  Builder builder;
  std::vector<PointLight> lights;
  std::optional<View> view;
  Vec3f background{0.0f};
};

float number(Lexer& lexer, std::string_view wanted) { return lexer.number(wanted, kLargestNumber); }

Vec3f vector(Lexer& lexer, std::string_view wanted) { return lexer.vector(wanted, kLargestNumber); }
Vec3f point(Lexer& lexer, std::string_view wanted) { return lexer.point(wanted, kLargestNumber); }

float number_within(Lexer& lexer, std::string_view wanted, float lowest, float highest) {
  const float value = number(lexer, wanted);
  if (!(lowest <= value && value <= highest))
    throw lexer.error(fmt::format("{} is {}", wanted, value), fmt::format("a number from {:g} to {:g}", lowest, highest));
  return value;
}

void parse_background(Lexer& lexer, State& state) { state.background = vector(lexer, "b"); }

void require_view(const View& view, const Lexer& lexer) {
  if (!view.from || !view.at || !view.up || !view.angle)
    throw lexer.error("the view \"v\" is not complete", "from, at, up and angle; hither and resolution are optional");
  if (!(*view.angle > 0.0f && *view.angle < 180.0f))
    throw lexer.error(fmt::format("the view's angle is {}", *view.angle), "degrees above 0 and below 180");
  const glm::dvec3 along = glm::dvec3(*view.at) - glm::dvec3(*view.from), up(*view.up);
  // Smallest accepted sine of the angle between the view direction and up. Below it, the result depends on the rounding of
  // digits.
  constexpr double kSine = 1e-6;
  if (!(glm::length(glm::cross(along, up)) > kSine * glm::length(along) * glm::length(up)))
    throw lexer.error("the view's from, at and up do not span a plane",
                      "different points from and at, and up not parallel to the view");
}

void parse_view(Lexer& lexer, State& state) {
  View view;
  for (;;) {
    const std::string_view part = lexer.peek();
    if (part == "from") {
      lexer.word("from"), view.from = point(lexer, "from");
    } else if (part == "at") {
      lexer.word("at"), view.at = point(lexer, "at");
    } else if (part == "up") {
      lexer.word("up"), view.up = vector(lexer, "up");
    } else if (part == "angle") {
      lexer.word("angle"), view.angle = number(lexer, "angle");
    } else if (part == "hither" || part == "yon") {
      lexer.word("hither"), number(lexer, "hither");
    } else if (part == "resolution") {
      lexer.word("resolution");
      view.resolution.x = lexer.integer("resolution", 1, kLargestResolution);
      view.resolution.y = lexer.integer("resolution", 1, kLargestResolution);
    } else {
      break;
    }
  }
  require_view(view, lexer);
  state.view = view;
}

void parse_light(Lexer& lexer, State& state) {
  PointLight light;
  light.position = point(lexer, "l");
  if (!lexer.at_line_end()) light.color = vector(lexer, "l's colour");
  state.lights.push_back(light);
}

void parse_fill(Lexer& lexer, State& state) {
  Fill fill;
  fill.color = vector(lexer, "f's colour");
  fill.diffuse = number_within(lexer, "f's Kd", 0.0f, kLargestNumber);
  fill.specular = number_within(lexer, "f's Ks", 0.0f, kLargestNumber);
  fill.shine = number_within(lexer, "f's Shine", 0.0f, kLargestNumber);
  fill.transmittance = number_within(lexer, "f's T", 0.0f, 1.0f);
  fill.ior = number(lexer, "f's index of refraction");
  if (fill.transmittance > 0.0f && !(fill.ior > 0.0f))
    throw lexer.error(fmt::format("the index of refraction of a transparent surface is {}", fill.ior), "a number above 0");
  state.builder.set_fill(fill);
}

/// Negative radii mean a surface seen from inside; their sign is ignored because both sides are visible.
void parse_cone(Lexer& lexer, State& state) {
  const Vec3f base = point(lexer, "c's base");
  const float base_radius = number(lexer, "c's base radius");
  const Vec3f apex = point(lexer, "c's apex");
  const float apex_radius = number(lexer, "c's apex radius");
  if (std::min(base_radius, apex_radius) < 0.0f && std::max(base_radius, apex_radius) > 0.0f)
    throw lexer.error("the radii of a cone have different signs", "both >= 0, or both <= 0");
  state.builder.add_cone(base, std::abs(base_radius), apex, std::abs(apex_radius));
  if (state.builder.cones() > kMostCones)
    throw lexer.error("there are too many cones",
                      fmt::format("at most {} with two radii; cylinders are unlimited", kMostCones));
}

void parse_sphere(Lexer& lexer, State& state) {
  const Vec3f center = point(lexer, "s");
  state.builder.add_sphere(center, std::abs(number(lexer, "s's radius")));
}

void parse_corners(Lexer& lexer, State& state, std::string_view keyword, bool has_normals) {
  const int count = lexer.integer(keyword, 3, kMostCorners);
  const std::string where = lexer.where();
  std::vector<Vec3f> corners, normals;
  for (int i = 0; i < count; ++i) {
    corners.push_back(point(lexer, keyword));
    if (has_normals) normals.push_back(vector(lexer, keyword));
  }
  if (corners.size() > kMostConcaveCorners && !turns_one_way(corners))
    throw Error(where, fmt::format("a concave polygon has {} corners", count), fmt::format("at most {}", kMostConcaveCorners));
  state.builder.add_polygon(corners, normals);
}

void parse_polygon(Lexer& lexer, State& state) { parse_corners(lexer, state, "p", false); }
void parse_patch(Lexer& lexer, State& state) { parse_corners(lexer, state, "pp", true); }

struct Statement {
  std::string_view keyword;
  void (*parse)(Lexer&, State&);
};

constexpr Statement kStatements[] = {
    {"b", parse_background}, {"v", parse_view},   {"l", parse_light},   {"f", parse_fill},
    {"c", parse_cone},       {"s", parse_sphere}, {"p", parse_polygon}, {"pp", parse_patch},
};

void parse_statement(Lexer& lexer, State& state) {
  const std::string_view word = lexer.word("a statement");
  for (const Statement& statement : kStatements)
    if (word == statement.keyword) return statement.parse(lexer, state);
  throw lexer.error(fmt::format("{} is not a statement of the Neutral File Format", shown(word)),
                    "b (background), v (view), l (light), f (fill), c (cone or cylinder), s (sphere), p (polygon), pp (patch)");
}

void add_camera(Scene& scene, const View& view) {
  const Vec3f along(glm::dvec3(*view.at) - glm::dvec3(*view.from));
  Node node;
  node.name = "camera";
  node.local.translation = *view.from;
  node.local.rotation = looking_along(direction_of(along), *view.up);
  Camera camera;
  camera.name = node.name;
  camera.node = static_cast<int>(scene.nodes.size());
  camera.vertical_fov = radians(*view.angle);
  camera.focus_distance = static_cast<float>(glm::length(glm::dvec3(along)));
  if (view.resolution.y > 0) camera.aspect = static_cast<float>(view.resolution.x) / static_cast<float>(view.resolution.y);
  scene.resolution = view.resolution;
  scene.nodes.push_back(std::move(node));
  scene.cameras.push_back(std::move(camera));
}

void add_lights(Scene& scene, const std::vector<PointLight>& lights) {
  const float intensity = 1.0f / std::sqrt(static_cast<float>(lights.size()));
  for (const PointLight& point : lights) {
    Node node;
    node.name = fmt::format("light {}", scene.lights.size());
    node.local.translation = point.position;
    Light light;
    light.name = node.name;
    light.node = static_cast<int>(scene.nodes.size());
    light.color = point.color.value_or(Vec3f(intensity));
    scene.nodes.push_back(std::move(node));
    scene.lights.push_back(std::move(light));
  }
}

}  // namespace
}  // namespace nff

Scene parse_nff(const std::string& name, std::string text, const Context& context, const Vec3d& origin) {
  Lexer lexer(name, std::move(text));
  lexer.set_origin(origin);
  nff::State state;
  while (!lexer.at_end()) nff::parse_statement(lexer, state);
  if (const int count = state.builder.left_out(); count > 0)
    context.warning(fmt::format("{}: {} shapes without extent are left out.", name, count));
  Scene scene;
  scene.origin = origin;
  state.builder.finish(scene);
  if (state.view) nff::add_camera(scene, *state.view);
  nff::add_lights(scene, state.lights);
  scene.background.horizon = scene.background.zenith = state.background;
  return scene;
}

Scene load_nff(const std::filesystem::path& path, const Context& context, const Vec3d& origin) {
  Scene scene =
      parse_nff(path.string(), utf8_text(read_text_file(path, path.string(), nff::kLargestFile, "at most 256 MiB of text")),
                context, origin);
  scene.name = path.stem().string();
  return scene;
}

}  // namespace lippmann
