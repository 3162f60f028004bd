#include "lippmann/scene/load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using ::testing::HasSubstr;

std::string error_of_loading(const std::string& name, const LoadOptions& options = {}) {
  try {
    load_scene(name, options, Context{});
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(LoadScene, missing_file_is_named) {
  EXPECT_THAT(error_of_loading("/nowhere/a.dat"), HasSubstr("/nowhere/a.dat: there is no such file"));
}

TEST(LoadScene, formats_that_blender_reads_are_refused_with_the_way_here) {
  const test::TempDir dir;
  for (const char* name : {"a.usdz", "b.FBX", "c.blend", "d.xyz"}) std::ofstream(dir / name) << "a scene";
  EXPECT_THAT(error_of_loading((dir / "a.usdz").string()),
              HasSubstr("is a scene format that Blender reads; accepted: a .glb of it"));
  EXPECT_THAT(error_of_loading((dir / "b.FBX").string()), HasSubstr("to_glb.py"));
  EXPECT_THAT(error_of_loading((dir / "c.blend").string()),
              HasSubstr("is a file of Blender; accepted: a render by its add-on"));
  EXPECT_THAT(error_of_loading((dir / "d.xyz").string()), HasSubstr("is not a scene format that is known"));
}

TEST(LoadScene, misspelt_builtin_name_is_suggested) {
  EXPECT_THAT(error_of_loading("teapott"), HasSubstr("teapott: there is no such file, did you mean 'teapot'?"));
}

TEST(LoadScene, folder_is_refused) {
  const test::TempDir dir;
  EXPECT_THAT(error_of_loading(dir.path().string()), HasSubstr("is a folder"));
}

TEST(LoadScene, unknown_extension_lists_what_is_accepted) {
  const test::TempDir dir;
  std::ofstream(dir / "a.xyz") << "x";
  const std::string text = error_of_loading((dir / "a.xyz").string());
  EXPECT_THAT(text, HasSubstr("a.xyz"));
  EXPECT_THAT(text, HasSubstr(".dat"));
}

TEST(LoadScene, scene_without_surfaces_is_an_error) {
  const test::TempDir dir;
  std::ofstream(dir / "points.obj") << "v 0 0 0\nv 1 0 0\np 1 2\nl 1 2\n";
  std::ofstream(dir / "empty.gltf") << R"({"asset":{"version":"2.0"},"scenes":[{}],"nodes":[{}]})";
  for (const char* name : {"points.obj", "empty.gltf"})
    EXPECT_THAT(error_of_loading((dir / name).string()),
                HasSubstr(std::string(name) + ": has no surfaces to show; accepted: "));
}

TEST(LoadScene, asset_root_must_be_a_folder) {
  const test::TempDir dir;
  std::ofstream(dir / "a.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  LoadOptions options;
  options.asset_root = dir / "none";
  EXPECT_THAT(error_of_loading((dir / "a.obj").string(), options), HasSubstr("asset-root: "));
}

}  // namespace
}  // namespace lippmann
