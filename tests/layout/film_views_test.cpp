#include "lippmann/layout/film_views.hpp"

#include <gtest/gtest.h>

#include "lippmann/core/error.hpp"

namespace lippmann {
namespace {

Image numbered(int width, int height, int channels) {
  Image image(width, height, channels);
  for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = static_cast<float>(i);
  return image;
}

Optics quilt() {
  Optics optics;
  optics.panel = {6, 4, 1.0f};
  optics.model = MultiView{.columns = 3, .rows = 2, .distance_mm = 300.0f};
  return optics;
}

TEST(FilmViews, quilt_tiles_from_the_lower_left) {
  const Image film = numbered(6, 4, 3), depth = numbered(6, 4, 1);
  const LightField field = light_field_of(film, quilt(), &depth);
  EXPECT_EQ(field.grid, (ViewGrid{6, 1}));
  EXPECT_EQ(field.view_size, Vec2i(2, 2));
  ASSERT_TRUE(field.tiles.has_value());
  EXPECT_EQ(*field.tiles, (ViewGrid{3, 2}));
  const Image first = std::get<Image>(view_of(field, 0)), last = std::get<Image>(view_of(field, 5));
  EXPECT_EQ(first.pixel(0, 0)[0], film.pixel(0, 2)[0]);
  EXPECT_EQ(last.pixel(1, 1)[2], film.pixel(5, 1)[2]);
  EXPECT_EQ(depth_of(field, 5).pixel(1, 1)[0], depth.pixel(5, 1)[0]);
}

TEST(FilmViews, leftmost_eye_sees_rightmost_pixels) {
  Optics sheet;
  sheet.panel = {8, 2, 0.25f};
  sheet.model = LenticularSheet{.lens_pitch_mm = 1.0f};
  const Image film = numbered(8, 2, 3);
  const LightField field = light_field_of(film, sheet);
  EXPECT_EQ(field.grid, (ViewGrid{4, 1}));
  EXPECT_EQ(std::get<Image>(view_of(field, 0)).pixel(1, 0)[0], film.pixel(7, 0)[0]);
  EXPECT_FALSE(field.cameras.has_value());  // parallel projections have no camera
  EXPECT_FALSE(field.depth.has_value());
}

TEST(FilmViews, have_the_eyes_of_their_optics) {
  const LightField field = light_field_of(numbered(6, 4, 3), quilt());
  ASSERT_TRUE(field.cameras.has_value());
  ASSERT_EQ(field.cameras->eyes_mm.size(), 6u);
  EXPECT_LT(field.cameras->eyes_mm.front().x, 0.0);
  EXPECT_NEAR(field.cameras->eyes_mm.front().x, -field.cameras->eyes_mm.back().x, 1e-4);
}

TEST(FilmViews, rejects_wrong_sizes_and_fractional_lenses) {
  EXPECT_THROW(light_field_of(numbered(5, 4, 3), quilt()), Error);
  const Image depth = numbered(6, 3, 1);
  EXPECT_THROW(light_field_of(numbered(6, 4, 3), quilt(), &depth), Error);
  const Image colours = numbered(6, 4, 3), grey = numbered(6, 4, 1);
  EXPECT_THROW(light_field_of(colours, quilt(), &colours), Error);
  EXPECT_THROW(light_field_of(grey, quilt()), Error);
  EXPECT_THROW(picture_of_film(grey, quilt()), Error);
  Image short_of_samples = colours;
  short_of_samples.data.pop_back();
  EXPECT_THROW(light_field_of(short_of_samples, quilt()), Error);
  EXPECT_THROW(views_of_layer(short_of_samples, quilt()), Error);
  EXPECT_THROW(picture_of_layer(short_of_samples, quilt()), Error);
  Optics slanted;
  slanted.panel = {8, 2, 0.25f};
  slanted.model = LenticularSheet{.lens_pitch_mm = 1.0f, .slant = 0.2f};
  EXPECT_THROW(light_field_of(numbered(8, 2, 3), slanted), Error);
}

TEST(FilmViews, layers_have_the_views_layout) {
  const Image motion = numbered(6, 4, 2);
  const Image stack = views_of_layer(motion, quilt());
  EXPECT_EQ(stack.width, 2);
  EXPECT_EQ(stack.height, 12);
  ASSERT_EQ(stack.channels, 2);
  EXPECT_EQ(stack.pixel(0, 0)[1], motion.pixel(0, 2)[1]);
  EXPECT_EQ(stack.pixel(1, 11)[0], motion.pixel(5, 1)[0]);
  EXPECT_THROW(views_of_layer(numbered(6, 3, 2), quilt()), Error);
}

TEST(FilmViews, slanted_panel_joins_sub_pixels) {
  Optics panel;
  panel.panel = {2, 2, 0.3f};
  panel.model = SlantedPanel{};
  const Image film = numbered(6, 2, 3), depth = numbered(6, 2, 1);
  const Image picture = picture_of_film(film, panel);
  EXPECT_EQ(picture.width, 2);
  EXPECT_EQ(picture.pixel(1, 1)[0], film.pixel(3, 1)[0]);
  EXPECT_EQ(picture.pixel(1, 1)[2], film.pixel(5, 1)[2]);
  EXPECT_EQ(picture_of_layer(depth, panel).pixel(1, 1)[0], depth.pixel(4, 1)[0]);
  EXPECT_EQ(picture_of_film(numbered(6, 4, 3), quilt()).width, 6);
}

}  // namespace
}  // namespace lippmann
