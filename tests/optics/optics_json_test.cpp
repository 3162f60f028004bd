#include "optics/optics_json.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "random_optics.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

std::string message_for(const Json& json) {
  return test::error_message([&] { optics_from_json(json, "report.json"); });
}

Json some_optics() { return optics_json(Optics{}); }

TEST(OpticsJson, round_trip_keeps_rays_of_every_model) {
  test::OpticsSampler random(11);
  for (int i = 0; i < 200; ++i) {
    // the parallax belongs to a render, not to a display, so JSON does not store it
    const Optics optics = with_parallax(random.every(i), 1.0f);
    const Json json = optics_json(optics);
    const Optics back = optics_from_json(Json::parse(json.dump()), "report.json");
    const Vec2f pixel(0.3f * static_cast<float>(film_size(optics).x), 0.7f * static_cast<float>(optics.panel.height));
    const Ray a = ray_of_pixel(optics, pixel), b = ray_of_pixel(back, pixel);
    EXPECT_EQ(a.direction, b.direction) << json.dump();
    EXPECT_EQ(a.origin, b.origin) << json.dump();
    EXPECT_EQ(optics.z_front_mm, back.z_front_mm);
  }
}

TEST(OpticsJson, infinite_distances_come_back) {
  const Optics back = optics_from_json(some_optics(), "report.json");
  EXPECT_EQ(std::get<LenticularSheet>(back.model).viewing_distance_mm, kInfinity);
}

TEST(OpticsJson, hostile_json_gives_one_error) {
  EXPECT_THAT(message_for("lenticular"), HasSubstr("report.json"));
  EXPECT_THAT(message_for(nullptr), HasSubstr("is not an object"));
  for (const auto& [key, value, part] : std::vector<std::tuple<const char*, Json, const char*>>{
           {"kind", "lenticuler", "'lenticuler'"},
           {"kind", 7, "optics.kind"},
           {"width", -3, "optics.width"},
           {"width", 1e300, "optics.width"},
           {"width", 123456789012345678, "optics.width"},
           {"width", 100000, "panel.width"},
           {"gap_mm", "2", "optics.gap_mm"},
           {"gap_mm", 0.0, "gap_mm"},
           {"gap_mm", nullptr, "optics.gap_mm"},
           {"lens_pitch_mm", 1e300, "optics.lens_pitch_mm"},
           {"viewing_distance_mm", Json::array(), "optics.viewing_distance_mm"},
       }) {
    Json json = some_optics();
    json[key] = value;
    EXPECT_THAT(message_for(json), HasSubstr(part)) << key << " " << value;
    EXPECT_THAT(message_for(json), HasSubstr("report.json")) << key << " " << value;
  }
}

TEST(OpticsJson, checks_sub_pixels_of_slanted_panels) {
  SlantedPanel slanted;
  slanted.sub_pixels[2][1][0].x = 0.25f;
  const Json good = optics_json({.panel = {171, 512, 0.15f}, .model = slanted});
  EXPECT_EQ(std::get<SlantedPanel>(optics_from_json(good, "report.json").model).sub_pixels, slanted.sub_pixels);
  for (const Json& bad : {Json(3), Json::array(), Json{1, 2, 3, 4}, Json{{1, 2}, {1, 2}, {1, 2}, {1, 2}}}) {
    Json json = good;
    json["sub_pixel_offsets_px"] = bad;
    EXPECT_THAT(message_for(json), HasSubstr("sub_pixel_offsets_px")) << bad;
  }
}

TEST(OpticsJson, missing_keys_are_named) {
  for (const char* key : {"kind", "width", "height", "pixel_pitch_mm", "lens_pitch_mm", "gap_mm", "viewing_distance_mm"}) {
    Json json = some_optics();
    json.erase(key);
    EXPECT_THAT(message_for(json), HasSubstr("optics." + std::string(key) + ": is missing")) << key;
  }
}

}  // namespace
}  // namespace lippmann
