// Tests the kinds of picture files that materials of OBJ and PLY files may name.
#include <gmock/gmock.h>

#include <fstream>

#include "image/tiff.hpp"
#include "lippmann/scene/load.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using namespace std::literals;
using testing::ElementsAre, testing::HasSubstr, testing::IsEmpty;

/// 2 x 2 pixels of 24 bits, the bottom row first: red is 1 to 4 from the top left.
std::string small_bmp() {
  return "BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\2\0\0\0\2\0\0\0\1\0\x18\0"s + std::string(24, '\0') +
         "\0\0\3\0\0\4\0\0\0\0\1\0\0\2\0\0"s;
}

std::string small_tga() { return "\0\0\2\0\0\0\0\0\0\0\0\0\2\0\2\0\x18\0\0\0\3\0\0\4\0\0\1\0\0\2"s; }

/// 2 x 2 pixels. LZW codes of 3 bits: 4 (clear), 0, 1, 2; of 4 bits: 3 and 5 (end).
std::string small_gif() { return "GIF89a\2\0\2\0\x81\0\0\1\0\0\2\0\0\3\0\0\4\0\0\x2c\0\0\0\0\2\0\2\0\0\2\3\x44\x34\5\0\x3b"s; }

class TextureKinds : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& bytes) const { std::ofstream(dir_ / name, std::ios::binary) << bytes; }

  Texture texture_of(const std::string& name, const std::string& scene) {
    Context context;
    context.warn = [this](std::string_view text) { warnings_.emplace_back(text); };
    const Scene loaded = load_scene((dir_ / scene).string(), {}, context);
    return loaded.textures.size() == 1 ? loaded.textures[0] : Texture{.name = "(not one texture: " + name + ")"};
  }

  Texture of_obj(const std::string& name) {
    write("a.mtl", "newmtl m\nmap_Kd " + name + "\n");
    write("a.obj", "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n");
    return texture_of(name, "a.obj");
  }

  Texture of_ply(const std::string& name) {
    write("a.ply", "ply\nformat ascii 1.0\ncomment TextureFile " + name +
                       "\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty float s\n"
                       "property float t\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                       "0 0 0 0 0\n1 0 0 1 0\n0 1 0 0 1\n3 0 1 2\n");
    return texture_of(name, "a.ply");
  }

  test::TempDir dir_;
  std::vector<std::string> warnings_;
};

TEST_F(TextureKinds, common_pictures_are_read_from_the_top_left) {
  write("a.bmp", small_bmp());
  write("a.tga", small_tga());
  write("a.gif", small_gif());
  write_tiff(dir_ / "a.tif", Image8{2, 2, {1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0}});
  write_tiff(dir_ / "b.tif", Image16{2, 2, {257, 0, 0, 514, 0, 0, 771, 0, 0, 1028, 0, 0}});
  for (const char* name : {"a.bmp", "a.tga", "a.gif", "a.tif", "b.tif"})
    for (const Texture& texture : {of_obj(name), of_ply(name)}) {
      EXPECT_EQ(texture.name, name);
      EXPECT_EQ(Vec2i(texture.width, texture.height), Vec2i(2));
      EXPECT_THAT(texture.rgba, ElementsAre(1, 0, 0, 255, 2, 0, 0, 255, 3, 0, 0, 255, 4, 0, 0, 255)) << name;
    }
  EXPECT_THAT(warnings_, IsEmpty());
}

/// A grey TIFF file of one float, little-endian: ten entries of 12 bytes from byte 8 on, and the pixel behind them.
std::string float_tiff(float value) {
  const auto number = [](std::uint32_t n, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) text += static_cast<char>(n >> 8 * i & 0xff);
    return text;
  };
  const std::uint32_t entries[][2] = {{256, 1},   {257, 1}, {258, 32}, {259, 1}, {262, 1},
                                      {273, 134}, {277, 1}, {278, 1},  {279, 4}, {339, 3}};
  std::string file = "II*\0\x08\0\0\0"s + number(std::size(entries), 2);
  for (const auto& [tag, entry] : entries) file += number(tag, 2) + number(4, 2) + number(1, 4) + number(entry, 4);
  return file + number(0, 4) + std::string(reinterpret_cast<const char*>(&value), 4);
}

TEST_F(TextureKinds, floats_are_linear_light) {
  write("a.tif", float_tiff(0.5f));
  EXPECT_THAT(of_obj("a.tif").rgba, ElementsAre(188, 188, 188, 255)) << "the sRGB code of half the light";
}

TEST_F(TextureKinds, other_kinds_are_named_with_the_accepted_ones) {
  write("a.dds", "DDS |\0\0\0");
  of_obj("a.dds");
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_THAT(warnings_[0],
              HasSubstr("'a.dds' is a DDS texture (accepted: PNG, JPEG, WebP, BMP, TIFF, GIF, TGA); the surface is "
                        "shown without it"));
}

}  // namespace
}  // namespace lippmann
