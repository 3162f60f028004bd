#include "core/loaded_module.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "core/platform.hpp"
#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

TEST(LoadedModule, library_finds_modules_beside_itself) {
  const test::TempDir dir;
  fs::copy_file(LIPPMANN_LOADED_MODULE_LIBRARY, dir / "_core.cpython-311.so");
  std::string problem;
  void* library = platform::load_library(dir / "_core.cpython-311.so", problem);
  ASSERT_NE(library, nullptr) << problem;
  auto* is_installed = reinterpret_cast<bool (*)(const char*)>(platform::find_symbol(library, "is_installed_for_library"));
  ASSERT_NE(is_installed, nullptr);
  EXPECT_FALSE(is_installed("libsought.so"));
  std::ofstream(dir / "libsought.so") << "a module";
  EXPECT_TRUE(is_installed("libsought.so"));
}

}  // namespace
}  // namespace lippmann
