// Feeds bytes to the readers of light fields' side files and pictures that are our own. The first byte says which: 'h' HCI's
// parameters.cfg, 'v' cvkit's NAME_param.txt, 'e' ESLF's side file, 'm' MIV's cameras.json, 'q' a quilt's side file, 'p' PPM,
// 'f' PFM, 'k' --keep, 'c' --crop. Whatever follows, it either throws Error or gives what is written and read again to the
// same.
//
// fuzz/light_field_seeds SEEDS && fuzz_light_field -dict=fuzz/light_field.dict CORPUS SEEDS; or scripts/fuzz light_field.
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>

#include "image/netpbm.hpp"
#include "layout/cvkit_camera.hpp"
#include "layout/eslf_side_file.hpp"
#include "layout/hci_parameters.hpp"
#include "layout/miv_cameras.hpp"
#include "layout/quilt_side_file.hpp"
#include "lippmann/core/error.hpp"
#include "lippmann/layout/subset.hpp"

namespace {

using namespace lippmann;

void require(bool holds) {
  if (!holds) std::abort();
}

void hci(const std::string& text) {
  const HciParameters parameters = parse_hci_parameters(text, "a");
  require(std::isfinite(hci_disparity_px(parameters, INFINITY)) && std::isfinite(hci_disparity_px(parameters, 1.0)));
  require(hci_cameras(parameters).eyes_mm.size() == static_cast<std::size_t>(parameters.columns * parameters.rows));
  const std::string again = hci_parameters_text(parameters);
  require(hci_parameters_text(parse_hci_parameters(again, "a")) == again);
}

void cvkit(const std::string& text) {
  const CvkitCamera camera = parse_cvkit_camera(text, "a");
  cameras_of_miv({camera.camera, camera.camera});
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
  cameras_of_miv(cameras);
  const std::string again = miv_cameras_text(cameras, "a", true);
  require(miv_cameras_text(parse_miv_cameras(again, "a"), "a", true) == again);
}

void ppm(std::span<const std::byte> file) {
  const PpmCodes picture = parse_ppm(file, "a");
  require(parse_ppm(encode_ppm(picture), "a").codes.rgb == picture.codes.rgb);
}

void pfm(std::span<const std::byte> file) {
  const Image picture = parse_pfm(file, "a");
  require(encode_pfm(parse_pfm(encode_pfm(picture), "a")).size() == encode_pfm(picture).size());
}

void read(char kind, const std::string& text) {
  switch (kind) {
    case 'h':
      return hci(text);
    case 'm':
      return miv(text);
    case 'v':
      return cvkit(text);
    case 'e':
      return eslf(text);
    case 'q':
      parse_quilt_side_file(text, "a");
      return;
    case 'p':
      return ppm(std::as_bytes(std::span(text)));
    case 'f':
      return pfm(std::as_bytes(std::span(text)));
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
