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

void write_panorama(const std::filesystem::path& path, float light) {
  Image panorama(8, 4, 3);
  std::fill(panorama.data.begin(), panorama.data.end(), light);
  write_exr(path, std::vector{film_layer(panorama)});
}

TEST(Light, paths_give_the_same_pictures_on_any_number_of_threads_and_after_a_resume) {
  const TempDir dir;
  const Files one = rendered(dir, small_paths("one") + Words{"--threads", "1"}, "one");
  ASSERT_EQ(one.size(), 2u);
  EXPECT_NE(one.at("frame_0000.png"), one.at("frame_0001.png"));
  EXPECT_EQ(one, rendered(dir, small_paths("three") + Words{"--threads", "3"}, "three"));
  std::filesystem::remove(dir / "one/frame_0001.png");
  EXPECT_EQ(one, rendered(dir, {"render", "one/job.toml", "--resume"}, "one"));
}

/// As small_paths, with enough samples for soft light to be shared, which in so small a picture just pays at full depth.
Words small_shared(const std::string& folder, const std::string& frames) {
  return {"render", "teapot", "--full-depth", "--lenses", "16",       "--integrator", "path",
          "--spp",  "32",     "--frames",     frames,     "--output", folder};
}

// Frames 14 to 17 belong to two histories.
TEST(Light, shared_light_gives_the_same_pictures_whole_in_parts_and_after_a_resume) {
  const TempDir dir;
  const Files whole = rendered(dir, small_shared("whole", "14-17"), "whole");
  ASSERT_EQ(whole.size(), 4u);
  for (const char* frame : {"15", "17"}) {
    const Files part = rendered(dir, small_shared(frame, frame) + Words{"--threads", "3"}, frame);
    for (const auto& [name, bytes] : part) EXPECT_EQ(bytes, whole.at(name)) << name;
  }
  std::filesystem::remove(dir / "whole/frame_0016.png");
  EXPECT_EQ(whole, rendered(dir, {"render", "whole/job.toml", "--resume"}, "whole"));
}

TEST(Light, shared_light_makes_the_same_picture_with_layers_and_the_layers_of_traced_frames) {
  const TempDir dir;
  const Words layers{"--aov", "depth,motion"};
  const Files alone = rendered(dir, small_shared("alone", "1"), "alone"),
              layered = rendered(dir, small_shared("layered", "1") + layers, "layered"),
              traced = rendered(dir, small_shared("traced", "1") + layers + Words{"--reuse", "none"}, "traced");
  EXPECT_EQ(layered.at("frame_0001.png"), alone.at("frame_0001.png"));
  EXPECT_NE(layered.at("frame_0001.png"), traced.at("frame_0001.png"));
  const std::vector<std::string> channels{"Z", "motion.X", "motion.Y"};
  EXPECT_EQ(read_channels(dir / "layered/aov_0001.exr", channels).data,
            read_channels(dir / "traced/aov_0001.exr", channels).data);
}

TEST(Light, shared_light_before_nothing_gives_the_same_pictures_whole_and_in_parts) {
  const TempDir dir;
  const Files whole = rendered(dir, small_shared("whole", "0-2") + Words{"--transparent"}, "whole");
  const Files part = rendered(dir, small_shared("part", "2") + Words{"--transparent"}, "part");
  EXPECT_EQ(part.at("frame_0002.png"), whole.at("frame_0002.png"));
  EXPECT_EQ(channel_names(dir / "part/frame_0002.png"), (std::vector<std::string>{"R", "G", "B", "A"}));
}

TEST(Light, frames_that_are_traced_although_light_could_be_shared_say_so) {
  const TempDir dir;
  EXPECT_THAT(run_tool(dir, small_shared("parts", "0") + Words{"--aov", "direct"}).err, HasSubstr("no light is shared"));
  for (const Words& flags :
       {Words{"--aov", "depth"}, Words{"--transparent"}, Words{"--denoise"}, Words{"--reuse", "none", "--aov", "direct"}})
    EXPECT_EQ(run_tool(dir, small_shared(flags.front(), "0") + flags).err.find("no light is shared"), std::string::npos);
}

// Frames without noise are made of shared light too, whole and in parts, and of neighbours in the same history alone: frame 15
// ends one, whether or not frame 16 follows.
TEST(Light, shared_light_goes_together_with_denoising) {
  const TempDir dir;
  const Words denoised{"--denoise", "--transparent"};
  const nlohmann::json frames = report_of(dir, small_shared("reported", "0-1") + denoised).at("frames");
  for (const auto& frame : frames) EXPECT_EQ(frame.at("kind"), "shared");
  const Files whole = rendered(dir, small_shared("whole", "15-16") + denoised, "whole"),
              part = rendered(dir, small_shared("part", "15") + denoised + Words{"--threads", "3"}, "part"),
              next = rendered(dir, small_shared("next", "16") + denoised, "next"),
              noisy = rendered(dir, small_shared("noisy", "16") + Words{"--transparent"}, "noisy");
  EXPECT_EQ(part.at("frame_0015.png"), whole.at("frame_0015.png"));
  EXPECT_EQ(next.at("frame_0016.png"), whole.at("frame_0016.png"));
  EXPECT_NE(noisy.at("frame_0016.png"), next.at("frame_0016.png"));
}

// The room: with four seeds 27 to 53 % of the rays of paths. So small a picture of the teapot is edges above all, and takes 41
// to 150 %, by luck.
TEST(Light, shared_light_saves_rays_and_tells_its_error) {
  const TempDir dir;
  const auto second_frame = [&](const std::string& reuse) {
    Words words = small_shared(reuse, "0-1") + Words{"--reuse", reuse};
    words[1] = "room";
    return report_of(dir, words).at("frames").at(1);
  };
  const nlohmann::json shared = second_frame("exact"), paths = second_frame("none");
  const auto rays = [](const nlohmann::json& frame) {
    std::int64_t sum = 0;
    for (const auto& [kind, count] : frame.at("rays").items()) sum += count.get<std::int64_t>();
    return sum;
  };
  EXPECT_LT(rays(shared), 2 * rays(paths) / 3);
  EXPECT_GT(shared.at("estimated_psnr_db").get<double>(), 25.0);
  EXPECT_TRUE(paths.at("estimated_psnr_db").is_null());
}

/// What is told of a frame of this kind; every frame is one.
void expect_errors(const nlohmann::json& frame, const std::string& kind) {
  EXPECT_EQ(frame.at("kind"), kind);
  EXPECT_LT(frame.at("psnr_at_least_db"), frame.at("estimated_psnr_db"));
  // Noise of pixels averages out in means over 64.
  EXPECT_GT(frame.at("estimated_block_psnr_db"), frame.at("estimated_psnr_db"));
}

TEST(Light, every_frame_of_shared_light_tells_its_errors_and_others_tell_none) {
  const TempDir dir;
  for (const Words& goal : {Words{}, Words{"--min-psnr", "30"}, Words{"--time-budget", "0.01"}}) {
    const nlohmann::json shared = report_of(dir, small_shared(goal.empty() ? "spp" : goal.front(), "0-2") + goal).at("frames");
    EXPECT_EQ(shared.size(), 3u);
    for (const nlohmann::json& frame : shared) expect_errors(frame, "shared");
  }
  const nlohmann::json traced = report_of(dir, small_shared("traced", "0-1") + Words{"--reuse", "none"}).at("frames");
  EXPECT_EQ(traced.size(), 2u);
  for (const nlohmann::json& frame : traced) {
    EXPECT_EQ(frame.at("kind"), "full");
    for (const char* key : {"estimated_psnr_db", "psnr_at_least_db", "estimated_block_psnr_db"})
      EXPECT_TRUE(frame.at(key).is_null()) << key;
  }
}

// 70 dB are an error of 0.08 codes, which is less than cells are known to, and than 64 times as many paths reach.
TEST(Light, frames_that_were_to_share_light_and_are_traced_whole_are_measured_too) {
  const TempDir dir;
  const Words traced{"render", "teapot",   "--lenses", "4",          "--integrator", "path",     "--spp",
                     "8",      "--frames", "0-1",      "--min-psnr", "70",           "--output", "out"};
  const nlohmann::json frames = report_of(dir, traced).at("frames");
  EXPECT_EQ(frames.size(), 2u);
  for (const nlohmann::json& frame : frames) {
    expect_errors(frame, "full");
    EXPECT_LT(frame.at("estimated_psnr_db"), 70.0);
  }
  const std::string summary = run_tool(dir, traced).out;
  EXPECT_THAT(summary, HasSubstr("every frame was traced whole, PSNR "));
  EXPECT_THAT(
      summary,
      HasSubstr("  warning   frames 0, 1 may fall short of --min-psnr 70 (at 95 % confidence); 2 of them are below it"));
}

TEST(Light, a_resume_keeps_the_errors_of_frames_that_share_light) {
  const TempDir dir;
  const nlohmann::json whole = report_of(dir, small_shared("out", "0-2")).at("frames");
  std::filesystem::remove(dir / "out/frame_0001.png");
  const nlohmann::json resumed = report_of(dir, {"render", "out/job.toml", "--resume"}).at("frames");
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

TEST(Light, the_summary_warns_of_frames_that_may_fall_short_of_a_floor) {
  const TempDir dir;
  const auto summary = [&](const std::string& db) {
    return run_tool(dir, small_shared("out", "0-5") + Words{"--min-psnr", db}).out;
  };
  const nlohmann::json frames = report_of(dir, small_shared("told", "0-5") + Words{"--min-psnr", "40"}).at("frames");
  std::string below;
  for (const nlohmann::json& frame : frames)
    if (below.empty() && frame.at("psnr_at_least_db") < 40.0) below = frame.at("frame").dump();
  ASSERT_NE(below, "");
  EXPECT_THAT(summary("40"), testing::ContainsRegex("  warning   frames? " + below + "[ ,].*may fall short of --min-psnr 40 "));
  EXPECT_THAT(summary("30"), testing::Not(HasSubstr("may fall short")));
}

TEST(Light, a_budget_of_time_makes_frames_that_tell_their_error) {
  const TempDir dir;
  const nlohmann::json report = report_of(dir, small_shared("out", "0-1") + Words{"--time-budget", "0.01"});
  EXPECT_GT(report.at("frames").at(1).at("estimated_psnr_db").get<double>(), 20.0);
  expect_refusal(run_tool(dir, small_shared("out", "0") + Words{"--time-budget", "1", "--reuse", "none"}), 2, "--time-budget");
  expect_refusal(run_tool(dir, small_shared("out", "0") + Words{"--time-budget", "1", "--min-psnr", "40"}), 2,
                 "one of the two");
}

TEST(Light, a_floor_takes_more_rays_the_higher_it_is) {
  const TempDir dir;
  const auto primary = [&](const std::string& db) {
    return report_of(dir, small_shared(db, "1") + Words{"--min-psnr", db})
        .at("frames")
        .at(0)
        .at("rays")
        .at("primary")
        .get<int>();
  };
  EXPECT_LT(primary("30"), primary("40"));
}

TEST(Light, provenance_is_refused_where_no_light_is_reused) {
  const TempDir dir;
  expect_refusal(run_tool(dir, small_paths("out") + Words{"--debug", "provenance"}), 2,
                 "--debug: provenance shows where shared light");
  expect_refusal(run_tool(dir, small_teapot("0", "out") + Words{"--debug", "provenance"}), 2, "--debug: provenance");
  EXPECT_EQ(run_tool(dir, small_shared("out", "0") + Words{"--debug", "provenance"}).exit_code, 0);
}

TEST(Light, paths_count_their_rays) {
  const TempDir dir;
  const nlohmann::json rays = report_of(dir, small_paths("out")).at("frames").at(0).at("rays");
  EXPECT_EQ(rays.at("primary"), 2 * 64 * 64);
  EXPECT_GT(rays.at("indirect"), 0);
  EXPECT_GT(rays.at("shadow"), 0);
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

TEST(Light, layers_of_light_are_refused_without_paths) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0", "out") + Words{"--aov", "direct"});
  expect_refusal(result, 2, "--aov: direct and indirect are parts of the light that paths find");
}

TEST(Light, a_panorama_lights_by_its_strength) {
  const TempDir dir;
  write_panorama(dir / "sky.exr", 0.5f);
  const Words sky{"--environment", "sky.exr", "--format", "exr", "--exr-pixels", "float"};
  const auto mean_of = [&](const std::string& strength) {
    EXPECT_EQ(run_tool(dir, small_paths(strength) + sky + Words{"--environment-strength", strength}).exit_code, 0);
    const Image film = read_image(dir / strength / "frame_0000.exr");
    double sum = 0.0;
    for (const float v : film.data) sum += static_cast<double>(v);
    return sum;
  };
  EXPECT_LT(mean_of("0"), mean_of("4"));
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

nlohmann::json settings_of(const TempDir& dir, const Words& command) {
  return report_of(dir, command + Words{"--lenses", "4", "--frames", "0"}).at("settings");
}

TEST(Light, files_of_physical_materials_are_path_traced_where_nothing_is_said) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  const nlohmann::json paths = settings_of(dir, {"render", "plain.obj"});
  EXPECT_EQ(paths.at("integrator"), "path");
  EXPECT_EQ(paths.at("spp"), 16);
  EXPECT_EQ(settings_of(dir, {"render", "plain.obj", "--spp", "2"}).at("spp"), 2);
  EXPECT_EQ(settings_of(dir, {"render", "plain.obj", "--integrator", "whitted"}).at("integrator"), "whitted");
  EXPECT_EQ(settings_of(dir, {"render", "plain.obj", "--reuse", "forward"}).at("integrator"), "whitted");
  EXPECT_EQ(settings_of(dir, {"render", "teapot"}).at("integrator"), "whitted");
}

// Who asks for paths by name gets as many as such a picture deserves.
TEST(Light, paths_that_are_asked_for_are_more_than_those_of_a_first_picture) {
  const TempDir dir;
  write_triangle(dir / "plain.obj");
  EXPECT_EQ(settings_of(dir, {"render", "plain.obj", "--integrator", "path"}).at("spp"), 0);
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

TEST(Light, words_and_colours_for_the_environment_are_no_paths_in_a_job) {
  const TempDir dir;
  for (const char* value : {"studio", "none", "#204060", "0.5,0.25,1"}) {
    const std::string once = std::string("once ") + value, again = std::string("again ") + value;
    ASSERT_EQ(run_tool(dir, small_paths(once) + Words{"--environment", value}).exit_code, 0) << value;
    EXPECT_THAT(bytes_of(dir / once / "job.toml"), HasSubstr(std::string("environment = \"") + value + "\""));
    ASSERT_EQ(run_tool(dir, {"render", once + "/job.toml", "--output", again}).exit_code, 0) << value;
    EXPECT_EQ(bytes_of(dir / again / "frame_0000.png"), bytes_of(dir / once / "frame_0000.png")) << value;
  }
  expect_refusal(run_tool(dir, small_paths("out") + Words{"--environment", "#12345"}), 2,
                 "--environment: '#12345' is no colour");
}

TEST(Light, what_is_no_panorama_of_light_is_refused_with_what_would_be) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "code")).exit_code, 0);
  for (const char* file : {"code/frame_0000.png", "missing.hdr"}) {
    const RunResult result = run_tool(dir, small_paths("out") + Words{"--environment", file});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr(file));
    EXPECT_FALSE(std::filesystem::exists(dir / "out"));
  }
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
