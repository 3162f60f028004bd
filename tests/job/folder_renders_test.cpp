#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "job/renders.hpp"
#include "job/report.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class FolderRenders : public Renders {};

TEST_F(FolderRenders, other_settings_are_refused) {
  render(teapot("a", "0-1", {{"aov", "depth"}}));
  const Files before = all_files(dir_ / "a");
  for (const bool resume : {false, true}) {
    RenderParams other = teapot("a", "0-1", {{"view-angle", "40"}});
    other.resume = resume;
    EXPECT_THAT(refusal(other), HasSubstr("a: holds another render: it differs in view-angle, aov"));
    EXPECT_THAT(error_message([&] { RenderSetup(ResolvedJob(other), {}, context_); }), HasSubstr("holds another render"));
  }
  EXPECT_EQ(all_files(dir_ / "a"), before);
}

TEST_F(FolderRenders, other_key_frames_are_refused) {
  render(teapot("a", "0-3", {{"keyframes", "3"}, {"reuse", "interpolate"}}));
  EXPECT_THAT(refusal(teapot("a", "0-3", {{"keyframes", "2"}, {"reuse", "interpolate"}})),
              HasSubstr("it differs in keyframes"));
}

TEST_F(FolderRenders, same_job_gives_the_same_files) {
  const Files first = rendered(teapot("a", "0-1"));
  EXPECT_EQ(first.size(), 2u);
  EXPECT_EQ(rendered(teapot("a", "0-1")), first);
  EXPECT_EQ(warnings_, "");
  EXPECT_TRUE(check("a").passed());
}

TEST_F(FolderRenders, forced_render_removes_old_layers) {
  render(teapot("a", "0-1", {{"aov", "depth"}}));
  ASSERT_TRUE(exists("a/aov_0000.exr"));
  render(teapot("a", "0", {{"view-angle", "40"}}), {.force = true});
  EXPECT_FALSE(exists("a/aov_0000.exr"));
  EXPECT_FALSE(exists("a/frame_0001.png"));
  EXPECT_TRUE(check("a").passed());
}

TEST_F(FolderRenders, frames_of_one_job_accumulate) {
  render(teapot("a", "0-3"));
  render(teapot("a", "4-5"));
  const std::string job = bytes("a/job.toml");
  EXPECT_THAT(job, HasSubstr("frames = \"0-5\"\n"));
  RenderParams one = job_of("a");
  one.output.frames = FrameRanges{{2, 2}};
  render(one);
  EXPECT_EQ(bytes("a/job.toml"), job);
  EXPECT_TRUE(check("a").passed());
  EXPECT_EQ(kept(resume(job_of("a"))), 6u);
}

TEST_F(FolderRenders, listed_frames_are_rendered_and_kept) {
  const Files all = rendered(teapot("all", "0-4")), some = rendered(teapot("some", "4,0-2:2"));
  ASSERT_EQ(some.size(), 3u);
  for (const auto& [name, picture] : some) EXPECT_TRUE(all.at(name) == picture) << name;
  EXPECT_EQ(kept(resume(teapot("some", "0-4:2"))), 3u);
}

TEST_F(FolderRenders, foreign_job_file_is_never_overwritten) {
  fs::create_directory(dir_ / "a");
  const std::string job = "# mine\nscene = \"teapot\"\nlenses = 8\noutput = \".\"\nframes = \"0-1\"\n";
  std::ofstream(dir_ / "a/job.toml") << job;
  render(job_of("a"));
  EXPECT_EQ(warnings_, "");
  RenderParams others = job_of("a");
  others.output.frames = FrameRanges{{4, 5}};
  render(others);
  EXPECT_EQ(warnings_, "");
  others.optics.view_angle_deg = 40.0f;
  render(others, {.force = true});
  EXPECT_THAT(warnings_, HasSubstr("job.toml was not written by this render and is kept, although it differs in view-angle"));
  EXPECT_EQ(bytes("a/job.toml"), job);
  EXPECT_TRUE(check("a").passed());
}

TEST_F(FolderRenders, edited_job_file_is_kept) {
  render(teapot("a", "0"));
  std::ofstream(dir_ / "a/job.toml", std::ios::app) << "spp = 1\n# mine\n";
  const std::string job = bytes("a/job.toml");
  render(teapot("a", "1"), {.force = true});
  EXPECT_EQ(bytes("a/job.toml"), job);
}

TEST_F(FolderRenders, resuming_repairs_a_damaged_job_file) {
  render(teapot("a", "0"));
  const std::string job = bytes("a/job.toml");
  std::string other = job;
  other.replace(job.find("seed = 0"), 8, "seed = 1");
  for (const std::string& damaged : {job.substr(0, 30) + '\x01' + job.substr(31), other}) {
    std::ofstream(dir_ / "a/job.toml") << damaged;
    resume(teapot("a", "0"));
    EXPECT_TRUE(check("a").passed());
    EXPECT_EQ(warnings_, "");
  }
}

TEST_F(FolderRenders, damaged_job_file_is_reported) {
  render(teapot("a", "0"));
  std::ofstream(dir_ / "a/job.toml", std::ios::app) << "\x01";
  EXPECT_THAT(test::error_message([&] { job_of("a"); }),
              testing::AllOf(HasSubstr("is damaged or was edited"), HasSubstr("--resume` writes it again")));
}

TEST_F(FolderRenders, part_does_not_overwrite_the_whole_video) {
  const RenderParams whole = teapot("a", "0-2", {{"video", dir_ / "a/film.mkv"}});
  render(whole);
  const Files before = all_files(dir_ / "a");
  RenderParams part = job_of("a");
  part.output.frames = FrameRanges{{0, 0}};
  EXPECT_THAT(refusal(part), HasSubstr("film.mkv: is a finished video of frames 0-2"));
  EXPECT_EQ(all_files(dir_ / "a"), before);
  RenderParams elsewhere = part;
  elsewhere.output.video = {dir_ / "first.mkv"};
  render(elsewhere);
  resume(whole);
  EXPECT_TRUE(check("a").passed());
  render(part, {.force = true});
  EXPECT_LT(fs::file_size(dir_ / "a/film.mkv"), before.at("film.mkv").size());
}

TEST_F(FolderRenders, foreign_video_is_not_overwritten) {
  std::ofstream(dir_ / "holiday.mkv") << "precious";
  const RenderParams params = teapot("a", "0", {{"video", dir_ / "holiday.mkv"}});
  EXPECT_THAT(refusal(params), HasSubstr("holiday.mkv: exists already"));
  EXPECT_EQ(bytes("holiday.mkv"), "precious");
  EXPECT_FALSE(exists("a"));
  render(params, {.force = true});
  EXPECT_NE(bytes("holiday.mkv"), "precious");
}

TEST_F(FolderRenders, foreign_layer_is_reported_and_skipped) {
  const Settings grid{{"optics", "multiview"}, {"camera-grid", "true"}, {"views", "2x2"}, {"size", "32x32"}, {"frames", "0"}};
  render(job("teapot", "deep", grid + Settings{{"aov", "depth"}}));
  render(job("teapot", "plain", grid));
  convert("deep", "deep-hci", "hci");
  ASSERT_TRUE(exists("deep-hci/frame_0000/gt_depth_lowres_Cam000.pfm"));
  fs::copy_file(dir_ / "deep/aov_0000.exr", dir_ / "plain/aov_0000.exr");
  convert("plain", "plain-hci", "hci");
  EXPECT_FALSE(exists("plain-hci/frame_0000/gt_depth_lowres_Cam000.pfm"));
  EXPECT_THAT(check("plain").foreign, ElementsAre("aov_0000.exr"));
  resume(job("teapot", "plain", grid));
  EXPECT_THAT(warnings_, HasSubstr("also holds files that do not belong to this render and are kept: aov_0000.exr"));
}

TEST_F(FolderRenders, symbolic_links_are_not_followed) {
  fs::create_directory(dir_ / "a"), fs::create_directory(dir_ / "elsewhere");
  fs::create_directory_symlink(dir_ / "elsewhere", dir_ / "a/frame_0000");
  EXPECT_THAT(refusal(teapot("a", "0", {{"layout", "views"}})), HasSubstr("a/frame_0000: is a symbolic"));
  EXPECT_TRUE(fs::is_empty(dir_ / "elsewhere"));
}

void flip_a_bit(const fs::path& file) {
  std::string contents = file_bytes(file);
  contents[contents.size() / 2] ^= 1;
  std::ofstream(file, std::ios::binary) << contents;
}

TEST_F(FolderRenders, resuming_repairs_every_damaged_file) {
  const std::vector<Settings> kinds{
      {{"lenses", "6"}, {"aov", "depth"}},
      {{"lenses", "6"}, {"format", "tiff"}},
      {{"lenses", "6"}, {"format", "exr"}},
      {{"lenses", "6"}, {"layout", "views"}},
      {{"optics", "multiview"}, {"views", "2x2"}, {"size", "32x32"}, {"layout", "quilt"}},
      {{"optics", "multiview"}, {"views", "2x2"}, {"size", "32x32"}, {"camera-grid", "true"}, {"to", "hci"}}};
  const std::vector<std::function<void(const fs::path&)>> damages{
      flip_a_bit, [](const fs::path& file) { std::ofstream(file) << std::string(fs::file_size(file), '\0'); },
      [](const fs::path& file) { fs::resize_file(file, 0); }, [](const fs::path& file) { fs::remove(file); }};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const RenderParams params = job("teapot", "kind-" + std::to_string(kind), kinds[kind] + Settings{{"frames", "0"}});
    render(params);
    const fs::path folder = params.output.folder;
    const Files whole = pictures_below(folder);
    const std::string name = std::next(whole.begin(), static_cast<std::ptrdiff_t>(whole.size()) / 2)->first;
    for (std::size_t i = 0; i < damages.size(); ++i) {
      damages[i](folder / name);
      const FolderCheck found = check_folder(folder);
      EXPECT_THAT(fs::exists(folder / name) ? found.damaged : found.missing, ElementsAre(name)) << i;
      resume(params);
      EXPECT_EQ(pictures_below(folder), whole) << name << " " << i;
      EXPECT_TRUE(check_folder(folder).passed());
    }
  }
}

TEST_F(FolderRenders, resuming_gives_the_same_bytes) {
  const std::vector<Settings> kinds{{{"reuse", "interpolate"}, {"keyframes", "4"}, {"fill", "retrace"}, {"halving", "true"}},
                                    {{"reuse", "copy"}, {"keyframes", "4"}},
                                    {{"lenses", "8"}, {"integrator", "path"}, {"spp", "2"}},
                                    {{"lenses", "8"}, {"integrator", "path"}, {"spp", "2"}, {"denoise", "none"}}};
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    const RenderParams params = teapot("kind-" + std::to_string(kind), "0-5", kinds[kind]);
    const fs::path folder = params.output.folder;
    render(params);
    const Files whole = pictures_below(folder);
    for (const char* lost : {"frame_0002.png", "frame_0003.png", "frame_0005.png"}) fs::remove(folder / lost);
    EXPECT_EQ(kept(resume(params)), 3u);
    EXPECT_EQ(pictures_below(folder), whole) << kind;
  }
}

TEST_F(FolderRenders, errors_of_paths_stay_in_the_report) {
  const RenderParams params = teapot("a", "0-2", {{"integrator", "path"}, {"spp", "4"}});
  const RenderReport whole = render(params);
  ASSERT_TRUE(whole.frames.at(0).estimated_psnr_db);
  const Files pictures = files_in(dir_ / "a", ".png");
  fs::remove(dir_ / "a/frame_0001.png");
  RenderReport resumed = resume(job_of("a"));
  EXPECT_EQ(files_in(dir_ / "a", ".png"), pictures);
  ASSERT_EQ(resumed.frames.size(), whole.frames.size());
  for (std::size_t i = 0; i < whole.frames.size(); ++i) {
    EXPECT_EQ(resumed.frames[i].kind, whole.frames[i].kind);
    EXPECT_EQ(resumed.frames[i].estimated_psnr_db, whole.frames[i].estimated_psnr_db);
    EXPECT_EQ(resumed.frames[i].psnr_at_least_db, whole.frames[i].psnr_at_least_db);
    EXPECT_EQ(resumed.frames[i].psnr_at_most_db, whole.frames[i].psnr_at_most_db);
  }
  EXPECT_EQ(kept(resumed), 2u);
  resumed.frames[0].kept = false;
  EXPECT_EQ(to_json(resumed).at("frames").at(0), to_json(whole).at("frames").at(0));
}

TEST_F(FolderRenders, missing_view_is_rendered_again) {
  const RenderParams views =
      teapot("a", "3-4", {{"optics", "microlens"}, {"lenses", "8"}, {"lens-pixels", "4"}, {"layout", "views"}});
  render(views);
  const Files before = files_in(dir_ / "a/frame_0004", ".png");
  fs::remove(dir_ / "a/frame_0004/view_007.png");
  EXPECT_EQ(kept(resume(views)), 1u);
  EXPECT_EQ(files_in(dir_ / "a/frame_0004", ".png"), before);
}

TEST_F(FolderRenders, job_file_gives_the_same_pictures) {
  const Files first = rendered(
      teapot("a", "4-5", {{"optics", "microlens"}, {"lens-pixels", "6"}, {"view-angle", "35"}, {"spp", "2"}, {"seed", "9"}}));
  EXPECT_EQ(first.size(), 2u);
  RenderParams again = job_of("a");
  again.output.folder = dir_ / "b";
  EXPECT_EQ(rendered(again), first);
}

TEST_F(FolderRenders, path_traced_file_is_resumed) {
  std::ofstream(dir_ / "plain.obj") << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const RenderParams params = job(dir_ / "plain.obj", "a", {{"lenses", "4"}, {"frames", "0"}});
  const Files whole = rendered(params);
  EXPECT_EQ(kept(resume(job_of("a"))), 1u);
  EXPECT_EQ(kept(resume(params)), 1u);
  EXPECT_EQ(files_in(dir_ / "a", ".png"), whole);
}

TEST_F(FolderRenders, report_has_optics_settings_and_rays) {
  const nlohmann::ordered_json report = to_json(render(teapot("a", "3-4", {{"reuse", "none"}})));
  EXPECT_EQ(report, nlohmann::ordered_json::parse(bytes("a/report.json")));
  for (const char* key : {"version", "scene", "optics", "settings", "frames", "totals"})
    EXPECT_TRUE(report.contains(key)) << key;
  ASSERT_EQ(report["frames"].size(), 2u);
  const auto& frame = report["frames"][1];
  EXPECT_EQ(frame["frame"], 4);
  EXPECT_EQ(frame["kind"], "full");
  EXPECT_EQ(frame["rays"]["primary"], 128 * 128);
  for (const char* key : {"seconds", "cpu_seconds", "missed_pixels", "retraced_pixels", "reused_pixels", "estimated_psnr_db"})
    EXPECT_TRUE(frame.contains(key)) << key;
  const auto& totals = report["totals"];
  EXPECT_EQ(totals["frames"], 2);
  EXPECT_EQ(totals["rays"]["primary"], 2 * 128 * 128);
  EXPECT_GT(totals["peak_memory_bytes"].get<double>(), 1e6);
  for (const char* key : {"seconds", "cpu_seconds", "write_seconds", "setup_seconds", "threads"})
    EXPECT_TRUE(totals[key].is_number()) << key;
}

}  // namespace
}  // namespace lippmann::test
