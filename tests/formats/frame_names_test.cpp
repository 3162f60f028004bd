#include "formats/frame_names.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

TEST(FrameOfFile, matches_only_names_that_render_writes) {
  for (const char* name : {"frame_0007.png", "frame_0007.tif", "aov_0007.exr", "frame_0007_qs8x6a0.75.png",
                           "frame_0007_qs8x6a1e-05.png.json", "frame_0007/view_012.exr", "frame_0007/aov_012.exr",
                           "frame_0007/input_Cam012.png", "frame_0007/gt_disp_lowres_Cam012.pfm", "frame_0007/parameters.cfg",
                           "frame_0007/cameras.json", "frame_0007/out_00_01_-1.500000_2.000000.png", "frame_0007/000_012.ppm",
                           "frame_0007/view_012_depth.png", "images/0007.png", "depth/007_ray.npy", "frame_0007/images/012.png",
                           "frame_0007/depth/012_ray.npy", "frame_0007/sparse/0/points3D.txt"})
    EXPECT_EQ(frame_of_file(name), 7) << name;
  EXPECT_EQ(frame_of_file("frame_12345.png"), 12345);
  for (const char* name : {"frame_7.txt", "frame_.png", "frame_0007", "view_000.png", "x/frame_0007.png", "frame_0007/a.png",
                           "frame_0007.png/", ".frame_0007.png", "frame_0007 copy.png", "frame_0007/view_000/view_000.png"})
    EXPECT_EQ(frame_of_file(name), std::nullopt) << name;
}

TEST(FrameNames, sorts_by_number_pictures_and_folders_apart) {
  const test::TempDir dir;
  for (const char* name :
       {"frame_10000.png", "frame_9999.png", "frame_0001.png.json", "aov_0001.exr", ".frame_1.png", "frame_2.txt"})
    std::ofstream(dir / name) << "bytes";
  for (const char* name : {"frame_0010", "frame_0002.png"}) fs::create_directory(dir / name);
  EXPECT_THAT(frame_pictures_in(dir.path()), ElementsAre(dir.path() / "frame_9999.png", dir.path() / "frame_10000.png"));
  EXPECT_THAT(frame_folders_in(dir.path()), ElementsAre(dir.path() / "frame_0002.png", dir.path() / "frame_0010"));
}

}  // namespace
}  // namespace lippmann
