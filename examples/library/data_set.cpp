// Renders a light field for research: a built-in scene, seen by 3 x 3 parallel cameras. Writes pictures, depth and disparity in
// the format of the HCI benchmark.
//  data_set FOLDER
#include <iostream>
#include <lippmann/lippmann.hpp>

using namespace lippmann;

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::cerr << "usage: data_set FOLDER\n";
    return 2;
  }
  const Context context;
  const Scene scene = load_scene("primitives", {}, context);
  Optics cameras;
  cameras.panel = {.width = 3 * 96, .height = 3 * 96, .pixel_pitch_mm = 1.0f};
  cameras.model = MultiView{.columns = 3, .rows = 3, .distance_mm = 300.0f, .baseline_mm = 5.0f};
  const Placement placement = place(scene, cameras, {.fit_depth = false});
  FrameParams params;
  params.sampling.spp = 4;
  params.sampling.aov = {Aov::kDepth};
  Renderer renderer(scene, placement, params, context);
  const RenderedFrame frame = *renderer.frame(0);
  LightField field = light_field_of(frame.pictures.film, renderer.optics(), &frame.pictures.aovs[Aov::kDepth]);
  field.stack = to_codes(std::get<Image>(field.stack), scene.encoding);
  for (const auto& file : find_format("hci", "format").write(field, argv[1], {})) std::cout << file.string() << "\n";
} catch (const std::exception& error) {
  std::cerr << "data_set: " << error.what() << "\n";
  return 1;
}
