#include "core/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "core/platform.hpp"
#include "lippmann/core/error.hpp"
#include "support/error_message.hpp"
#include "support/file_size_limit.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::error_message;
using test::FileSizeLimit;
using test::TempDir;
using ::testing::HasSubstr;

std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

std::string contents(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(AtomicFile, temporary_path_is_hidden_beside_the_file) {
  const TempDir dir;
  const AtomicFile file(dir / "frame_0001.png");
  EXPECT_EQ(file.temporary_path().parent_path(), dir.path());
  EXPECT_EQ(file.temporary_path().extension(), ".png");
  EXPECT_TRUE(file.temporary_path().filename().string().starts_with(".frame_0001.tmp-"));
}

TEST(AtomicFile, two_of_one_name_write_separate_files) {
  const TempDir dir;
  AtomicFile first(dir / "a.txt"), second(dir / "a.txt");
  std::ofstream(first.temporary_path()) << "first";
  std::ofstream(second.temporary_path()) << "second";
  first.commit();
  EXPECT_EQ(contents(dir / "a.txt"), "first");
  second.commit();
  EXPECT_EQ(contents(dir / "a.txt"), "second");
}

TEST(AtomicFile, destroyed_without_commit_leaves_nothing) {
  const TempDir dir;
  {
    const AtomicFile file(dir / "a.txt");
    std::ofstream(file.temporary_path()) << "half";
    ASSERT_TRUE(fs::exists(file.temporary_path()));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(AtomicFile, destroyed_without_commit_keeps_the_previous_file) {
  const TempDir dir;
  write_file_atomically(dir / "a.txt", bytes_of("old"));
  { std::ofstream(AtomicFile(dir / "a.txt").temporary_path()) << "half"; }
  EXPECT_EQ(contents(dir / "a.txt"), "old");
}

TEST(AtomicFile, commit_of_an_unwritten_file_is_an_error) {
  const TempDir dir;
  AtomicFile file(dir / "a.txt");
  EXPECT_THROW(file.commit(), Error);
}

TEST(WriteFileAtomically, existing_file_is_replaced) {
  const TempDir dir;
  write_file_atomically(dir / "a.txt", bytes_of("old and long"));
  write_file_atomically(dir / "a.txt", bytes_of("new"));
  EXPECT_EQ(contents(dir / "a.txt"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(dir.path()), {}), 1);
}

TEST(WriteFileAtomically, missing_folder_is_named) {
  const TempDir dir;
  EXPECT_THAT(error_message([&] { write_file_atomically(dir / "no/a.txt", bytes_of("x")); }), HasSubstr("there is no folder"));
}

TEST(WriteFileAtomically, name_of_a_folder_is_refused) {
  const TempDir dir;
  fs::create_directory(dir / "a.png");
  EXPECT_THAT(error_message([&] { write_file_atomically(dir / "a.png", bytes_of("x")); }), HasSubstr("not a regular file"));
}

TEST(WriteFileAtomically, full_disk_names_the_file_and_leaves_nothing) {
  const TempDir dir;
  const std::string text(100000, 'x');
  {
    const FileSizeLimit full(4096);
    const std::string message = error_message([&] { write_file_atomically(dir / "a.txt", bytes_of(text)); });
    EXPECT_THAT(message, HasSubstr("a.txt: cannot be written"));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

pid_t ended_process() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

TEST(StaleTemporaries, only_those_of_ended_processes_are_removed) {
  const TempDir dir;
  const std::string here = "-" + platform::host_name() + "-0123abcd", ended = std::to_string(ended_process()) + here,
                    elsewhere = std::to_string(ended_process()) + "-" + platform::host_name() + "x-0123abcd",
                    alive = std::to_string(getpid()) + here;
  const std::vector<std::string> stale{".frame_0003.tmp-" + ended + ".png", "..journal.tmp-" + ended + ".jsonl"},
      others{".frame_0004.tmp-" + alive + ".png",
             "frame_0005.tmp-" + ended + ".png",
             ".frame_0006.tmp-" + elsewhere + ".png",
             ".frame_0007.tmp-.png",
             ".tmp-" + ended + ".png",
             "frame_0001.png"};
  for (const auto* names : {&stale, &others})
    for (const std::string& name : *names) std::ofstream(dir.path() / name) << "half";
  remove_stale_temporaries(dir.path());
  for (const std::string& name : stale) EXPECT_FALSE(fs::exists(dir.path() / name)) << name;
  for (const std::string& name : others) EXPECT_TRUE(fs::exists(dir.path() / name)) << name;
}

TEST(StaleTemporaries, of_one_file_only_are_removed) {
  const TempDir dir;
  const std::string ended = std::to_string(ended_process()) + "-" + platform::host_name() + "-0123abcd";
  for (const char* stem : {"a", "b"})
    std::ofstream(dir.path() / ("." + std::string(stem) + ".tmp-" + ended + ".mp4")) << "half";
  remove_stale_temporaries(dir.path(), "a.mp4");
  EXPECT_FALSE(fs::exists(dir.path() / (".a.tmp-" + ended + ".mp4")));
  EXPECT_TRUE(fs::exists(dir.path() / (".b.tmp-" + ended + ".mp4")));
}

TEST(StaleTemporaries, missing_folder_is_ignored) { EXPECT_NO_THROW(remove_stale_temporaries("/no/such/folder")); }

}  // namespace
}  // namespace lippmann
