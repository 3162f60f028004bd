#include "folder/render_state.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <array>
#include <fstream>

#include "folder/journal_part.hpp"
#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

const FileChecksum kRecorded{7, "0123456789abcdef"};

std::string line_of_frame(int frame) {
  FrameReport report;
  report.frame = frame;
  return frame_line(report, {{"frame_000" + std::to_string(frame) + ".png", kRecorded}});
}

struct Watched {
  test::TempDir dir;
  std::optional<JournalPart> part;
  RenderStateReader reader{dir.path()};

  Watched() {
    fs::create_directory(journal_folder(dir.path()));
    part.emplace(journal_folder(dir.path()), "job");
    part->add(asked_line({0, 1, 2}));
  }
  RenderActivity activity() { return reader.read()->activity; }
};

// The runs finish 3 frames in 30 s and 1 frame in 20 s, together 0.15 frames/s, so 6 frames take 40 s. The last frame
// was finished 4 s ago, so 36 s are left.
TEST(RenderState, time_left_combines_all_runs) {
  const std::array runs{RunPace{100.0, 130.0, 3}, RunPace{100.0, 120.0, 1}};
  EXPECT_NEAR(*estimated_seconds_left(runs, 6, 134.0), 36.0, 1e-9);
}

TEST(RenderState, time_left_is_unknown_at_first) {
  const std::array none{RunPace{100.0, 101.0, 0}};
  EXPECT_FALSE(estimated_seconds_left(none, 6, 134.0));
  const std::array late{RunPace{100.0, 110.0, 1}};
  EXPECT_EQ(estimated_seconds_left(late, 1, 200.0), 0.0);
}

TEST(RenderState, frames_count_once_recorded) {
  Watched render;
  EXPECT_EQ(render.activity(), RenderActivity::kRunning);
  EXPECT_TRUE(render.reader.read()->journal.frames.empty());
  render.part->add(line_of_frame(1));
  const RenderState state = *render.reader.read();
  EXPECT_EQ(picture_of(state.journal.frames.at(1)), "frame_0001.png");
  EXPECT_EQ(state.running.size(), 1u);
}

TEST(RenderState, ended_run_without_all_frames_is_stopped) {
  Watched render;
  render.part->add(line_of_frame(0));
  render.part.reset();  // ends the run without a final line, as if killed
  EXPECT_EQ(render.activity(), RenderActivity::kStopped);
  EXPECT_FALSE(render.reader.read()->seconds_left);
}

TEST(RenderState, finished_needs_all_frames_and_an_ended_process) {
  Watched render;
  for (const int frame : {0, 1, 2}) render.part->add(line_of_frame(frame));
  EXPECT_EQ(render.activity(), RenderActivity::kRunning);
  render.part.reset();
  EXPECT_EQ(render.activity(), RenderActivity::kFinished);
}

TEST(RenderState, remote_run_is_elsewhere_until_its_end) {
  const test::TempDir dir;
  fs::create_directory(journal_folder(dir.path()));
  const fs::path part = journal_folder(dir.path()) / "01764104700-another-1.jsonl";
  std::ofstream(part) << job_line("job") << asked_line({0, 1});
  RenderStateReader reader(dir.path());
  EXPECT_EQ(reader.read()->activity, RenderActivity::kElsewhere);
  EXPECT_EQ(reader.read()->elsewhere, "another");
  std::ofstream(part, std::ios::app) << run_line({.host = "another"});
  EXPECT_EQ(reader.read()->activity, RenderActivity::kStopped);
}

TEST(RenderState, missing_journals_give_none_damaged_ones_fail) {
  const test::TempDir dir;
  RenderStateReader reader(dir.path());
  EXPECT_FALSE(reader.read());
  fs::create_directory(journal_folder(dir.path()));
  std::ofstream(journal_folder(dir.path()) / "1.jsonl") << job_line("job") << "{}\n{}\n";
  EXPECT_THROW(reader.read(), Error);
}

TEST(RenderState, picture_is_a_file_or_a_folder) {
  const auto of = [](FileRecords files) { return picture_of({{}, std::move(files)}).string(); };
  EXPECT_EQ(of({{"aov_0001.exr", kRecorded}, {"frame_0001_qs4x3a1.png", kRecorded}}), "frame_0001_qs4x3a1.png");
  EXPECT_EQ(of({{"frame_0001_qs4x3a1.png", kRecorded}, {"frame_0001_qs4x3a1.png.json", kRecorded}}), "frame_0001_qs4x3a1.png");
  EXPECT_EQ(of({{"frame_0001/view_000.png", kRecorded}, {"frame_0001/aov_000.exr", kRecorded}}), "frame_0001");
}

}  // namespace
}  // namespace lippmann
