#include "view/light_fields.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "image/png.hpp"
#include "optics/optics_json.hpp"
#include "support/pictures.hpp"

namespace lippmann::test {

Optics small_sheet() {
  Optics optics;
  optics.panel = {16, 6, 0.25f};
  LenticularSheet sheet;
  sheet.viewing_distance_mm = 100.0f;
  sheet.lens_pitch_mm = 1.0f / (1.0f + sheet.gap_mm / sheet.viewing_distance_mm);
  sheet.offset_mm = 0.5f * sheet.lens_pitch_mm;
  optics.model = sheet;
  return optics;
}

std::vector<Image8> write_sheet_frames(const std::filesystem::path& folder, int count) {
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();
  std::vector<Image8> pictures;
  for (int i = 0; i < count; ++i) {
    pictures.push_back(noise_codes(16, 6, static_cast<std::uint32_t>(i + 1)));
    write_png(folder / fmt::format("frame_{:04}.png", i), pictures.back());
    nlohmann::ordered_json frame{{"frame", i}, {"kind", i == 0 ? "key" : "in-between"}};
    if (i > 0) frame["estimated_psnr_db"] = 30.0 + i;
    frames.push_back(frame);
  }
  std::ofstream(folder / "report.json") << nlohmann::ordered_json{
      {"optics", optics_json(small_sheet())}, {"frames_per_second", 24.0}, {"frames", frames}};
  return pictures;
}

std::vector<std::unique_ptr<PageField>> fields_of(const std::filesystem::path& in) {
  const Context context;
  std::vector<std::unique_ptr<PageField>> fields;
  fields.push_back(std::make_unique<PageField>(in, LightFieldHints{}, context));
  return fields;
}

}  // namespace lippmann::test
