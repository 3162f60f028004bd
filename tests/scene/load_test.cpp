#include "lippmann/scene/load.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <vector>

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

TEST(LoadScene, rejects_blender_formats_with_advice) {
  const test::TempDir dir;
  for (const char* name : {"a.usdz", "b.FBX", "c.blend", "d.xyz"}) std::ofstream(dir / name) << "a scene";
  EXPECT_THAT(error_of_loading((dir / "a.usdz").string()),
              HasSubstr("is a scene format that Blender reads; accepted: a .glb converted with Blender"));
  EXPECT_THAT(error_of_loading((dir / "b.FBX").string()), HasSubstr("to_glb.py"));
  EXPECT_THAT(error_of_loading((dir / "c.blend").string()),
              HasSubstr("is a Blender file; accepted: a render with the Blender add-on"));
  EXPECT_THAT(error_of_loading((dir / "d.xyz").string()), HasSubstr("is not a known scene format"));
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

TEST(LoadScene, placeholder_scenes_are_named) {
  const test::TempDir dir;
  for (const char* extension : {".dat", ".glb", ".gltf", ".nff", ".obj", ".ply"}) {
    const auto error = [&](const std::string& contents) {
      const std::filesystem::path path = dir / (std::string("a") + extension);
      std::ofstream(path, std::ios::binary) << contents;
      return error_of_loading(path.string());
    };
    const std::string name = std::string("a") + extension + ": ";
    EXPECT_THAT(error(""), HasSubstr(name + "is empty (0 bytes); accepted: "));
    EXPECT_THAT(error("version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"),
                HasSubstr(name + "is a Git LFS pointer, which stands for a file of 12345 bytes; accepted: "));
    EXPECT_THAT(error("\n<!DOCTYPE html>\n<html></html>"), HasSubstr(name + "is a web page (HTML); accepted: "));
    EXPECT_THAT(error("\x89PNG\r\n\x1a\n rest"), HasSubstr(name + "is a PNG picture; accepted: a scene in the format of "));
  }
}

TEST(LoadScene, text_of_another_kind_is_shown) {
  const test::TempDir dir;
  for (const char* name : {"a.glb", "a.ply"}) {
    std::ofstream(dir / name) << "hello there\n";
    EXPECT_THAT(error_of_loading((dir / name).string()), HasSubstr("text that begins 'hello there'"));
  }
}

TEST(LoadScene, placeholder_side_files_are_named) {
  const test::TempDir dir;
  std::ofstream(dir / "a.mtl") << "version https://git-lfs.github.com/spec/v1\nsize 5\n";
  std::ofstream(dir / "a.bin") << "<html>";
  std::ofstream(dir / "a.obj") << "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  std::ofstream(dir / "a.gltf") << R"({"asset":{"version":"2.0"},"buffers":[{"uri":"a.bin","byteLength":99}]})";
  std::ofstream(dir / "a.dat") << "BEGIN_SCENE RESOLUTION 1 1 INCLUDE a.bin END_SCENE";
  std::vector<std::string> warnings;
  Context context;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  EXPECT_NO_THROW(load_scene((dir / "a.obj").string(), {}, context));
  EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("'a.mtl' is a Git LFS pointer")));
  EXPECT_THAT(error_of_loading((dir / "a.gltf").string()), HasSubstr("buffers[0]: 'a.bin' is a web page (HTML)"));
  EXPECT_THAT(error_of_loading((dir / "a.dat").string()), HasSubstr("a.bin is a web page (HTML)"));
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
