#include "folder/journal_writer.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "core/platform.hpp"
#include "folder/journal_part.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

fs::path only_file_in(const fs::path& folder) { return fs::directory_iterator(folder)->path(); }

class Writing {
 public:
  explicit Writing(const fs::path& folder) {
    int begun[2];
    EXPECT_EQ(pipe(begun), 0);
    process_ = fork();
    if (process_ == 0) {
      std::signal(SIGINT, [](int) { _exit(7); });
      const JournalPart part(folder, "job");
      (void)!write(begun[1], "x", 1);
      while (true) pause();
    }
    char byte = 0;
    EXPECT_EQ(read(begun[0], &byte, 1), 1);
    close(begun[0]), close(begun[1]);
  }
  ~Writing() {
    if (process_ > 0) kill(process_, SIGKILL), waitpid(process_, nullptr, 0);
  }
  Writing(const Writing&) = delete;
  Writing& operator=(const Writing&) = delete;

  void kill_it() {
    kill(process_, SIGKILL);
    wait();
  }
  int wait() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  pid_t process_ = 0;
};

TEST(JournalWriter, names_of_parts_state_the_writer) {
  const auto writer = writer_of("/a/01764104700-" + platform::host_name() + "-4321.jsonl");
  ASSERT_TRUE(writer);
  EXPECT_TRUE(writer->is_of_this_machine());
  EXPECT_EQ(writer->process, 4321);
  EXPECT_EQ(writer->began, 1764104700.0);
  // The suffix -2 marks the second journal that a process began in the same second.
  EXPECT_EQ(writer_of("01764104700-" + platform::host_name() + "-4321-2.jsonl")->process, 4321);
}

TEST(JournalWriter, names_of_other_machines_may_have_dashes) {
  const auto writer = writer_of("01764104700-farm-node-7-4321.jsonl");
  ASSERT_TRUE(writer);
  EXPECT_EQ(writer->host, "farm-node-7");
  EXPECT_EQ(writer->process, 4321);
  EXPECT_FALSE(writer->is_of_this_machine());
  for (const char* name : {"1.jsonl", "a-b-1.jsonl", "01764104700-b-1.json", "01764104700-b-.jsonl", ""})
    EXPECT_FALSE(writer_of(name)) << name;
}

TEST(JournalWriter, part_is_live_until_its_process_ends) {
  const test::TempDir dir;
  Writing writing(dir.path());
  EXPECT_TRUE(is_being_written(only_file_in(dir.path())));
  writing.kill_it();
  EXPECT_FALSE(is_being_written(only_file_in(dir.path())));
  EXPECT_FALSE(interrupt_writer(only_file_in(dir.path())));
}

TEST(JournalWriter, interrupting_does_what_ctrl_c_does) {
  const test::TempDir dir;
  Writing writing(dir.path());
  EXPECT_TRUE(interrupt_writer(only_file_in(dir.path())));
  EXPECT_EQ(writing.wait(), 7);
}

// The journal's name has the id of this process, as if the id were reused. Only a process that has the file open is its
// writer.
TEST(JournalWriter, reused_process_ids_are_not_writers) {
  const test::TempDir dir;
  const fs::path part = dir / ("01764104700-" + platform::host_name() + "-" + std::to_string(getpid()) + ".jsonl");
  std::ofstream(part) << "{}\n";
  std::signal(SIGINT, [](int) { std::_Exit(1); });
  EXPECT_FALSE(is_being_written(part));
  const std::ifstream reading(part);
  EXPECT_FALSE(is_being_written(part));
  EXPECT_FALSE(interrupt_writer(part));
  const std::ofstream writing(part, std::ios::app);
  EXPECT_TRUE(is_being_written(part));
  std::signal(SIGINT, SIG_DFL);
}

}  // namespace
}  // namespace lippmann
