#include "live/live_job_file.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "job/job_file.hpp"
#include "live/live_support.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(LiveJobFile, saving_again_replaces_what_it_wrote) {
  const test::TempDir dir;
  LiveJobFile job(dir.path() / "new" / "room.toml");
  RenderParams params = test::small_room();
  EXPECT_EQ(job.save(ResolvedJob(params)), dir.path() / "new" / "room.toml");
  params.scene.view.zoom = 2.5f;
  EXPECT_EQ(job.save(ResolvedJob(params)), dir.path() / "new" / "room.toml");
  RenderParams read;
  read_job(dir.path() / "new" / "room.toml", read);
  EXPECT_EQ(read.scene.view.zoom, 2.5f);
}

TEST(LiveJobFile, files_of_others_stay) {
  const test::TempDir dir;
  const fs::path taken = dir.path() / "room.toml";
  std::ofstream(taken) << "somebody's";
  LiveJobFile job(taken);
  EXPECT_EQ(job.save(ResolvedJob(test::small_room())), dir.path() / "room-2.toml");
  std::ofstream(dir.path() / "room-2.toml") << "changed meanwhile";
  EXPECT_EQ(job.save(ResolvedJob(test::small_room())), dir.path() / "room-3.toml");
  EXPECT_EQ(text_of(taken), "somebody's");
  EXPECT_EQ(text_of(dir.path() / "room-2.toml"), "changed meanwhile");
}

}  // namespace
}  // namespace lippmann
