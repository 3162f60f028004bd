// The library must contain the page that web/ builds, and the page must be small.
#include "view/page_files.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "support/command.hpp"

namespace lippmann {
namespace {

TEST(PageFiles, equal_the_repositorys_and_are_small) {
  ASSERT_EQ(page_files().size(), 3u);
  EXPECT_EQ(page_files().front().name, "index.html");
  std::size_t bytes = 0;
  for (const PageFile& file : page_files()) {
    std::ifstream stream(LIPPMANN_SOURCE "/web/dist/" + std::string(file.name), std::ios::binary);
    EXPECT_EQ(file.text, (std::string{std::istreambuf_iterator<char>(stream), {}})) << file.name;
    bytes += file.text.size();
  }
  EXPECT_LT(bytes, 1u << 20);
}

TEST(PageFiles, built_page_belongs_to_its_sources) {
  if (!test::program_exists("node")) GTEST_SKIP() << "node is not installed";
  const test::CommandResult checked = test::run_command("node " LIPPMANN_SOURCE "/web/stamp.mjs");
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
}

TEST(PageFiles, page_loads_nothing_from_elsewhere) {
  for (const PageFile& file : page_files())
    for (const char* from : {"https://", "//cdn", "@import"})
      EXPECT_THAT(std::string(file.text), testing::Not(testing::HasSubstr(from))) << file.name;
}

}  // namespace
}  // namespace lippmann
