#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>
#include <fstream>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/file_bytes.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;
using platform::OpenFile;

TEST(OpenFile, created_file_is_written_and_read_back) {
  const TempDir dir;
  std::error_code problem;
  OpenFile file(dir / "a", OpenFile::Mode::kCreate, problem);
  ASSERT_FALSE(problem);
  EXPECT_FALSE(file.write("hello", 5));
  EXPECT_EQ(file.seek(1, SEEK_SET), 1);
  char text[8] = {};
  EXPECT_EQ(file.read(text, 7, problem), 4u);
  EXPECT_STREQ(text, "ello");
  std::uintmax_t bytes = 0;
  EXPECT_EQ(file.kind(bytes, problem), fs::file_type::regular);
  EXPECT_EQ(bytes, 5u);
  EXPECT_FALSE(file.sync());
  EXPECT_FALSE(file.close());
  EXPECT_FALSE(file.is_open());
}

TEST(OpenFile, taken_name_is_refused_and_kept) {
  const TempDir dir;
  std::ofstream(dir / "a") << "old";
  for (const auto mode : {OpenFile::Mode::kCreate, OpenFile::Mode::kAppend}) {
    std::error_code problem;
    EXPECT_FALSE(OpenFile(dir / "a", mode, problem).is_open());
    EXPECT_EQ(problem, std::errc::file_exists);
  }
  EXPECT_EQ(file_bytes(dir / "a"), "old");
}

TEST(OpenFile, appended_bytes_go_to_the_end) {
  const TempDir dir;
  std::error_code problem;
  OpenFile file(dir / "a", OpenFile::Mode::kAppend, problem);
  EXPECT_FALSE(file.write("one", 3));
  std::ofstream(dir / "a", std::ios::app) << "two";
  EXPECT_FALSE(file.write("three", 5));
  EXPECT_EQ(file_bytes(dir / "a"), "onetwothree");
}

TEST(OpenFile, open_for_reading_cannot_be_written) {
  const TempDir dir;
  std::ofstream(dir / "a") << "old";
  std::error_code problem;
  OpenFile file(dir / "a", OpenFile::Mode::kRead, problem);
  EXPECT_FALSE(problem);
  EXPECT_EQ(file.write("new", 3), std::errc::bad_file_descriptor);
}

TEST(OpenFile, detects_whether_its_name_leads_to_it) {
  const TempDir dir;
  std::error_code problem;
  const OpenFile file(dir / "a", OpenFile::Mode::kAppend, problem);
  EXPECT_TRUE(file.is_at(dir / "a"));
  fs::rename(dir / "a", dir / "b");
  std::ofstream(dir / "a") << "another";
  EXPECT_FALSE(file.is_at(dir / "a"));
  EXPECT_TRUE(file.is_at(dir / "b"));
}

TEST(OpenFile, renewed_file_has_changed_now) {
  const TempDir dir;
  std::error_code problem;
  const OpenFile file(dir / "a", OpenFile::Mode::kAppend, problem);
  const auto long_ago = fs::last_write_time(dir / "a") - std::chrono::hours(1);
  fs::last_write_time(dir / "a", long_ago);
  file.renew();
  EXPECT_GT(fs::last_write_time(dir / "a"), long_ago + std::chrono::minutes(30));
}

TEST(Sync, missing_file_and_folder_are_named) {
  const TempDir dir;
  EXPECT_NO_THROW(platform::sync_folder(dir.path()));
  EXPECT_NO_THROW(platform::sync_folder(""));
  for (const auto& sync : {platform::sync_file, platform::sync_folder})
    EXPECT_EQ(error_message([&] { sync(dir / "none"); }),
              (dir / "none").string() + ": cannot be written to the disk (No such file or directory)");
}

TEST(RemoveFile, folder_stays) {
  const TempDir dir;
  fs::create_directory(dir / "folder");
  std::ofstream(dir / "file") << "a";
  platform::remove_file(dir / "folder");
  platform::remove_file(dir / "file");
  EXPECT_TRUE(fs::exists(dir / "folder"));
  EXPECT_FALSE(fs::exists(dir / "file"));
}

TEST(MakeUnique, names_differ_and_others_cannot_read) {
  const TempDir dir;
  std::error_code problem;
  const fs::path one = platform::make_unique_file(dir / "a-", problem), two = platform::make_unique_file(dir / "a-", problem);
  const fs::path folder = platform::make_unique_folder(dir / "a-", problem);
  EXPECT_FALSE(problem);
  EXPECT_NE(one, two);
  EXPECT_TRUE(fs::is_directory(folder));
  for (const fs::path& made : {one, two, folder})
    EXPECT_EQ(fs::status(made).permissions() & (fs::perms::group_all | fs::perms::others_all), fs::perms::none);
  platform::make_unique_file(dir / "none" / "a-", problem);
  EXPECT_EQ(problem, std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace lippmann::test
