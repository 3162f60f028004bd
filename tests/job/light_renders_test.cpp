#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "image/exr.hpp"
#include "image/read_image.hpp"
#include "job/renders.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Settings kPaths{{"lenses", "8"}, {"integrator", "path"}, {"spp", "2"}};

class LightRenders : public Renders {
 protected:
  double mean_of_film(const std::string& file) const {
    const Image film = read_image(dir_ / file);
    double sum = 0.0;
    for (const float value : film.data) sum += static_cast<double>(value);
    return sum / static_cast<double>(film.data.size());
  }
};

TEST_F(LightRenders, layers_of_light_sum_to_the_picture) {
  const Settings layers{
      {"aov", "direct,indirect,albedo,motion,ray-depth"}, {"format", "exr"}, {"exr-pixels", "float"}, {"denoise", "none"}};
  render(teapot("out", "0-1", kPaths + layers));
  const auto channel = [&](const std::string& name) {
    return read_channels(dir_ / "out/frame_0001.exr", std::vector{name}).data;
  };
  const std::vector<float> all = channel("R"), direct = channel("direct.R"), indirect = channel("indirect.R");
  ASSERT_FALSE(all.empty());
  for (std::size_t i = 0; i < all.size(); ++i)
    ASSERT_NEAR(direct[i] + indirect[i], all[i], 1e-3f * (0.1f + all[i])) << i;  // half floats have 11 significant bits
  for (const char* name : {"albedo.B", "motion.X", "motion.Y", "ray.Z"}) EXPECT_EQ(channel(name).size(), all.size());
}

TEST_F(LightRenders, layers_do_not_depend_on_reuse) {
  for (const std::string reuse : {"auto", "none"})
    render(teapot(reuse, "0-3", {{"reuse", reuse}, {"aov", "depth,normal,id,position"}}));
  EXPECT_EQ(files_in(dir_ / "auto", ".exr").size(), 4u);
  EXPECT_EQ(pictures_below(dir_ / "auto"), pictures_below(dir_ / "none"));
}

TEST_F(LightRenders, stronger_panorama_gives_a_brighter_film) {
  std::ofstream(dir_ / "plain.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const auto film = [&](const std::string& strength) {
    render(job(dir_ / "plain.obj", strength,
               {{"lenses", "8"},
                {"frames", "0"},
                {"integrator", "path"},
                {"spp", "4"},
                {"environment", "studio"},
                {"environment-strength", strength},
                {"denoise", "none"},
                {"format", "exr"},
                {"exr-pixels", "float"}}));
    return mean_of_film(strength + "/frame_0000.exr");
  };
  EXPECT_NEAR(film("4") / film("1"), 4.0, 1e-3) << "all light is the panorama's";
}

TEST_F(LightRenders, exposure_and_tone_skip_exr_files) {
  const Settings exr{{"format", "exr"}}, bright{{"exposure", "1"}, {"tone", "agx"}};
  EXPECT_NE(rendered(teapot("plain", "0")), rendered(teapot("bright", "0", bright)));
  render(teapot("a", "0", exr));
  render(teapot("b", "0", exr + bright));
  EXPECT_EQ(read_image(dir_ / "a/frame_0000.exr").data, read_image(dir_ / "b/frame_0000.exr").data);
}

TEST_F(LightRenders, exposure_of_a_stop_doubles_linear_light) {
  render(teapot("a", "0"));
  render(teapot("b", "0", {{"exposure", "-1"}}));
  const Image8 a = read_image8(dir_ / "a/frame_0000.png"), b = read_image8(dir_ / "b/frame_0000.png");
  for (std::size_t i = 0; i < a.rgb.size(); i += 97) {
    const double half = 0.5 * linear_from_srgb(a.rgb[i] / 255.0);
    EXPECT_NEAR(b.rgb[i], 255.0 * srgb_from_linear(half), 1.5) << i;
  }
}

TEST_F(LightRenders, transparent_pictures_have_alpha_everywhere) {
  const std::vector<Settings> kinds{{{"format", "png"}},
                                    {{"format", "png16"}},
                                    {{"format", "tiff"}},
                                    Settings{{"format", "exr"}} + kPaths,
                                    {{"layout", "views"}},
                                    {{"layout", "quilt"}},
                                    kPaths + Settings{{"denoise", "none"}}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const std::string folder = std::to_string(i);
    render(teapot(folder, "0", Settings{{"transparent", "true"}} + kinds[i]));
    Files pictures = pictures_below(dir_ / folder);
    std::erase_if(pictures, [](const auto& file) { return file.first.ends_with(".json"); });
    EXPECT_FALSE(pictures.empty());
    for (const auto& [name, bytes] : pictures)
      EXPECT_EQ(channel_names(dir_ / folder / name), (std::vector<std::string>{"R", "G", "B", "A"})) << name;
  }
}

TEST_F(LightRenders, only_exr_colours_are_premultiplied) {
  std::ofstream(dir_ / "sail.obj") << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  const Settings sail{{"lenses", "16"}, {"transparent", "true"}, {"spp", "4"}};
  render(job(dir_ / "sail.obj", "exr", sail + Settings{{"format", "exr"}, {"exr-pixels", "float"}}));
  render(job(dir_ / "sail.obj", "png", sail + Settings{{"format", "png16"}}));
  const Image light = read_image(dir_ / "exr/frame_0000.exr"), codes = read_image(dir_ / "png/frame_0000.png");
  int partly = 0;
  for (std::size_t i = 0; i < light.data.size(); i += 4) {
    const float a = light.data[i + 3];
    ASSERT_NEAR(codes.data[i + 3], a, 1e-5f);
    for (std::size_t c = 0; c < 3 && a > 0.0f; ++c) {
      const double expected = srgb_from_linear(std::min(1.0, static_cast<double>(light.data[i + c]) / static_cast<double>(a)));
      ASSERT_NEAR(codes.data[i + c], expected, 1e-4);
    }
    partly += a > 0.0f && a < 1.0f;
  }
  EXPECT_GT(partly, 0);
}

TEST_F(LightRenders, transparent_is_refused_without_effect) {
  const std::vector<std::pair<Settings, std::string>> refused{
      {{{"video", dir_ / "a.mp4"}}, "cannot be combined with --video"},
      {{{"reuse", "interpolate"}}, "interpolated frames have no alpha"},
      {{{"layout", "print"}}, "pictures for panels and prints cannot store alpha"},
      {{{"precompensate", "true"}, {"crosstalk", "0.4"}}, "cannot be combined with --precompensate"}};
  for (const auto& [settings, message] : refused)
    EXPECT_THAT(refusal(teapot("out", "0", Settings{{"transparent", "true"}} + settings)),
                HasSubstr("transparent: " + message));
}

TEST_F(LightRenders, denoised_frames_have_every_layout_and_layers) {
  const Settings paths{{"integrator", "path"}, {"spp", "2"}, {"frames", "3"}};
  const std::vector<Settings> kinds{{{"optics", "multiview"}, {"views", "3x1"}, {"size", "48x16"}, {"layout", "quilt"}},
                                    {{"optics", "multiview"}, {"views", "2x2"}, {"size", "32x36"}, {"camera-grid", "true"}},
                                    {{"optics", "microlens"}, {"lens-pixels", "3"}, {"layout", "views"}, {"lenses", "8"}},
                                    {{"optics", "single"}, {"size", "32x32"}, {"transparent", "true"}},
                                    {{"format", "exr"}, {"aov", "albedo,direct,motion"}, {"lenses", "8"}}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    render(job("room", std::to_string(i), paths + kinds[i]));
    EXPECT_FALSE(pictures_below(dir_ / std::to_string(i)).empty()) << i;
  }
}

TEST_F(LightRenders, path_traced_stills_are_denoised_by_default) {
  const auto pictures = [&](const std::string& denoise) {
    return rendered(teapot(denoise, "3", kPaths + Settings{{"denoise", denoise}}));
  };
  const Files by_default = rendered(teapot("default", "3", kPaths)), plain = pictures("none");
  EXPECT_NE(by_default, plain);
  EXPECT_EQ(pictures("auto"), by_default);
  EXPECT_EQ(pictures("true"), by_default) << "in job files of earlier versions";
  EXPECT_EQ(pictures("false"), plain);
}

TEST_F(LightRenders, one_sample_per_pixel_is_not_denoised) {
  const Settings one = kPaths + Settings{{"spp", "1"}};
  EXPECT_EQ(rendered(teapot("a", "3", one)), rendered(teapot("b", "3", one + Settings{{"denoise", "none"}})));
}

TEST_F(LightRenders, impossible_interpolation_is_refused) {
  const auto refused = [&](const Settings& settings) { return refusal(teapot("out", "0", settings)); };
  EXPECT_THAT(refused(kPaths + Settings{{"reuse", "interpolate"}}), HasSubstr("reuse: interpolate needs Whitted shading"));
  EXPECT_THAT(refused({{"splat", "lens"}}), HasSubstr("splat"));
  EXPECT_THAT(refused({{"min-psnr", "30"}, {"reuse", "none"}}), HasSubstr("min-psnr"));
  EXPECT_THAT(refused(kPaths + Settings{{"min-psnr", "30"}}), HasSubstr("for path tracing, --spp"));
}

TEST_F(LightRenders, depth_is_fitted_by_default) {
  const Files fitted = rendered(teapot("a", "0")), full = rendered(teapot("b", "0", {{"fit-depth", "false"}}));
  EXPECT_NE(fitted, full);
  EXPECT_EQ(rendered(teapot("c", "0", {{"fit-depth", "true"}})), fitted);
  RenderParams again = job_of("b");
  again.output.folder = dir_ / "d";
  EXPECT_EQ(rendered(again), full) << "fit-depth = false, as older jobs have it";
  again.output.folder = dir_ / "e", again.optics.fit_depth = true;
  EXPECT_EQ(rendered(again), fitted);
}

}  // namespace
}  // namespace lippmann::test
