// Compares an eye's view of a rendered panel with a picture rendered from the position of the eye.
#include <gtest/gtest.h>

#include "lippmann/replay/eye_view.hpp"
#include "recorded.hpp"
#include "trace/small_scene.hpp"

namespace lippmann {
namespace {

Scene tiles() {
  test::SmallScene s;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 9; ++i) {
      Mesh tile = test::square(1.37f, 0.0f);
      for (Vec3f& p : tile.positions) p += Vec3f(4.07f * static_cast<float>(i - 4), 2.9f * static_cast<float>(j - 2), 0.0f);
      const auto color = [&](int n) { return 0.1f + 0.2f * static_cast<float>((i * n + j * 3) % 5); };
      s.add(tile, s.material(test::glowing({color(1), color(2), color(3)})));
    }
  return s.scene;
}

Image at_lens_centres(const Image& picture, int pixels) {
  Image columns(picture.width / pixels, picture.height, 3);
  for (int y = 0; y < columns.height; ++y)
    for (int x = 0; x < columns.width; ++x) std::copy_n(picture.pixel(x * pixels + pixels / 2, y), 3, columns.pixel(x, y));
  return columns;
}

TEST(EyeViewTraced, scene_in_lens_plane_equals_pinhole_render) {
  const Scene scene = tiles();
  const Optics optics = test::sheet(100.0f);
  const RenderedPanel panel{optics, test::trace(scene, optics).film};
  const ThreadPool pool(1);
  for (const double x : {-18.0, 0.0, 7.0, 21.0}) {
    EyeView view;
    view.eye_mm = {x, 0.0, 100.0}, view.size = lens_grid(optics);
    const Optics pinhole = pinhole_through_window(display_window(optics), {360, 120}, view.eye_mm);
    const Affine3f moved{Mat3f(1.0f), Vec3f(static_cast<float>(x), 0.0f, 0.0f)};
    const Image direct = at_lens_centres(test::trace(scene, pinhole, {}, 1, 0.0, moved).film, 9);
    EXPECT_GE(test::linear_psnr(eye_view(panel, view, pool), direct, 2), 50.0) << x;
  }
}

}  // namespace
}  // namespace lippmann
