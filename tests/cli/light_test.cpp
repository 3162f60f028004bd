// Path tracing, panoramas, exposure and tone from the command line.
#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>

#include "cli/tool.hpp"
#include "image/exr.hpp"
#include "image/read_image.hpp"
#include "lippmann/image/encode.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;

Words small_paths(const std::string& folder) {
  return {"render", "teapot", "--lenses", "8", "--integrator", "path", "--spp", "2", "--frames", "0-1", "--output", folder};
}

/// As small_paths, with enough samples for soft light to be shared, which in so small a picture just pays at full depth.
Words small_shared(const std::string& folder, const std::string& frames) {
  return {"render", "teapot", "--full-depth", "--lenses", "16",       "--integrator", "path",
          "--spp",  "32",     "--frames",     frames,     "--output", folder};
}

TEST(Light, frames_that_are_traced_although_light_could_be_shared_say_so) {
  const TempDir dir;
  const Words few_lenses{"render", "teapot",   "--lenses", "4",  "--integrator", "path",  "--spp",
                         "8",      "--frames", "0",        "-o", "out",          "--aov", "direct"};
  EXPECT_THAT(run_tool(dir, few_lenses).err, HasSubstr("no light is shared"));
}

// 70 dB are an error of 0.08 codes, which is less than cells are known to, and than 64 times as many paths reach.
TEST(Light, the_summary_warns_of_frames_that_may_fall_short_of_a_floor) {
  const TempDir dir;
  const Words traced{"render", "teapot",   "--lenses", "4",          "--integrator", "path",     "--spp",
                     "8",      "--frames", "0-1",      "--min-psnr", "70",           "--output", "out"};
  const std::string summary = run_tool(dir, traced).out;
  EXPECT_THAT(summary, HasSubstr("every frame was traced whole, PSNR "));
  EXPECT_THAT(
      summary,
      HasSubstr("  warning   frames 0, 1 may fall short of --min-psnr 70 (at 95 % confidence); 2 of them are below it"));
}

TEST(Light, a_resume_keeps_the_pictures_and_errors_of_frames_that_share_light) {
  const TempDir dir;
  const nlohmann::json whole = report_of(dir, small_shared("out", "0-2")).at("frames");
  const Files pictures = files_in(dir / "out", ".png");
  std::filesystem::remove(dir / "out/frame_0001.png");
  const nlohmann::json resumed = report_of(dir, {"render", "out/job.toml", "--resume"}).at("frames");
  EXPECT_EQ(files_in(dir / "out", ".png"), pictures);
  ASSERT_EQ(resumed.size(), whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const char* key : {"kind", "estimated_psnr_db", "psnr_at_least_db", "estimated_block_psnr_db"})
      EXPECT_EQ(resumed.at(i).at(key), whole.at(i).at(key)) << "frame " << i << ' ' << key;
  nlohmann::json kept = resumed.at(0);
  EXPECT_EQ(kept.at("kept"), true);
  kept["kept"] = false;
  EXPECT_EQ(kept, whole.at(0));
}

TEST(Light, the_summary_says_how_many_frames_share_light) {
  const TempDir dir;
  const RunResult shared = run_tool(dir, small_shared("shared", "0-1"));
  EXPECT_THAT(shared.out, HasSubstr("of 2 frames share light, PSNR "));
  EXPECT_THAT(shared.out, HasSubstr("dB on average, "));
  EXPECT_THAT(shared.out, HasSubstr("dB at worst of means over 64 pixels (frame "));
  EXPECT_THAT(shared.out, testing::Not(HasSubstr("key frames")));
  EXPECT_THAT(run_tool(dir, small_paths("traced")).out, HasSubstr("every frame was traced whole"));
}

TEST(Light, forward_reuse_of_paths_is_refused) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_paths("out") + Words{"--reuse", "forward"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("--reuse: interpolate does not know path-traced frames"));
  EXPECT_THAT(result.err, HasSubstr("or --integrator whitted"));
}

TEST(Light, layers_of_light_are_written_beside_others_and_sum_to_the_picture) {
  const TempDir dir;
  const Words layers{"--aov", "direct,indirect,albedo,motion,ray-depth", "--format", "exr", "--exr-pixels", "float"};
  ASSERT_EQ(run_tool(dir, small_paths("out") + layers).exit_code, 0);
  const std::filesystem::path file = dir / "out/frame_0001.exr";
  const auto channel = [&](const std::string& name) { return read_channels(file, std::vector{name}).data; };
  const std::vector<float> all = channel("R"), direct = channel("direct.R"), indirect = channel("indirect.R");
  for (std::size_t i = 0; i < all.size(); ++i)
    ASSERT_NEAR(direct[i] + indirect[i], all[i], 1e-3f * (0.1f + all[i])) << i;  // half floats have 11 bits
  for (const char* name : {"albedo.B", "motion.X", "motion.Y", "ray.Z"}) EXPECT_EQ(channel(name).size(), all.size());
}

/// A triangle: little work for any integrator.
void write_triangle(const std::filesystem::path& path) { std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"; }

TEST(Light, summary_report_and_info_say_which_light_was_taken) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const std::string expected = "The built-in studio lights the scene, because the file has no lamps and no surroundings.";
  const Words command{"render", "plain.obj", "--lenses", "4", "--integrator", "path", "--spp", "2", "--output", "out"};
  const RunResult result = run_tool(dir, command);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("light     " + expected));
  EXPECT_EQ(json_of(bytes_of(dir / "out/report.json"))["light"], expected);
  EXPECT_EQ(json_of(run_tool(dir, {"info", "plain.obj", "--integrator", "path", "--json"}).out)["light"], expected);
  EXPECT_THAT(run_tool(dir, {"info", "plain.obj", "--integrator", "path", "--environment", "none"}).out,
              HasSubstr("The scene has its own light alone, as --environment none asks for."));
}

TEST(Light, the_summary_says_how_many_samples_were_taken_and_what_makes_less_noise) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const auto summary = [&](const Words& flags) {
    return run_tool(dir, Words{"render", "plain.obj", "--lenses", "4", "--frames", "0"} + flags).out;
  };
  EXPECT_THAT(summary({}), HasSubstr("path traced with 16 samples a pixel; --spp 64 for less noise\n"));
  EXPECT_THAT(summary({"--spp", "64"}), HasSubstr("path traced with 64 samples a pixel\n"));
  EXPECT_THAT(summary({"--integrator", "whitted"}), testing::Not(HasSubstr("path traced")));
}

TEST(Light, a_resume_of_a_path_traced_file_is_the_same_job) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const Words command{"render", "plain.obj", "--lenses", "4", "--frames", "0", "--output", "out"};
  const Files whole = rendered(dir, command, "out");
  EXPECT_EQ(rendered(dir, {"render", "out/job.toml", "--resume"}, "out"), whole);
  EXPECT_THAT(run_tool(dir, command + Words{"--resume"}).out, HasSubstr("kept"));
}

TEST(Light, exposure_and_tone_change_pictures_but_not_exr_files) {
  const TempDir dir;
  const Words plain = small_teapot("0", "plain"), exr{"--format", "exr"}, bright{"--exposure", "1", "--tone", "agx"};
  EXPECT_NE(rendered(dir, plain, "plain"), rendered(dir, small_teapot("0", "bright") + bright, "bright"));
  ASSERT_EQ(run_tool(dir, small_teapot("0", "a") + exr).exit_code, 0);
  ASSERT_EQ(run_tool(dir, small_teapot("0", "b") + exr + bright).exit_code, 0);
  EXPECT_EQ(read_image(dir / "a/frame_0000.exr").data, read_image(dir / "b/frame_0000.exr").data);
}

TEST(Light, exposure_of_a_stop_doubles_linear_light) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "a")).exit_code, 0);
  ASSERT_EQ(run_tool(dir, small_teapot("0", "b") + Words{"--exposure", "-1"}).exit_code, 0);
  const Image8 a = read_image8(dir / "a/frame_0000.png"), b = read_image8(dir / "b/frame_0000.png");
  for (std::size_t i = 0; i < a.rgb.size(); i += 97) {
    const double half = 0.5 * linear_from_srgb(a.rgb[i] / 255.0);
    EXPECT_NEAR(b.rgb[i], 255.0 * srgb_from_linear(half), 1.5) << i;  // the codes are rounded twice
  }
}

TEST(Light, transparent_pictures_have_alpha_in_every_format_and_layout) {
  const TempDir dir;
  for (const Words& format : {Words{"--format", "png"}, Words{"--format", "png16"}, Words{"--format", "tiff"},
                              Words{"--format", "exr", "--integrator", "path", "--spp", "2"}, Words{"--layout", "views"},
                              Words{"--layout", "quilt"}}) {
    const RunResult result = run_tool(dir, small_teapot("0", "out") + Words{"--transparent"} + format);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    int pictures = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(dir / "out")) {
      const std::string name = entry.path().extension().string();
      if (name != ".png" && name != ".tif" && name != ".exr") continue;
      EXPECT_EQ(channel_names(entry.path()), (std::vector<std::string>{"R", "G", "B", "A"})) << entry.path();
      ++pictures;
    }
    EXPECT_GT(pictures, 0);
    std::filesystem::remove_all(dir / "out");
  }
}

TEST(Light, transparent_colours_are_multiplied_by_alpha_in_exr_files_and_not_in_others) {
  const TempDir dir;
  std::ofstream(dir / "sail.obj") << "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
  const Words sail{"render", "sail.obj", "--lenses", "16", "--transparent", "--spp", "4"};
  ASSERT_EQ(run_tool(dir, sail + Words{"--format", "exr", "--exr-pixels", "float", "-o", "exr"}).exit_code, 0);
  ASSERT_EQ(run_tool(dir, sail + Words{"--format", "png16", "-o", "png"}).exit_code, 0);
  const Image light = read_image(dir / "exr/frame_0000.exr"), codes = read_image(dir / "png/frame_0000.png");
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

TEST(Light, transparent_is_refused_where_alpha_cannot_be_or_means_nothing) {
  const TempDir dir;
  const std::vector<std::pair<Words, std::string>> refused{{{"--video", "a.mp4"}, "none of the codecs"},
                                                           {{"--reuse", "forward"}, "interpolated frames have no alpha"},
                                                           {{"--layout", "print"}, "what a panel or paper"},
                                                           {{"--precompensate", "--crosstalk", "0.4"}, "crosstalk mixes"}};
  for (const auto& [flags, word] : refused)
    expect_refusal(run_tool(dir, small_teapot("0", "out") + Words{"--transparent"} + flags), 2, "--transparent: " + word);
}

}  // namespace
}  // namespace lippmann::test
