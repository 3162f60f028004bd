#include "job/job_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "job/params_table.hpp"
#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

std::filesystem::path write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
  return path;
}

RenderParams read(const std::filesystem::path& path) {
  RenderParams params;
  read_job(path, params);
  return params;
}

std::string refusal(const std::filesystem::path& path) {
  try {
    read(path);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

std::vector<std::vector<std::string>> all_values(const RenderParams& params) {
  std::vector<std::vector<std::string>> values;
  for (const ParamInfo& info : params_table()) values.push_back(info.get(params));
  return values;
}

RenderParams unusual_params(const test::TempDir& dir) {
  RenderParams params;
  params.scene.name = (dir / "a \"quoted\" scene\\with\ttab.dat").string();
  params.scene.camera_path = (dir / "path.cam").string();
  params.output.frames = FrameRanges{{3, 7}};
  params.scene.fps = 29.97;
  params.optics.kind = OpticsKind::kMicrolens;
  params.optics.packing = LensPacking::kHexagonal;
  params.optics.lenses = {32, 16};
  params.optics.lens_pixels = {13.776f, 0.0f};
  params.optics.view_angle_deg = 0.1f + 0.2f;
  params.optics.viewing_distance_mm = kInfinity;
  params.sampling.spp = 16;
  params.sampling.max_depth = 3;
  params.sampling.seed = 4294967295u;
  params.sampling.order = RayOrder::kColumns;
  params.output.folder = (dir / "out").string();
  params.output.pictures.format = PictureFormat::kExr;
  params.output.pictures.exr_pixels = ExrPixels::kFloat;
  params.sampling.aov = {Aov::kDepth, Aov::kId};
  params.output.video = {(dir / "a.mp4").string(), (dir / "b,c.mkv").string()};
  params.threads = 3;
  params.resume = true;
  return params;
}

TEST(JobFile, round_trip_keeps_all_params) {
  const test::TempDir dir;
  RenderParams plain;
  plain.scene.name = "teapot";
  for (const RenderParams& params : {plain, unusual_params(dir)}) {
    write_job(dir / "job.toml", params);
    EXPECT_EQ(all_values(read(dir / "job.toml")), all_values(params));
  }
}

TEST(JobFile, other_kinds_of_files_are_named) {
  const test::TempDir dir;
  EXPECT_THAT(refusal(write(dir / "a.toml", "")), HasSubstr("is empty (0 bytes)"));
  EXPECT_THAT(refusal(write(dir / "b.toml", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n")),
              HasSubstr("Git LFS pointer"));
}

TEST(JobFile, zero_has_no_sign) {
  const test::TempDir dir;
  const RenderParams params = read(write(dir / "signed.toml", "scene = \"teapot\"\nexposure = -0.0\n"));
  EXPECT_FALSE(std::signbit(params.output.pictures.exposure_ev));
  write_job(dir / "job.toml", params);
  EXPECT_EQ(all_values(read(dir / "job.toml")), all_values(params));
}

TEST(JobFile, values_may_be_toml_types) {
  const test::TempDir dir;
  const RenderParams params = read(write(dir / "job.toml",
                                         "scene = 'teapot'\nlenses = 32\nlens-pixels = 13.5\nviewing-distance = inf\n"
                                         "spp = 4\nresume = true\naov = ['depth', 'id']\nframes = 5\n"));
  EXPECT_EQ(params.optics.lenses, (Extent<int>{32, 0}));
  EXPECT_EQ(params.optics.lens_pixels, (Extent<float>{13.5f, 0.0f}));
  EXPECT_EQ(params.optics.viewing_distance_mm, kInfinity);
  EXPECT_EQ(params.sampling.spp, 4);
  EXPECT_TRUE(params.resume);
  EXPECT_EQ(params.sampling.aov.size(), 2u);
  EXPECT_EQ(params.output.frames, (FrameRanges{{5, 5}}));
}

TEST(JobFile, opposite_keys_exclude_each_other) {
  const test::TempDir dir;
  const auto fit_depth = [&](const char* text) { return read(write(dir / "job.toml", text)).optics.fit_depth; };
  EXPECT_EQ(fit_depth("scene = 'teapot'\n"), std::nullopt);
  EXPECT_EQ(fit_depth("fit-depth = false\n"), false) << "in job files of earlier versions";
  EXPECT_EQ(fit_depth("full-depth = true\n"), false);
  EXPECT_EQ(fit_depth("full-depth = false\n"), true);
  EXPECT_THAT(refusal(write(dir / "job.toml", "fit-depth = true\nfull-depth = true\n")),
              HasSubstr("job.toml:2: full-depth: is set by fit-depth already"));
  EXPECT_THAT(refusal(write(dir / "job.toml", "full-depth = 3\n")), HasSubstr("true or false"));
}

TEST(JobFile, absent_keys_change_nothing) {
  const test::TempDir dir;
  RenderParams params;
  params.sampling.spp = 9;
  read_job(write(dir / "job.toml", "seed = 1\n"), params);
  EXPECT_EQ(params.sampling.spp, 9);
  EXPECT_EQ(params.sampling.seed, 1u);
}

TEST(JobFile, unknown_key_names_the_nearest_one) {
  const test::TempDir dir;
  const auto file = write(dir / "job.toml", "scene = 'teapot'\n\nlens_pixels = 8\n");
  EXPECT_EQ(refusal(file), file.string() + ":3: there is no key 'lens_pixels', did you mean 'lens-pixels'?");
}

TEST(JobFile, bad_value_names_file_line_and_key) {
  const test::TempDir dir;
  const auto file = write(dir / "job.toml", "spp = -1\n");
  EXPECT_THAT(refusal(file), HasSubstr(file.string() + ":1: spp: "));
  EXPECT_THAT(refusal(write(file, "spp = [1, 2]\n")), HasSubstr("is a list; expected one value"));
  EXPECT_THAT(refusal(write(file, "[spp]\nx = 1\n")), HasSubstr(":1: spp: the value is of the wrong type"));
}

TEST(JobFile, broken_toml_names_file_and_line) {
  const test::TempDir dir;
  const auto file = write(dir / "job.toml", "scene = 'teapot'\nspp = \n");
  EXPECT_THAT(refusal(file), HasSubstr(file.string() + ":2: "));
}

TEST(JobFile, missing_file_or_folder_is_refused) {
  const test::TempDir dir;
  EXPECT_THAT(refusal(dir / "none.toml"), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal(dir.path()), HasSubstr("is not a regular file but a folder"));
}

TEST(JobFile, too_large_file_is_refused_unread) {
  const test::TempDir dir;
  EXPECT_THAT(refusal(write(dir / "job.toml", "spp = 1\n" + std::string(2 << 20, '#'))), HasSubstr("at most 1 MiB"));
}

TEST(JobFile, relative_paths_start_at_the_jobs_folder) {
  const test::TempDir dir;
  std::filesystem::create_directory(dir / "jobs");
  const RenderParams params = read(
      write(dir / "jobs/job.toml", "scene = '../scenes/a.dat'\noutput = '.'\nvideo = 'v.mp4'\ncamera-path = '/abs.cam'\n"));
  EXPECT_EQ(params.scene.name, (dir / "scenes/a.dat").string());
  EXPECT_EQ(params.output.folder, (dir / "jobs").string());
  EXPECT_EQ(params.output.video, std::vector<std::string>{(dir / "jobs/v.mp4").string()});
  EXPECT_EQ(params.scene.camera_path, "/abs.cam");
}

TEST(JobFile, written_relative_paths_find_the_same_files) {
  RenderParams params;
  params.scene.name = "scenes/a.dat";
  params.output.folder = "out/a";
  const std::string text = job_text(params, "out/a");
  EXPECT_THAT(text, HasSubstr("scene = \"../../scenes/a.dat\"\n"));
  EXPECT_THAT(text, HasSubstr("output = \".\"\n"));
}

TEST(JobFile, paths_beside_the_job_are_unchanged) {
  RenderParams params;
  params.scene.name = "scenes/a.dat";
  EXPECT_THAT(job_text(params, ""), HasSubstr("scene = \"scenes/a.dat\"\n"));
}

TEST(JobFile, environment_words_and_colours_are_not_paths) {
  const test::TempDir dir;
  for (const std::string value : {"studio", "none", "#204060", "0.5,0.25,1"}) {
    RenderParams params;
    params.scene.environment = value;
    const std::string text = job_text(params, "out/a");
    EXPECT_THAT(text, HasSubstr("environment = \"" + value + "\"\n"));
    EXPECT_EQ(read(write(dir / "job.toml", "environment = '" + value + "'\n")).scene.environment, value);
  }
}

TEST(JobFile, built_in_scene_name_stays_a_name) {
  const test::TempDir dir;
  EXPECT_EQ(read(write(dir / "job.toml", "scene = 'teapot'\n")).scene.name, "teapot");
  RenderParams params;
  params.scene.name = "teapot";
  EXPECT_THAT(job_text(params, "out/teapot"), HasSubstr("scene = \"teapot\"\n"));
}

}  // namespace
}  // namespace lippmann
