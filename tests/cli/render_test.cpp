#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "cli/tool.hpp"
#include "lippmann/core/version.hpp"

namespace lippmann::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

TEST(Render, makes_pictures_job_and_report_and_says_where) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("0-2", "out"));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(files_in(dir / "out", ".png").size(), 3u);
  EXPECT_TRUE(std::filesystem::exists(dir / "out/frame_0002.png"));
  EXPECT_TRUE(std::filesystem::exists(dir / "out/job.toml"));
  EXPECT_TRUE(std::filesystem::exists(dir / "out/report.json"));
  EXPECT_THAT(result.out, HasSubstr("out/frame_0000.png"));
}

TEST(Render, frames_of_a_list_are_those_that_are_made_and_resumed) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0-4", "all")).exit_code, 0);
  ASSERT_EQ(run_tool(dir, small_teapot("4,0-2:2", "some")).exit_code, 0);
  const Files all = files_in(dir / "all", ".png"), some = files_in(dir / "some", ".png");
  ASSERT_EQ(some.size(), 3u);
  for (const auto& [name, bytes] : some) EXPECT_TRUE(all.at(name) == bytes) << name;
  EXPECT_THAT(run_tool(dir, small_teapot("0-4:2", "some") + Words{"--resume"}).out, HasSubstr("3 kept from before"));
}

TEST(Render, without_output_writes_to_out_slash_scene) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, {"render", "teapot", "--lenses", "4", "--frames", "7"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(dir / "out/teapot/frame_0007.png"));
}

TEST(Render, stderr_that_is_a_terminal_gets_a_bar_with_the_time_left) {
  const TempDir dir;
  std::string command;
  for (const std::string& word : tool_command(small_teapot("0-3", "out"))) command += "'" + word + "' ";
  const RunResult result = run({"script", "--quiet", "--return", "--command", command, "/dev/null"}, {dir.path().string(), 0});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\r[################################] 4/4"));
  EXPECT_THAT(result.out, HasSubstr("0:00 left"));
  EXPECT_THAT(result.out, Not(HasSubstr("frame 3: ")));
}

TEST(Render, json_is_the_report_and_nothing_else) {
  const TempDir dir;
  const RunResult result = run_tool(dir, small_teapot("3-4", "out") + Words{"--reuse", "none", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const Json report = json_of(result.out);
  EXPECT_EQ(report, json_of(bytes_of(dir / "out/report.json")));
  for (const char* key : {"version", "scene", "optics", "settings", "frames", "totals"})
    EXPECT_TRUE(report.contains(key)) << key;
  ASSERT_EQ(report["frames"].size(), 2u);
  const Json& frame = report["frames"][1];
  EXPECT_EQ(frame["frame"], 4);
  EXPECT_EQ(frame["kind"], "full");
  EXPECT_EQ(frame["rays"]["primary"], 128 * 128);
  for (const char* key : {"seconds", "cpu_seconds", "missed_pixels", "retraced_pixels", "reused_pixels", "estimated_psnr_db"})
    EXPECT_TRUE(frame.contains(key)) << key;
  const Json& totals = report["totals"];
  EXPECT_EQ(totals["frames"], 2);
  EXPECT_EQ(totals["rays"]["primary"], 2 * 128 * 128);
  EXPECT_GT(totals["peak_memory_bytes"].get<double>(), 1e6);
  for (const char* key : {"seconds", "cpu_seconds", "write_seconds", "setup_seconds", "threads"})
    EXPECT_TRUE(totals[key].is_number()) << key;
}

TEST(Render, job_file_of_a_render_makes_the_same_pictures_again) {
  const TempDir dir;
  const Words unusual{"--optics", "microlens", "--lens-pixels", "6", "--view-angle", "35", "--spp", "2", "--seed", "9"};
  ASSERT_EQ(run_tool(dir, small_teapot("4-5", "a") + unusual).exit_code, 0);
  ASSERT_EQ(run_tool(dir, {"render", "a/job.toml", "--output", "b"}).exit_code, 0);
  EXPECT_EQ(files_in(dir / "b", ".png"), files_in(dir / "a", ".png"));
  EXPECT_EQ(files_in(dir / "b", ".png").size(), 2u);
}

TEST(Render, flags_go_over_the_job_and_dump_job_writes_both) {
  const TempDir dir;
  std::ofstream(dir / "in.toml") << "scene = 'teapot'\nlenses = 4\nframes = '0-1'\n";
  ASSERT_EQ(run_tool(dir, {"render", "--job", "in.toml", "--frames", "1", "--output", "a", "--dump-job", "out.toml"}).exit_code,
            0);
  EXPECT_EQ(files_in(dir / "a", ".png").size(), 1u);
  EXPECT_THAT(bytes_of(dir / "out.toml"), HasSubstr("frames = \"1\""));
  EXPECT_THAT(bytes_of(dir / "out.toml"), HasSubstr("lenses = \"4\""));
}

TEST(Render, video_is_written_beside_the_pictures_with_every_frame) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0-3", "a") + Words{"--video", "a.mkv", "--video", "a.mp4"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(dir / "a.mp4"));
  const RunResult compared = run_tool(dir, {"compare", "a", "a.mkv", "--json"});
  EXPECT_TRUE(json_of(compared.out)["identical"].get<bool>()) << "FFV1 holds the codes of the PNGs";
}

TEST(Render, exr_and_extra_layers_are_written_where_asked) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "a") + Words{"--format", "exr", "--aov", "depth,normal,id,position"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(dir / "a/frame_0000.exr"));
  ASSERT_EQ(run_tool(dir, small_teapot("0", "b") + Words{"--format", "png16", "--aov", "depth"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(dir / "b/frame_0000.png"));
  EXPECT_TRUE(std::filesystem::exists(dir / "b/aov_0000.exr"));
}

TEST(Render, exr_files_say_version_optics_and_views_in_their_header) {
  const TempDir dir;
  ASSERT_EQ(run_tool(dir, small_teapot("0", "a") + Words{"--format", "exr"}).exit_code, 0);
  ASSERT_EQ(run_tool(dir, small_teapot("0", "b") + Words{"--aov", "depth"}).exit_code, 0);
  for (const char* file : {"a/frame_0000.exr", "b/aov_0000.exr"}) {
    const Imf::InputFile exr((dir / file).c_str());
    const auto text = [&](const char* name) {
      const auto* attribute = exr.header().findTypedAttribute<Imf::StringAttribute>(name);
      return attribute ? attribute->value() : std::string();
    };
    EXPECT_EQ(text("lippmann.version"), version()) << file;
    EXPECT_EQ(text("lippmann.scene"), "teapot") << file;
    EXPECT_EQ(text("lippmann.views"), "8x1") << file;
    const auto report = json_of(bytes_of(dir / "a/report.json"));
    EXPECT_EQ(json_of(text("lippmann.optics")), report["optics"]) << file;
    EXPECT_LT(report["depth"]["scale"], 1.0) << "a scene that is shown as deep as it is says nothing of this test";
    EXPECT_NEAR(std::stod(text("lippmann.depth_scale")), report["depth"]["scale"].get<double>(), 1e-6) << file;
  }
}

TEST(Render, standard_output_is_no_folder) {
  const TempDir dir;
  expect_refusal(run_tool(dir, {"render", "teapot", "--frames", "0", "-o", "-"}), 2, "--output");
  EXPECT_FALSE(std::filesystem::exists(dir / "-"));
}

}  // namespace
}  // namespace lippmann::test
