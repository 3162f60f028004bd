#include "lippmann/optics/view_lens.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

// The view is 360 mm wide at 500 mm, so the focal length for a sensor of 36 mm is 36 * 500 / 360 = 50 mm. At f/2, the
// lens is 25 mm wide in the scene. A millimetre of the display is 2 mm of the scene, so the lens is 12.5 mm wide on the
// display.
TEST(ViewLens, f_number_is_converted_in_metric_scenes) {
  Optics view;
  view.panel = {720, 400, 0.5f};
  view.model = SingleView{500.0f, {0.0f, 0.0f}};
  const ViewLens lens = lens_by_aperture({0.0f, 2.0f, -7.0f}, view, 0.002f);
  EXPECT_FLOAT_EQ(lens.aperture_mm, 12.5f);
  EXPECT_EQ(lens.f_number, 0.0f);
  EXPECT_EQ(lens.focal_plane_mm, -7.0f);
}

TEST(ViewLens, an_aperture_stays_as_it_is) {
  const ViewLens lens = lens_by_aperture({3.0f, 0.0f, 0.0f}, Optics{.panel = {}, .model = MultiView{}}, 0.002f);
  EXPECT_EQ(lens.aperture_mm, 3.0f);
}

TEST(ViewLens, only_views_can_have_a_lens) {
  Optics optics;
  for (const OpticsModel& model : {OpticsModel(SingleView{}), OpticsModel(MultiView{})}) {
    optics.model = model;
    EXPECT_TRUE(can_have_view_lens(optics));
  }
  for (const OpticsModel& model :
       {OpticsModel(LenticularSheet{}), OpticsModel(MicrolensArray{}), OpticsModel(SlantedPanel{})}) {
    optics.model = model;
    EXPECT_FALSE(can_have_view_lens(optics));
  }
}

}  // namespace
}  // namespace lippmann
