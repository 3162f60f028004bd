#include "job/camera_set_files.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/folder.hpp"
#include "formats/colmap_model.hpp"
#include "formats/llff_poses.hpp"
#include "formats/transforms_json.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/stage/camera_set.hpp"
#include "optics/optics_kind.hpp"

namespace lippmann {
namespace {

namespace fs = std::filesystem;

std::vector<PosedPicture> pictures_of(const RenderSetup& setup, const FolderJournal& journal) {
  const int count = setup.stage.scene.timeline.frame_count;
  const std::vector<bool> is_test = test_cameras(count, setup.job.sampling().seed);
  const char* ending = setup.layout.format() == PictureFormat::kExr ? "exr" : "png";
  std::vector<PosedPicture> pictures;
  for (const auto& [frame, record] : journal.frames) {
    const Affine3f world_from_display = setup.stage.moment_at(frame).world_from_display;
    PosedPicture picture;
    picture.picture = posed_picture_name(frame, count, ending);
    picture.depth = posed_depth_name(frame, count);
    picture.split = is_test[static_cast<std::size_t>(frame)] ? Split::kTest : Split::kTraining;
    picture.camera = camera_in_world(setup.optics(), world_from_display, setup.stage.scene.origin);
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

void write_nerf_set(const RenderSetup& setup, RenderFolder& folder) {
  const std::vector<PosedPicture> now = pictures_of(setup, folder.now());
  const auto write_part = [&](const char* name, Split split) {
    if (pictures_of_split(now, split).empty()) return;
    folder.write(name, [&](const FolderJournal& journal) { return split_transforms_text(pictures_of(setup, journal), split); });
  };
  write_part("transforms_train.json", Split::kTraining);
  write_part("transforms_test.json", Split::kTest);
  folder.write("transforms.json", [&](const FolderJournal& journal) { return transforms_text(pictures_of(setup, journal)); });
}

void write_colmap_set(const RenderSetup& setup, RenderFolder& folder) {
  constexpr std::size_t kMostPoints = 100000;
  make_folder(folder.path() / "sparse" / "0");
  const auto write = [&](const char* name, const auto& text_of) {
    folder.write(name, [&](const FolderJournal& journal) { return text_of(pictures_of(setup, journal)); });
  };
  const auto named = [](std::vector<PosedPicture> pictures) {
    for (PosedPicture& picture : pictures) picture.picture = fs::path(picture.picture).filename().string();
    return pictures;
  };
  const auto cloud = [&](const auto& pictures) { return cloud_of_pictures(folder.path(), pictures, kMostPoints); };
  if (setup.job.output().pictures.binary) {
    write("sparse/0/cameras.bin", [](const auto& pictures) { return colmap_cameras_binary(pictures); });
    write("sparse/0/images.bin", [&](const auto& pictures) { return colmap_images_binary(named(pictures)); });
    write("sparse/0/points3D.bin", [&](const auto& pictures) { return colmap_points_binary(cloud(pictures)); });
  } else {
    write("sparse/0/cameras.txt", [](const auto& pictures) { return colmap_cameras_text(pictures); });
    write("sparse/0/images.txt", [&](const auto& pictures) { return colmap_images_text(named(pictures)); });
    write("sparse/0/points3D.txt", [&](const auto& pictures) { return colmap_points_text(cloud(pictures)); });
  }
  write("sparse/0/test.txt", [](const auto& pictures) { return held_out_names(pictures); });
}

void write_llff_set(const RenderSetup& setup, RenderFolder& folder) {
  folder.write("poses_bounds.npy", [&](const FolderJournal& journal) {
    const std::vector<PosedPicture> pictures = pictures_of(setup, journal);
    std::vector<PosedCamera> cameras;
    for (const PosedPicture& picture : pictures) cameras.push_back(picture.camera);
    const std::vector<Vec2d> bounds(pictures.size(), depth_bounds_of_pictures(folder.path(), pictures));
    const std::vector<std::byte> bytes = encode_llff_poses(cameras, bounds, folder.path().string());
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  });
  folder.write("test.txt", [&](const FolderJournal& journal) { return held_out_names(pictures_of(setup, journal)); });
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
