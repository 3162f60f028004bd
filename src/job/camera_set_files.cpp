#include "job/camera_set_files.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/folder.hpp"
#include "layout/colmap_model.hpp"
#include "layout/llff_poses.hpp"
#include "layout/transforms_json.hpp"
#include "lippmann/core/error.hpp"
#include "optics/optics_kind.hpp"
#include "stage/camera_set.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

/// Returns the pictures and cameras of the finished frames. Paths are relative to the folder.
std::vector<PosedPicture> pictures_of(const RenderSetup& setup, const FolderJournal& journal) {
  const int count = setup.stage.scene.timeline.frame_count;
  const char* ending = setup.layout.format() == PictureFormat::kExr ? "exr" : "png";
  std::vector<PosedPicture> pictures;
  for (const auto& [frame, record] : journal.frames) {
    const Affine3f world_from_display = setup.stage.moment_at(frame).world_from_display;
    PosedPicture picture;
    picture.picture = posed_picture_name(frame, count, ending);
    picture.depth = posed_depth_name(frame, count);
    picture.camera = camera_in_world(setup.optics(), world_from_display, setup.stage.scene.origin);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

std::vector<bool> tests_of(const RenderSetup& setup, const FolderJournal& journal) {
  const std::vector<bool> of_all = test_cameras(setup.stage.scene.timeline.frame_count, setup.job.sampling().seed);
  std::vector<bool> tests;
  for (const auto& [frame, record] : journal.frames) tests.push_back(of_all[static_cast<std::size_t>(frame)]);
  return tests;
}

std::vector<PosedPicture> part_of(const std::vector<PosedPicture>& pictures, const std::vector<bool>& is_test, bool test) {
  std::vector<PosedPicture> part;
  for (std::size_t i = 0; i < pictures.size(); ++i)
    if (is_test[i] == test) part.push_back(pictures[i]);
  return part;
}

std::string names_of_tests(const std::vector<PosedPicture>& pictures, const std::vector<bool>& is_test) {
  std::string names;
  for (const PosedPicture& picture : part_of(pictures, is_test, true))
    names += fs::path(picture.picture).filename().string() + '\n';
  return names;
}

void write_nerf_set(const RenderSetup& setup, RenderFolder& folder) {
  const auto write = [&](const char* name, std::optional<bool> test) {
    folder.write(name, [&](const FolderJournal& journal) {
      const std::vector<PosedPicture> all = pictures_of(setup, journal);
      const std::vector<bool> is_test = tests_of(setup, journal);
      if (test) return transforms_text(part_of(all, is_test, *test));
      return transforms_text(all, is_test);
    });
  };
  const std::vector<bool> tests = tests_of(setup, folder.now());
  const bool has_tests = std::find(tests.begin(), tests.end(), true) != tests.end();
  const bool has_training = std::find(tests.begin(), tests.end(), false) != tests.end();
  if (has_training) write("transforms_train.json", false);
  if (has_tests) write("transforms_test.json", true);
  write("transforms.json", std::nullopt);
}

void write_colmap_set(const RenderSetup& setup, RenderFolder& folder) {
  constexpr std::size_t kMostPoints = 100000;
  make_folder(folder.path() / "sparse" / "0");
  const auto write = [&](const char* name, const auto& text_of) {
    folder.write(name, [&](const FolderJournal& journal) {
      std::vector<PosedPicture> pictures = pictures_of(setup, journal);
      return text_of(pictures, journal);
    });
  };
  const auto named = [](std::vector<PosedPicture> pictures) {
    for (PosedPicture& picture : pictures) picture.picture = fs::path(picture.picture).filename().string();
    return pictures;
  };
  write("sparse/0/cameras.txt", [](const auto& pictures, const FolderJournal&) { return colmap_cameras_text(pictures); });
  write("sparse/0/images.txt", [&](const auto& pictures, const FolderJournal&) { return colmap_images_text(named(pictures)); });
  write("sparse/0/test.txt",
        [&](const auto& pictures, const FolderJournal& journal) { return names_of_tests(pictures, tests_of(setup, journal)); });
  write("sparse/0/points3D.txt", [&](const auto& pictures, const FolderJournal&) {
    return colmap_points_text(cloud_of_pictures(folder.path(), pictures, kMostPoints));
  });
}

void write_llff_set(const RenderSetup& setup, RenderFolder& folder) {
  folder.write("poses_bounds.npy", [&](const FolderJournal& journal) {
    const std::vector<PosedPicture> pictures = pictures_of(setup, journal);
    std::vector<PosedCamera> cameras;
    for (const PosedPicture& picture : pictures) cameras.push_back(picture.camera);
    const std::vector<std::byte> bytes =
        encode_llff_poses(cameras, depth_bounds_of_pictures(folder.path(), pictures), folder.path().string());
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  });
  folder.write("test.txt", [&](const FolderJournal& journal) {
    return names_of_tests(pictures_of(setup, journal), tests_of(setup, journal));
  });
}

}  // namespace

void complete_camera_set(RenderParams& params) {
  if (!params.scene.cameras) return;
  PictureParams& pictures = params.output.pictures;
  if (!params.optics.display.empty() || (params.optics.kind && *params.optics.kind != OpticsKind::kSingle))
    throw usage_error("cameras", "renders a single view for each camera", "`optics` single, without `display`");
  if (pictures.layout) throw usage_error("cameras", "cannot be combined with `layout`", "`to` nerf, colmap or llff");
  if (!params.output.video.empty())
    throw usage_error("cameras", "cannot be combined with `video`", "'lippmann encode DIR FILE' after the render");
  params.optics.kind = OpticsKind::kSingle;
  if (pictures.to.empty()) pictures.to = "nerf";
  constexpr std::array kFormats{"nerf", "colmap", "llff"};
  if (std::find(kFormats.begin(), kFormats.end(), pictures.to) == kFormats.end())
    throw usage_error("cameras", "cannot be written in the format " + pictures.to, "`to` nerf, colmap or llff");
}

void write_camera_set_files(const RenderSetup& setup, RenderFolder& folder) {
  if (!setup.job.scene().cameras || folder.now().frames.empty()) return;
  const std::string& to = setup.job.output().pictures.to;
  if (to == "nerf") return write_nerf_set(setup, folder);
  if (to == "colmap") return write_colmap_set(setup, folder);
  write_llff_set(setup, folder);
}

}  // namespace lippmann
