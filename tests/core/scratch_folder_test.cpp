#include "core/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <optional>

#include "lippmann/core/error.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

class OtherTmpdir {
 public:
  explicit OtherTmpdir(const std::string& value) {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    setenv("TMPDIR", value.c_str(), 1);
  }
  ~OtherTmpdir() { before_ ? setenv("TMPDIR", before_->c_str(), 1) : unsetenv("TMPDIR"); }

 private:
  std::optional<std::string> before_;
};

TEST(ScratchFolder, is_in_tmpdir_and_is_removed_completely) {
  const TempDir dir;
  const OtherTmpdir other(dir.path().string());
  {
    const ScratchFolder one, two;
    EXPECT_EQ(one.path().parent_path(), dir.path());
    EXPECT_NE(one.path(), two.path());
    fs::create_directory(one.path() / "a");
    std::ofstream(one.path() / "a/b") << "c";
    EXPECT_TRUE(fs::exists(one.path() / "a/b"));
  }
  EXPECT_TRUE(fs::is_empty(dir.path()));
}

TEST(ScratchFolder, failure_names_tmpdir) {
  const TempDir dir;
  const OtherTmpdir other((dir.path() / "missing").string());
  try {
    const ScratchFolder folder;
    FAIL() << folder.path();
  } catch (const Error& error) {
    EXPECT_EQ(error.where(), "TMPDIR");
    EXPECT_EQ(error.accepted(), "a TMPDIR that can be written");
  }
}

}  // namespace
}  // namespace lippmann::test
