// The scenes of Debian's package tachyon-doc must load, or stop at the expected unsupported keyword.
#include <cctype>
#include <cstring>

#include "tachyon_support.hpp"

namespace lippmann {
namespace {

const std::filesystem::path kScenes = "/usr/share/doc/tachyon/examples/scenes";

struct Example {
  const char* name;
  const char* stops_at;  ///< "line: keyword" at the beginning of the error; empty: no error
};
void PrintTo(const Example& example, std::ostream* out) { *out << example.name; }

class TachyonExample : public testing::TestWithParam<Example> {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(kScenes / "teapot.dat")) GTEST_SKIP() << "the package tachyon-doc is not installed";
  }
};

TEST_P(TachyonExample, loads_or_names_what_it_stops_at) {
  const std::filesystem::path path = kScenes / (std::string(GetParam().name) + ".dat");
  const std::string stops_at = GetParam().stops_at;
  try {
    const Scene scene = load_scene(path.string(), {}, Context{});
    EXPECT_EQ(stops_at, "");
    EXPECT_EQ(scene.cameras.size(), 1u);
  } catch (const Error& error) {
    ASSERT_NE(stops_at, "") << error.what();
    EXPECT_THAT(error.what(), testing::StartsWith(path.string() + ":" + stops_at));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, TachyonExample,
    testing::Values(Example{"2balls", ""}, Example{"820spheres", ""}, Example{"attenuation", ""}, Example{"balls", ""},
                    Example{"clipplanes", "29: START_CLIPGROUP is not supported"}, Example{"dna", ""}, Example{"dnadof", ""},
                    Example{"engine", "19: SCALARVOL is not supported"},
                    Example{"fisheye", "5: the projection 'FISHEYE' is not supported"}, Example{"fog", ""},
                    Example{"gridtest", ""}, Example{"imagedef", "31: IMAGEDEF '::testpic' is a volume"}, Example{"island", ""},
                    Example{"janbadoutput", ""}, Example{"lame", ""}, Example{"lattice", ""}, Example{"lavablobs", ""},
                    Example{"lscapes", "31: TEXFUNC 3 is not supported"}, Example{"model2", "52: TEXFUNC 3 is not supported"},
                    Example{"model3", "42: TEXFUNC 3 is not supported"}, Example{"model4", "31: TEXFUNC 3 is not supported"},
                    Example{"model6", "31: TEXFUNC 3 is not supported"}, Example{"msti", ""}, Example{"null", ""},
                    Example{"null2", ""}, Example{"polycyl", ""}, Example{"room", ""},
                    Example{"sc98", "36: TEXFUNC 4 is not supported"}, Example{"sc98ao", "43: TEXFUNC 4 is not supported"},
                    Example{"skull", "19: SCALARVOL is not supported"}, Example{"smallballs", ""}, Example{"space", ""},
                    Example{"spotlight", ""}, Example{"teapot", ""}, Example{"tetra", ""}, Example{"texfree", ""},
                    Example{"texture", "39: expected ROTATE, found 'NORMAL'"}, Example{"tpolytest", ""},
                    Example{"transtest", ""}, Example{"trypsin4pti", ""}, Example{"umr", ""}, Example{"umrfrustum", ""},
                    Example{"voltest", "19: SCALARVOL is not supported"}),
    [](const auto& example) {
      const std::string name = example.param.name;
      return std::isdigit(static_cast<unsigned char>(name[0])) ? "n" + name : name;
    });

struct PathExample {
  const char* scene;
  const char* path;
  int frames;
};
void PrintTo(const PathExample& example, std::ostream* out) { *out << example.path; }

class TachyonPathExample : public testing::TestWithParam<PathExample> {};

TEST_P(TachyonPathExample, has_one_frame_more_than_lines) {
  if (!std::filesystem::exists(kScenes / "teapot.cam")) GTEST_SKIP() << "the package tachyon-doc is not installed";
  LoadOptions options;
  options.camera_path = kScenes / GetParam().path;
  const Scene scene = load_scene((kScenes / GetParam().scene).string(), options, Context{});
  EXPECT_EQ(scene.timeline.frame_count, GetParam().frames);
}

INSTANTIATE_TEST_SUITE_P(All, TachyonPathExample,
                         testing::Values(PathExample{"teapot.dat", "teapot.cam", 655},
                                         PathExample{"smallballs.dat", "smallballs.cam", 264},
                                         PathExample{"room.dat", "room.cam", 680}),
                         [](const auto& example) {
                           return std::string(example.param.scene, std::strcspn(example.param.scene, "."));
                         });

}  // namespace
}  // namespace lippmann
