#include "core/recorded_file.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <span>

#include "folder/render_folder.hpp"
#include "formats/rendered.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const std::string kNone = "(no Error)";

void make_render_file(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  std::ofstream(path) << bytes;
}

void make_render(const fs::path& folder) {
  fs::create_directories(folder);
  RenderFolder render(folder, "job");
  FrameReport report;
  for (const std::vector<std::string>& names :
       {std::vector<std::string>{"frame_0000.png", "aov_0000.exr"}, {"frame_0001/view_000.png", "frame_0001/view_001.png"}}) {
    std::vector<fs::path> files;
    for (const std::string& name : names) make_render_file(files.emplace_back(folder / name), name);
    render.add(report, records_of(folder, files));
    ++report.frame;
  }
  render.write("report.json", [](const FolderJournal&) { return std::string("report"); });
}

std::string refusal_of_file(const fs::path& file, const std::string& bytes) {
  return test::error_message([&] { require_as_recorded(file, std::as_bytes(std::span(bytes))); });
}

void append(const fs::path& folder, const std::string& bytes) {
  std::ofstream(read_journal(folder)->parts.front(), std::ios::app | std::ios::binary) << bytes;
}

TEST(RecordedFile, changed_bytes_are_refused) {
  const test::TempDir dir;
  make_render(dir.path());
  for (const char* name : {"frame_0000.png", "aov_0000.exr", "frame_0001/view_001.png"}) {
    EXPECT_EQ(refusal_of_file(dir / name, name), kNone);
    EXPECT_THAT(refusal_of_file(dir / name, "other bytes"),
                testing::AllOf(HasSubstr(name), HasSubstr("bytes differ from the bytes that its render wrote")));
  }
  EXPECT_EQ(refusal_of_file(dir / "report.json", "report"), kNone);
  EXPECT_NE(refusal_of_file(dir / "report.json", "reports"), kNone);
  EXPECT_NE(refusal_of_file(dir / "frame_0000.png", "aov_0000.exr"), kNone) << "another file of the render";
}

TEST(RecordedFile, videos_and_side_files_are_compared) {
  const test::TempDir dir;
  for (const char* name : {"film.mp4", "film.mp4.json"}) make_render_file(dir / name, name);
  RenderFolder(dir.path(), "job").add_video(dir / "film.mp4", {0}, true);
  for (const char* name : {"film.mp4", "film.mp4.json"}) {
    require_as_recorded(dir / name);
    make_render_file(dir / name, "other bytes");
    EXPECT_THAT(test::error_message([&] { require_as_recorded(dir / name); }),
                HasSubstr("bytes differ from the bytes that its render wrote"));
  }
}

TEST(RecordedFile, unrecorded_file_passes) {
  const test::TempDir dir;
  EXPECT_EQ(refusal_of_file(dir / "frame_0000.png", "bytes"), kNone);
  make_render(dir / "a");
  for (const char* name : {"a/frame_0002.png", "a/notes.txt", "a/quilts/frame_0000.png", "frame_0000.png"})
    EXPECT_EQ(refusal_of_file(dir / name, "bytes"), kNone) << name;
}

TEST(RecordedFile, unrecorded_files_warn) {
  const test::TempDir dir;
  make_render(dir.path());
  std::vector<std::string> warnings;
  Context context;
  context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
  warn_about_unchecked_files(dir.path(), context);
  EXPECT_TRUE(warnings.empty()) << warnings.front();
  for (const char* name : {"frame_0002.png", "frame_0001/view_002.png", "notes.txt", "quilts/frame_0000.png"})
    make_render_file(dir / name, "bytes");
  for (const char* in : {"", "frame_0002.png", "frame_0001", "frame_0000.png"}) warn_about_unchecked_files(dir / in, context);
  EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("has 2 files that the journal"),
                                             HasSubstr("it is not checked for damage: frame_0002.png"),
                                             HasSubstr("it is not checked for damage: frame_0001/view_002.png")));
}

TEST(RecordedFile, emptied_journal_counts_as_none) {
  for (const std::string& left : {std::string(), std::string("{\"job")}) {
    const test::TempDir dir;
    make_render(dir.path());
    make_render_file(dir / "report.json", R"({"runs": []})");
    make_render_file(read_journal(dir.path())->parts.front(), left);
    EXPECT_FALSE(has_journal(dir.path()));
    std::vector<std::string> warnings;
    Context context;
    context.warn = [&](std::string_view text) { warnings.emplace_back(text); };
    warn_about_unchecked_files(dir.path(), context);
    EXPECT_THAT(warnings, testing::ElementsAre(HasSubstr("has no journal of its render")));
  }
}

TEST(RecordedFile, missing_file_of_a_frame_is_named) {
  const test::TempDir dir;
  require_recorded_frames(dir.path());
  make_render(dir.path());
  require_recorded_frames(dir.path());
  fs::remove(dir / "frame_0001/view_000.png");
  EXPECT_THAT(test::error_message([&] { require_recorded_frames(dir.path()); }),
              HasSubstr("frame_0001/view_000.png: is missing"));
}

TEST(RecordedFile, trailing_noise_is_refused_a_cut_line_not) {
  for (const std::string& cut :
       {std::string("{\"frame\":3,\"ki"), std::string("{\"frame\":3,\0\0\0", 14), std::string(100, '\0'), std::string("{")}) {
    const test::TempDir dir;
    make_render(dir.path());
    append(dir.path(), cut);
    EXPECT_EQ(refusal_of_file(dir / "frame_0000.png", "frame_0000.png"), kNone);
    EXPECT_EQ(read_journal(dir.path())->problem, "");
  }
  std::string noise;
  for (int i = 0; i < 1000; ++i) noise += static_cast<char>(1 + i * 7919 % 255);
  for (const std::string& other : {noise, std::string("noise"), std::string("noise\n"), std::string("{\x01")}) {
    const test::TempDir dir;
    make_render(dir.path());
    append(dir.path(), other);
    EXPECT_THAT(refusal_of_file(dir / "frame_0000.png", "frame_0000.png"), HasSubstr("is damaged"));
    EXPECT_NE(read_journal(dir.path())->problem, "");
  }
}

}  // namespace
}  // namespace lippmann
