// Renders a triangle in memory. Prints the version of the library and the colour in the middle.
#include <cstdio>
#include <exception>
#include <lippmann/lippmann.hpp>

#if LIPPMANN_VERSION != LIPPMANN_VERSION_MAJOR * 10000 + LIPPMANN_VERSION_MINOR * 100 + LIPPMANN_VERSION_PATCH
#error "the macros of the version disagree"
#endif

using namespace lippmann;

int main() try {
  Scene scene;
  const int node = scene.add_node({.name = "corner", .local = {.translation = Vec3f(0.0f, 0.0f, -1.0f)}});
  const int shape = scene.add_mesh({.positions = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, .triangles = {{0, 1, 2}}});
  const int material =
      scene.add_material({.name = "green", .surface = MetallicRoughness{.base_color = {0, 1, 0, 1}, .unlit = true}});
  const int instance = scene.add_instance({.shape = shape, .material = material, .node = node});
  if (node != 0 || shape != 0 || material != 0 || instance != 0) return 1;
  if (scene.add_node({}) != 1 || scene.add_shape(Spheres{}) != 1 || scene.add_material({}) != 1) return 1;

  const Optics optics{.panel = {.width = 9, .height = 9, .pixel_pitch_mm = 1.0f}, .model = SingleView{}};
  Renderer renderer(scene, place(scene, optics), {}, Context{});
  const RenderedFrame frame = *renderer.frame(0);
  const float* middle = frame.pictures.film.pixel(4, 4);
  std::printf("%s, %s: %.2f %.2f %.2f\n", LIPPMANN_VERSION_STRING, version(), double{middle[0]}, double{middle[1]},
              double{middle[2]});
} catch (const std::exception& error) {
  std::fprintf(stderr, "triangle: %s\n", error.what());
  return 1;
}
