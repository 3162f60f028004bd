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

/// Loads a copy of the library at `path`. Returns its function that tests whether a module is installed.
bool (*loaded_at(const fs::path& path))(const char*) {
  fs::create_directories(path.parent_path());
  fs::copy_file(LIPPMANN_LOADED_MODULE_LIBRARY, path);
  std::string problem;
  void* library = platform::load_library(path, problem);
  EXPECT_NE(library, nullptr) << problem;
  return reinterpret_cast<bool (*)(const char*)>(platform::find_symbol(library, "is_installed_for_library"));
}

TEST(LoadedModule, library_finds_modules_beside_itself) {
  const test::TempDir dir;
  auto* is_installed = loaded_at(dir / "_core.cpython-311.so");
  ASSERT_NE(is_installed, nullptr);
  EXPECT_FALSE(is_installed("libsought.so"));
  std::ofstream(dir / "libsought.so") << "a module";
  EXPECT_TRUE(is_installed("libsought.so"));
}

TEST(LoadedModule, python_package_finds_installed_modules) {
  const test::TempDir dir;
  auto* is_installed = loaded_at(dir / "usr/lib/python3.11/dist-packages/lippmann/_core.cpython-311.so");
  ASSERT_NE(is_installed, nullptr);
  EXPECT_FALSE(is_installed("libsought.so"));
  fs::create_directories(dir / "usr/lib/lippmann");
  std::ofstream(dir / "usr/lib/lippmann/libsought.so") << "a module";
  EXPECT_TRUE(is_installed("libsought.so"));
}

}  // namespace
}  // namespace lippmann
