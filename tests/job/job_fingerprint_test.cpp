#include "job/job_fingerprint.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;

TEST(JobFingerprint, depends_only_on_what_changes_pictures) {
  const Scene scene;
  RenderParams params;
  const std::string same = job_fingerprint(ResolvedJob(params), scene);
  RenderParams elsewhere = params;
  elsewhere.output.folder = "elsewhere";
  elsewhere.threads = 7;
  elsewhere.output.frames = FrameRanges{{0, 1}};
  elsewhere.output.video = {"a.mp4"};
  elsewhere.output.also = Companion::kSingle, elsewhere.output.page = true;
  elsewhere.resume = true;
  elsewhere.sampling.order = RayOrder::kRows;
  EXPECT_EQ(job_fingerprint(ResolvedJob(elsewhere), scene), same);
  RenderParams finer = params;
  finer.sampling.spp = 2;
  EXPECT_NE(job_fingerprint(ResolvedJob(finer), scene), same);
  Scene darker;
  darker.background.horizon = Vec3f(0.5f);
  EXPECT_NE(job_fingerprint(ResolvedJob(params), darker), same);
}

TEST(JobFingerprint, differences_are_the_parameters_of_pictures) {
  const test::TempDir dir;
  std::ofstream(dir / "job.toml") << "scene = \"teapot\"\nspp = 4\nview-angle = 40\nthreads = 3\nframes = \"0-3\"\n";
  RenderParams params;
  params.scene.name = "teapot";
  EXPECT_THAT(differences(dir / "job.toml", ResolvedJob(params)), ElementsAre("view-angle", "spp"));
  std::ofstream(dir / "job.toml") << "no job";
  EXPECT_THAT(differences(dir / "job.toml", ResolvedJob(params)), ElementsAre());
}

}  // namespace
}  // namespace lippmann
