#include "folder/journal.hpp"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>
#include <random>

#include "folder/folder_check.hpp"
#include "formats/frame_names.hpp"
#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const FileChecksum kSum{7, "0123456789abcdef"}, kOther{8, "fedcba9876543210"};

std::string sound_journal() {
  FrameReport frame;
  frame.frame = 4;
  frame.rays.primary = 100;
  return job_line("job") + asked_line({3, 4, 5, 9}) + written_line("job.toml", kSum) +
         frame_line(frame, {{"frame_0004.png", kSum}, {"aov_0004.exr", kSum}}) + video_line("../a.mp4", {3, 4}, kSum) +
         written_line("report.json", kSum) + written_line("report.json", kOther) +
         run_line({.host = "a", .cpu = "p", .unit = "1/2", .frames = {4}, .setup_seconds = 0.5, .threads = 2});
}

FolderJournal journal_of(const std::string& text) {
  const test::TempDir dir;
  std::filesystem::create_directory(journal_folder(dir.path()));
  std::ofstream(journal_folder(dir.path()) / "1.jsonl") << text;
  return read_journal(dir.path()).value_or(FolderJournal{});
}

TEST(FolderJournal, round_trips) {
  const FolderJournal journal = journal_of(sound_journal());
  EXPECT_EQ(journal.problem, "");
  EXPECT_EQ(journal.job, "job");
  EXPECT_THAT(journal.asked, ElementsAre(3, 4, 5, 9));
  EXPECT_EQ(journal.frames.at(4).report.rays.primary, 100u);
  EXPECT_EQ(journal.frames.at(4).files, (FileRecords{{"frame_0004.png", kSum}, {"aov_0004.exr", kSum}}));
  EXPECT_THAT(journal.files.at("job.toml"), ElementsAre(kSum));
  EXPECT_THAT(journal.files.at("report.json"), ElementsAre(kSum, kOther));
  ASSERT_EQ(journal.runs.size(), 1u);
  EXPECT_EQ(journal.runs[0].threads, 2);
  EXPECT_EQ(journal.runs[0].unit, "1/2");
  EXPECT_EQ(journal.runs[0].cpu, "p");
  EXPECT_THAT(journal.runs[0].frames, ElementsAre(4));
  EXPECT_EQ(journal.videos.at("../a.mp4").sums, std::vector{kSum});
  EXPECT_THAT(journal.videos.at("../a.mp4").frames, ElementsAre(3, 4));
}

TEST(FolderJournal, last_line_of_a_frame_counts) {
  const FileChecksum later{8, "fedcba9876543210"};
  FrameReport frame;
  frame.frame = 4;
  const FolderJournal journal = journal_of(sound_journal() + frame_line(frame, {{"frame_0004.png", later}}));
  EXPECT_EQ(journal.problem, "");
  EXPECT_EQ(journal.frames.at(4).files, (FileRecords{{"frame_0004.png", later}}));
}

TEST(FolderJournal, truncation_is_valid_anywhere) {
  const std::string whole = sound_journal();
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    const FolderJournal journal = journal_of(whole.substr(0, bytes));
    EXPECT_EQ(journal.problem, "") << bytes;
    EXPECT_EQ(journal.parts.size(), bytes < whole.find('\n') + 1 ? 0u : 1u) << bytes;
  }
}

TEST(FolderJournal, impossible_names_and_numbers_are_problems) {
  const std::string sum = R"("bytes":7,"xxh3":"0123456789abcdef")";
  const std::string long_name(100'000, 'a'), frame = frame_line({}, {{"frame_0000.png", kSum}});
  const auto frame_with = [&](const std::string& from, const std::string& to) {
    std::string line = frame;
    return line.replace(line.find(from), from.size(), to);
  };
  const std::vector<std::string> hostile{frame_with("frame_0000.png", "../frame_0000.png"),
                                         frame_with("frame_0000.png", "/tmp/frame_0000.png"),
                                         frame_with("frame_0000.png", "frame_0000/../../view_000.png"),
                                         frame_with("frame_0000.png", "frame_0000/./view_000.png"),
                                         frame_with("frame_0000.png", "frame_0001.png"),
                                         frame_with("frame_0000.png", "notes.txt"),
                                         frame_with("frame_0000.png", ""),
                                         frame_with("frame_0000.png", long_name),
                                         frame_with("frame_0000.png", "frame_0000_qs" + std::string(100'000, '1') + ".png"),
                                         frame_with("\"frame\":0", "\"frame\":-1"),
                                         frame_with("\"frame\":0", "\"frame\":1e300"),
                                         frame_with("\"frame\":0", "\"frame\":4294967296"),
                                         frame_with("\"primary\":0", "\"primary\":-1e300"),
                                         frame_with("\"bytes\":7", "\"bytes\":-7"),
                                         frame_with("\"bytes\":7", "\"bytes\":1e300"),
                                         frame_with("\"bytes\":7", "\"bytes\":18446744073709551615"),
                                         frame_with("\"bytes\":7", "\"bytes\":\"7\""),
                                         frame_with("0123456789abcdef", "0123456789abcdeg"),
                                         frame_with("0123456789abcdef", std::string(100'000, '0')),
                                         R"({"written":"../job.toml",)" + sum + "}\n",
                                         R"({"written":"/etc/passwd",)" + sum + "}\n",
                                         R"({"video":"../../.bashrc","frames":"0",)" + sum + "}\n",
                                         R"({"video":"a.mp4","frames":"0-2000000000",)" + sum + "}\n",
                                         R"({"asked":"0-2000000000"})"
                                         "\n",
                                         R"({"asked":7})"
                                         "\n",
                                         std::string(10'000, '[') + "\n",
                                         std::string(5000, '\0') + "\n",
                                         "[]\n",
                                         "\n"};
  for (const std::string& line : hostile) {
    const FolderJournal journal = journal_of(job_line("job") + line + asked_line({0}));
    EXPECT_THAT(journal.problem, HasSubstr("line 2 ")) << line.substr(0, 200);
    EXPECT_TRUE(journal.frames.empty() && journal.videos.empty() && journal.files.empty()) << line.substr(0, 200);
  }
}

TEST(FolderJournal, first_line_must_name_a_job) {
  for (const char* line : {"hello\n", "{}\n", "{\"job\":1}\n", "[\"job\"]\n"})
    EXPECT_THAT(journal_of(line).problem, HasSubstr("line 1 ")) << line;
}

TEST(FolderJournal, files_of_the_wrong_type_are_errors) {
  const test::TempDir dir;
  std::ofstream(journal_folder(dir.path())) << "no folder";
  EXPECT_THROW(read_journal(dir.path()), Error);
  std::filesystem::remove(journal_folder(dir.path()));
  std::filesystem::create_directory(journal_folder(dir.path()));
  const auto part = journal_folder(dir.path()) / "1.jsonl";
  ASSERT_EQ(mkfifo(part.c_str(), 0600), 0);
  EXPECT_THROW(read_journal(dir.path()), Error);
  std::filesystem::remove(part);
  std::filesystem::create_directory(part);
  EXPECT_THROW(read_journal(dir.path()), Error);
}

TEST(FolderJournal, combines_runs_of_one_job) {
  const test::TempDir dir;
  std::filesystem::create_directory(journal_folder(dir.path()));
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(journal_folder(dir.path()) / name) << text;
  };
  write("1.jsonl", sound_journal());
  write("2.jsonl", job_line("job") + asked_line({9, 10}));
  write("3.jsonl", "{\"job\": \"jo");  // the run was killed while it wrote its first line
  const std::optional<FolderJournal> journal = read_journal(dir.path());
  EXPECT_EQ(journal->problem, "");
  EXPECT_EQ(journal->parts.size(), 2u);
  EXPECT_THAT(journal->asked, ElementsAre(3, 4, 5, 9, 10));
  EXPECT_TRUE(journal->frames.contains(4));
  write("2.jsonl", job_line("another") + asked_line({9}));
  EXPECT_EQ(read_journal(dir.path())->problem, "") << "it has finished nothing";
  EXPECT_EQ(read_journal(dir.path())->claims.size(), 1u);
  write("2.jsonl", job_line("another") + video_line("film.mp4", {9}, {}));
  EXPECT_THAT(read_journal(dir.path())->problem, HasSubstr("line 1 of '2.jsonl'"));
}

// A damaged journal must not name a file outside the folder.
TEST(FolderJournal, noise_names_only_files_of_frames) {
  const std::string sound = sound_journal();
  std::mt19937 random(20);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % n; };
  for (int i = 0; i < 1000; ++i) {
    std::string text = sound;
    for (std::size_t change = 0; change < 1 + below(8); ++change) {
      const std::size_t at = below(text.size()), count = 1 + below(40);
      const std::string piece = text.substr(at, count);
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(below(256));
          break;
        case 1:
          text.erase(at, count);
          break;
        case 2:
          text.insert(below(text.size()), piece);
          break;
        case 3:
          text.insert(at, std::vector<std::string>{"../", "/", "\"", "-", "e300", "\n", "{", "99999999999"}[below(8)]);
          break;
        default:
          text.replace(at, piece.size(), piece.size(), '0');
      }
      if (text.empty()) text = "{";
    }
    const FolderJournal journal = journal_of(text);
    for (const auto& [frame, record] : journal.frames)
      for (const auto& [name, sum] : record.files) EXPECT_EQ(frame_of_file(name), frame) << name;
    for (const auto& [name, sums] : journal.files) EXPECT_TRUE(name == "job.toml" || name == "report.json") << name;
  }
}

}  // namespace
}  // namespace lippmann
