#include "display/find_calibrations.hpp"

#include <gmock/gmock.h>

#include <fstream>

#include "support/temp_dir.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;
using test::TempDir;
using testing::ElementsAre;
using testing::IsEmpty;

void touch(const fs::path& file) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << "{}";
}

TEST(FindCalibrations, drives_are_found_in_order) {
  const TempDir dir;
  touch(dir / "media/me/LKG2/LKG_calibration/visual.json");
  touch(dir / "media/LKG1/LKG_calibration/visual.json");
  touch(dir / "Volumes/DISPLAY/visual.json");
  EXPECT_THAT(find_calibrations({dir / "media", dir / "nowhere", dir / "Volumes"}),
              ElementsAre(dir / "Volumes/DISPLAY/visual.json", dir / "media/LKG1/LKG_calibration/visual.json",
                          dir / "media/me/LKG2/LKG_calibration/visual.json"));
}

TEST(FindCalibrations, subfolders_of_drives_are_not_searched) {
  const TempDir dir;
  touch(dir / "media/me/disk/folder/visual.json");
  touch(dir / "media/me/disk/other.json");
  EXPECT_THAT(find_calibrations({dir / "media"}), IsEmpty());
}

}  // namespace
}  // namespace lippmann
