// The scene that parameters name, as they change it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "render/params.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

class WantedScene : public testing::Test {
 protected:
  /// Parameters that name a file with these contents.
  RenderParams params_of(const std::string& name, const std::string& contents) const {
    std::ofstream(dir_ / name, std::ios::binary) << contents;
    RenderParams params;
    params.scene = (dir_ / name).string();
    return params;
  }

  test::TempDir dir_;
};

TEST_F(WantedScene, light_scale_multiplies_lamps) {
  RenderParams params = params_of("a.nff", "l 1 2 3 0.5 0.25 1\ns 0 0 0 1\n");
  params.light_scale = 4.0f;
  EXPECT_EQ(wanted_scene(params, {}).lights.at(0).color, Vec3f(2.0f, 1.0f, 4.0f));
}

}  // namespace
}  // namespace lippmann
