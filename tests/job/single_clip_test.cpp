#include "job/single_clip.hpp"

#include <gtest/gtest.h>

namespace lippmann {
namespace {

TEST(SingleClip, is_one_view_in_its_folder) {
  RenderParams params;
  params.scene.name = "room";
  params.optics.lenses = {64, 0};
  params.optics.slant_deg = 5.0f;
  params.output.pictures.layout = PictureLayout::kIntegral;
  params.output.video = {"clips/room.mp4"};
  const RenderParams single = single_clip(params, Optics{.panel = {512, 384, 0.125f}, .model = LenticularSheet{}});
  EXPECT_EQ(single.optics.kind, OpticsKind::kSingle);
  EXPECT_EQ(single.optics.size, (Extent<int>{512, 384}));
  EXPECT_EQ(single.optics.lenses.x, 0);
  EXPECT_EQ(single.optics.slant_deg, 0.0f);
  EXPECT_FALSE(single.output.pictures.layout.has_value());
  EXPECT_EQ(single.output.folder, "out/room/single");
  EXPECT_EQ(single.output.video, std::vector<std::string>{"clips/room_single.mp4"});
}

TEST(SingleClip, has_the_size_of_a_tile) {
  const Optics quilt{.panel = {800, 600, 0.1f}, .model = MultiView{8, 6}};
  EXPECT_EQ(single_clip({}, quilt).optics.size, (Extent<int>{100, 100}));
}

TEST(SingleClip, has_the_size_of_the_display) {
  RenderParams params;
  params.optics.display = "portrait";
  EXPECT_EQ(single_clip(params, Optics{}).optics.size.x, 0);
}

}  // namespace
}  // namespace lippmann
