// Renders a quilt of any scene for a display, with path tracing and denoising.
//   quilt SCENE DISPLAY OUT.png      quilt vase.glb looking-glass-portrait vase.png
#include <iostream>
#include <lippmann/lippmann.hpp>
using namespace lippmann;
int main(int argc, char** argv) try {
  if (argc != 4) {
    std::cerr << "usage: quilt SCENE DISPLAY OUT.png\n";
    return 2;
  }
  const Context context;
  const Display display = load_display(argv[2]);
  Scene scene = load_scene(argv[1], {}, context);
  add_missing_light(scene, Integrator::kPath);
  const Placement placement = place(scene, display, DisplayPicture::kQuilt);
  Renderer renderer(scene, placement, {.sampling = {.integrator = Integrator::kPath}}, context);
  const Image8 quilt = to_codes(renderer.frame(0)->pictures.film, scene.encoding);
  write_picture(with_quilt_name(argv[3], quilt_name_of(*display.quilt)), quilt);
} catch (const std::exception& error) {
  std::cerr << "quilt: " << error.what() << "\n";
  return 1;
}
