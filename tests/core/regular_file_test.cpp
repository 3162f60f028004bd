#include "core/regular_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

using test::error_message;
using test::TempDir;
using ::testing::HasSubstr;

// Opening a FIFO blocks until another process opens it.
TEST(RegularFile, everything_else_is_refused_without_waiting) {
  const TempDir dir;
  ASSERT_EQ(mkfifo((dir / "fifo").c_str(), 0600), 0);
  std::filesystem::create_symlink(dir / "fifo", dir / "link");
  EXPECT_EQ(RegularFile(dir / "fifo").problem(), "is not a regular file but a FIFO");
  EXPECT_EQ(RegularFile(dir / "link").problem(), "is not a regular file but a FIFO");
  EXPECT_EQ(RegularFile(dir.path()).problem(), "is not a regular file but a folder");
  EXPECT_EQ(RegularFile("/dev/zero").problem(), "is not a regular file but a device");
  EXPECT_EQ(RegularFile(dir / "none").problem(), "does not exist");
  EXPECT_TRUE(RegularFile(dir / "fifo").exists());
  EXPECT_FALSE(RegularFile(dir / "none").exists());
  EXPECT_EQ(read_file_begin(dir / "fifo", 10), "");
  EXPECT_THAT(error_message([&] { read_file_text(dir / "fifo", 10, "a job"); }),
              HasSubstr("fifo: is not a regular file but a FIFO; accepted: a job"));
  EXPECT_THAT(error_message([&] { require_regular_file(dir / "none"); }), HasSubstr("none: there is no such file"));
}

TEST(RegularFile, is_read_whole_within_a_limit) {
  const TempDir dir;
  std::ofstream(dir / "a") << "hello";
  EXPECT_EQ(read_file_text(dir / "a", 5), "hello");
  EXPECT_EQ(read_file_bytes(dir / "a", 5).size(), 5u);
  EXPECT_EQ(read_file_begin(dir / "a", 2), "he");
  EXPECT_EQ(read_file_begin(dir / "a", 100), "hello");
  EXPECT_THAT(error_message([&] { read_file_text(dir / "a", 4, "a job"); }),
              HasSubstr("a: is too large: 5 bytes; accepted: a job of at most 4 bytes"));
}

TEST(RegularFile, reads_on_from_where_it_stopped) {
  const TempDir dir;
  std::ofstream(dir / "a") << "hello";
  RegularFile file(dir / "a");
  char text[8] = {};
  EXPECT_EQ(file.size(), 5u);
  EXPECT_EQ(file.read(text, 2), 2u);
  EXPECT_EQ(file.read(text + 2, 6), 3u);
  EXPECT_STREQ(text, "hello");
  EXPECT_EQ(file.problem(), "");
}

}  // namespace
}  // namespace lippmann
