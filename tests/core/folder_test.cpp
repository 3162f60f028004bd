#include "core/folder.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <optional>

#include "support/error_message.hpp"
#include "support/temp_dir.hpp"

namespace lippmann::test {
namespace {

namespace fs = std::filesystem;

TEST(NewFolder, folders_that_stay_empty_are_removed) {
  const TempDir dir;
  std::optional<NewFolder> folder(std::in_place, dir / "a/b/c");
  EXPECT_TRUE(fs::is_directory(dir / "a/b/c"));
  folder.reset();
  EXPECT_FALSE(fs::exists(dir / "a"));
}

TEST(NewFolder, folders_with_results_stay) {
  const TempDir dir;
  std::optional<NewFolder> folder(std::in_place, dir / "a/b/c");
  std::ofstream(dir / "a/b/result.txt") << "result";
  folder.reset();
  EXPECT_TRUE(fs::exists(dir / "a/b/result.txt"));
  EXPECT_FALSE(fs::exists(dir / "a/b/c"));
}

TEST(NewFolder, an_existing_empty_folder_stays) {
  const TempDir dir;
  fs::create_directory(dir / "a");
  { const NewFolder folder(dir / "a"); }
  EXPECT_TRUE(fs::is_directory(dir / "a"));
}

TEST(NewFolder, failure_names_the_folder) {
  const TempDir dir;
  std::ofstream(dir / "file") << "in the way";
  EXPECT_THAT(error_message([&] { NewFolder(dir / "file/a"); }),
              testing::AllOf(testing::HasSubstr("file/a"), testing::HasSubstr("cannot be made")));
  EXPECT_TRUE(fs::is_regular_file(dir / "file"));
}

}  // namespace
}  // namespace lippmann::test
