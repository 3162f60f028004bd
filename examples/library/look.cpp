// Renders what a left and a right eye see of a light field, and the picture that is focused on the plane of the display.
//  look FILE|FOLDER FOLDER
#include <filesystem>
#include <iostream>
#include <lippmann/lippmann.hpp>

using namespace lippmann;

int main(int argc, char** argv) try {
  if (argc != 3) {
    std::cerr << "usage: look FILE|FOLDER FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[2];
  std::filesystem::create_directories(folder);
  const LightFieldFrames frames = find_light_field_frames(argv[1], {});
  if (!frames.assumption.empty()) std::cout << frames.assumption << "\n";
  const RenderedPanel panel = frames.read(0);
  const ThreadPool pool(resolved_threads(Context{}));
  EyeView view;
  const Vec3d middle = default_eye_mm(panel.optics);
  for (const int side : {-1, 1}) {
    view.eye_mm = middle + Vec3d(side * 0.05 * middle.z, 0.0, 0.0);
    validate(view);
    write_picture(folder / (side < 0 ? "left.png" : "right.png"), to_codes(eye_view(panel, view, pool), Encoding::kSrgb));
  }
  write_picture(folder / "focused.png", to_codes(refocus(panel, 0.0, {0, 0}, pool), Encoding::kSrgb));
} catch (const std::exception& error) {
  std::cerr << "look: " << error.what() << "\n";
  return 1;
}
