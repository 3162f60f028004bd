// Builds a scene in memory: a red ball that bounces in front of a wall, seen through a lenticular sheet. Writes the picture of
// the panel and the depth of its pixels for every frame.
//  own_scene FOLDER
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <lippmann/lippmann.hpp>

using namespace lippmann;

namespace {

Material surface(Vec3f color, float roughness) {
  MetallicRoughness material;
  material.base_color = Vec4f(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = roughness;
  return {"", material};
}

/// Lengths are in metres. Instances without a node, such as the wall and the floor, do not move.
Scene bouncing_ball() {
  Scene scene;
  const int ball = scene.add_node({.name = "ball"});
  scene.add_instance({.name = "ball",
                      .shape = scene.add_shape(Spheres{{Vec3f(0.0f), 0.5f}}),
                      .material = scene.add_material(surface({0.8f, 0.1f, 0.1f}, 0.3f)),
                      .node = ball});
  // the first plane is the wall, the second is the floor
  const int room = scene.add_shape(
      Planes{{Vec3f(0.0f, 0.0f, -2.0f), Vec3f(0.0f, 0.0f, 1.0f)}, {Vec3f(0.0f, -1.0f, 0.0f), Vec3f(0.0f, 1.0f, 0.0f)}});
  scene.add_instance({.name = "room", .shape = room, .material = scene.add_material(surface({0.6f, 0.6f, 0.7f}, 0.9f))});
  NodeAnimation bounce;
  bounce.node = ball;
  bounce.translation.times = {0.0, 0.5, 1.0};
  bounce.translation.values = {Vec3f(0.0f, 0.6f, 0.0f), Vec3f(0.0f, -0.5f, 0.0f), Vec3f(0.0f, 0.6f, 0.0f)};
  scene.timeline = {.frames_per_second = 4.0, .frame_count = 4, .animations = {bounce}};
  return scene;
}

Optics lenticular_sheet() {
  Optics optics;
  optics.panel = {.width = 256, .height = 192, .pixel_pitch_mm = 0.125f};
  optics.model = LenticularSheet{.lens_pitch_mm = 1.0f, .gap_mm = 2.0f};
  return optics;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: own_scene FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  const Context context;
  Scene scene = bouncing_ball();
  add_missing_light(scene, Integrator::kPath);
  FrameParams params;
  params.sampling.integrator = Integrator::kPath;
  params.sampling.spp = 16;
  params.sampling.aov = {Aov::kDepth};
  Renderer renderer(scene, place(scene, lenticular_sheet()), params, context);
  for (int i = 0; i < scene.timeline.frame_count; ++i) {
    const RenderedFrame frame = *renderer.frame(i);
    const std::string number = std::to_string(i);
    write_picture(folder / ("panel_" + number + ".png"), to_codes(frame.pictures.film, scene.encoding));
    const Image& depth = frame.pictures.aovs[Aov::kDepth];
    const float middle = *depth.pixel(depth.width / 2, depth.height / 2);
    std::printf("frame %d: %s, %llu rays, %.2f mm at the middle\n", i, frame.report.kind.c_str(),
                static_cast<unsigned long long>(frame.report.rays.total()), static_cast<double>(middle));
  }
} catch (const std::exception& error) {
  std::cerr << "own_scene: " << error.what() << "\n";
  return 1;
}
