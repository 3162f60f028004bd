// A reader of this project for light field metadata or pictures must throw Error, or return a result that stays the same when
// it is written and read again. The first byte selects the reader:
//   'h' HCI's parameters.cfg
//   'H' attributes of HCI's HDF5 files
//   'v' cvkit's NAME_param.txt
//   'e' the JSON file of an ESLF picture
//   'm' MIV's cameras.json
//   't' NeRF's transforms.json
//   'a', 'i' and 'd' COLMAP's cameras, images and points as text, 'A', 'I' and 'D' as binary files
//   'l' LLFF's poses_bounds.npy
//   'n' any .npy file
//   'q' the JSON file of a quilt
//   's' the JSON file of a folder of views
//   'p' PPM
//   'f' PFM
//   'k' the value of --keep
//   'c' the value of --crop
//   'w' the JSON file of a raw plenoptic picture
//   'L' a Lytro container
//   'r' the metadata (JSON) of a raw Lytro picture
//
// fuzz/light_field_seeds SEEDS && fuzz_light_field -dict=fuzz/light_field.dict CORPUS SEEDS; or scripts/fuzz light_field.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>

#include "core/json_text.hpp"
#include "core/npy.hpp"
#include "formats/colmap_model.hpp"
#include "formats/cvkit_camera.hpp"
#include "formats/eslf_side_file.hpp"
#include "formats/hci_hdf5_cameras.hpp"
#include "formats/hci_parameters.hpp"
#include "formats/lens_grid_file.hpp"
#include "formats/llff_poses.hpp"
#include "formats/lytro_raw.hpp"
#include "formats/miv_cameras.hpp"
#include "formats/quilt_side_file.hpp"
#include "formats/transforms_json.hpp"
#include "formats/views_side_file.hpp"
#include "image/netpbm.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/subset.hpp"

namespace {

using namespace lippmann;

void require(bool holds) {
  if (!holds) std::abort();
}

void views_side_file(const std::string& text) {
  const std::optional<ViewsSideFile> side = parse_views_side_file(text, "a");
  if (!side) return;
  const std::string again = views_side_text(*side);
  require(views_side_text(*parse_views_side_file(again, "a")) == again);
}

void hci(const std::string& text) {
  const HciParameters parameters = parse_hci_parameters(text, "a");
  require(std::isfinite(hci_disparity_px(parameters, INFINITY)) && std::isfinite(hci_disparity_px(parameters, 1.0)));
  require(hci_cameras(parameters).eyes_mm.size() == static_cast<std::size_t>(parameters.columns * parameters.rows));
  const std::string again = hci_parameters_text(parameters);
  require(hci_parameters_text(parse_hci_parameters(again, "a")) == again);
}

/// Passes numbers as HDF5 attributes, without the HDF5 library.
void hdf5_cameras(std::span<const std::byte> numbers) {
  constexpr std::array kNames{"dH", "dV", "focalLength", "shift"};
  std::map<std::string, double> attributes;
  LightField field;
  field.grid = {3, 2}, field.view_size = {4, 3};
  for (std::size_t i = 0; i < kNames.size() && numbers.size() >= 8; ++i, numbers = numbers.subspan(8))
    std::memcpy(&attributes[kNames[i]], numbers.data(), 8);
  if (!set_hdf5_cameras(attributes, field, "a")) return;
  require(field.cameras.has_value() != field.poses.has_value());
  for (const float depth : {0.0f, 1e-6f, 1.0f, 1e8f, INFINITY}) require(!std::isnan(z_of_hdf5_depth(depth, field)));
  for (const PosedCamera& camera : posed_cameras(field, "a"))
    require(std::isfinite(camera.focal_px.x + camera.principal_px.x + camera.principal_px.y + camera.position_mm.x));
}

void cvkit(const std::string& text) {
  const CvkitCamera camera = parse_cvkit_camera(text, "a");
  LightField field;
  set_cameras({camera.camera, camera.camera}, field);
  const std::string again = cvkit_camera_text(camera);
  require(cvkit_camera_text(parse_cvkit_camera(again, "a")) == again);
}

void eslf(const std::string& text) {
  const std::optional<EslfSideFile> side = parse_eslf_side_file(text, "a");
  if (!side) return;
  const std::string again = eslf_side_text(*side);
  require(eslf_side_text(parse_eslf_side_file(again, "a").value()) == again);
}

void miv(const std::string& text) {
  const std::vector<MivCamera> cameras = parse_miv_cameras(text, "a");
  if (cameras.empty()) return;
  LightField field;
  set_cameras(cameras, field);
  require(field.cameras.has_value() != field.poses.has_value());
  warn_of_missing_cameras(cameras, "a", {.warn = [](std::string_view) {}});
  const std::string again = miv_cameras_text(cameras, "a", true);
  require(miv_cameras_text(parse_miv_cameras(again, "a"), "a", true) == again);
}

/// Adds the values that writing requires, and then writes and reads the cameras.
void transforms(const std::string& text) {
  std::vector<PosedPicture> pictures = parse_transforms(text, "a");
  for (PosedPicture& picture : pictures) {
    picture.camera.size = glm::max(picture.camera.size, Vec2i(1));
    picture.camera.focal_px = glm::max(picture.camera.focal_px, Vec2d(1e-3));
    if (!picture.depth.ends_with(".npy")) picture.depth.clear();
  }
  shared_plane({pictures.front().camera});
  const std::vector<PosedPicture> again = parse_transforms(transforms_text(pictures), "a");
  require(again.size() == pictures.size() && again.front().split == pictures.front().split);
}

void transforms_error(const std::string& text) {
  if (json_from_text(text).is_discarded()) require(!json_error(text, "a").problem().empty());
}

template <class Text>
void colmap_cameras(const Text& text) {
  PosedPicture picture;
  picture.picture = "a.png";
  for (const auto& [id, camera] : parse_colmap_cameras(text, "a")) {
    picture.camera = camera;
    require(parse_colmap_cameras(colmap_cameras_text({picture}), "a").at(1).focal_px == camera.focal_px);
    const std::string binary = colmap_cameras_binary({picture});
    require(parse_colmap_cameras(std::as_bytes(std::span(binary)), "a").at(1).focal_px == camera.focal_px);
  }
}

template <class Text>
void colmap_images(const Text& text) {
  const ColmapCameras cameras = parse_colmap_cameras("1 PINHOLE 4 3 5 5 2 1", "a");
  const std::vector<PosedPicture> pictures = parse_colmap_images(text, cameras, "a");
  require(parse_colmap_images(colmap_images_text(pictures), cameras, "a").size() == pictures.size());
  const std::string binary = colmap_images_binary(pictures);
  require(parse_colmap_images(std::as_bytes(std::span(binary)), cameras, "a").size() == pictures.size());
}

template <class Text>
void colmap_points(const Text& text) {
  const std::vector<CloudPoint> points = parse_colmap_points(text, "a").points;
  require(parse_colmap_points(colmap_points_text(points), "a").points.size() == points.size());
  const std::string binary = colmap_points_binary(points);
  require(parse_colmap_points(std::as_bytes(std::span(binary)), "a").points.size() == points.size());
}

void llff(std::span<const std::byte> file) {
  std::vector<PosedCamera> cameras;
  std::vector<Vec2d> bounds_mm;
  for (const PosedPicture& picture : parse_llff_poses(file, "a")) {
    cameras.push_back(picture.camera);
    bounds_mm.push_back(picture.depth_bounds_mm.value());
  }
  require(parse_llff_poses(encode_llff_poses(cameras, bounds_mm, "a"), "a").size() == cameras.size());
}

void npy(std::span<const std::byte> file) {
  const NpyArray array = parse_npy(file, "a");
  if (array.shape.empty()) return;  // a number without dimensions cannot be written as an array
  const NpyArray again = parse_npy(encode_npy(std::span<const double>(array.values), array.shape), "a");
  require(again.shape == array.shape && again.values.size() == array.values.size());
  for (std::size_t i = 0; i < array.values.size(); ++i)
    require(std::bit_cast<std::uint64_t>(again.values[i]) == std::bit_cast<std::uint64_t>(array.values[i]));
}

void ppm(std::span<const std::byte> file) {
  const PpmCodes picture = parse_ppm(file, "a");
  require(parse_ppm(encode_ppm(picture), "a").codes.rgb == picture.codes.rgb);
}

void pfm(std::span<const std::byte> file) {
  const Image picture = parse_pfm(file, "a");
  require(encode_pfm(parse_pfm(encode_pfm(picture), "a")).size() == encode_pfm(picture).size());
}

void lens_grid(const std::string& text) {
  const std::optional<LensGrid> grid = parse_lens_grid(text, "a");
  if (!grid) return;
  const auto text_of = [](const LensGrid& of) { return nlohmann::ordered_json{{"plenoptic", lens_grid_json(of)}}.dump(); };
  const LensGrid again = *parse_lens_grid(text_of(*grid), "a");
  require(again.pitch_px == grid->pitch_px && std::abs(again.rotation - grid->rotation) < 1e-9);
}

void lytro(const LytroRaw& raw) {
  require(raw.light.data.size() == 3 * static_cast<std::size_t>(raw.light.width * raw.light.height));
  require(developed(raw).rgb.size() == raw.light.data.size() && raw.grid.pitch_px > 0.0);
}

void read(char kind, const std::string& text) {
  switch (kind) {
    case 'h':
      return hci(text);
    case 'H':
      return hdf5_cameras(std::as_bytes(std::span(text)));
    case 'm':
      return miv(text);
    case 'v':
      return cvkit(text);
    case 'e':
      return eslf(text);
    case 't':
      transforms_error(text);
      return transforms(text);
    case 'a':
      return colmap_cameras(text);
    case 'i':
      return colmap_images(text);
    case 'A':
      return colmap_cameras(std::as_bytes(std::span(text)));
    case 'I':
      return colmap_images(std::as_bytes(std::span(text)));
    case 'd':
      return colmap_points(text);
    case 'D':
      return colmap_points(std::as_bytes(std::span(text)));
    case 'l':
      return llff(std::as_bytes(std::span(text)));
    case 'n':
      return npy(std::as_bytes(std::span(text)));
    case 'q':
      parse_quilt_side_file(text, "a");
      return;
    case 's':
      return views_side_file(text);
    case 'p':
      return ppm(std::as_bytes(std::span(text)));
    case 'f':
      return pfm(std::as_bytes(std::span(text)));
    case 'w':
      return lens_grid(text);
    case 'L':
      return lytro(parse_lfr(std::as_bytes(std::span(text)), "a"));
    case 'r': {
      constexpr std::array<std::byte, 384> kCodes{};
      return lytro(parse_lytro(kCodes, text, "a"));
    }
    case 'k':
      read_kept_views(text, "--keep");
      return;
    case 'c':
      read_crop(text, "--crop");
      return;
    default:
      return;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size < 1) return 0;
  const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
  try {
    read(static_cast<char>(data[0]), text);
  } catch (const Error&) {
  }
  return 0;
}
