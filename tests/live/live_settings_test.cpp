#include "live/live_settings.hpp"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "live/live_support.hpp"
#include "support/error_message.hpp"

namespace lippmann {
namespace {

using testing::HasSubstr;

void set(LiveSettings& settings, const std::string& name, const std::string& value) { settings.set(name, &value); }

TEST(LiveSettings, settings_override_the_command_line) {
  RenderParams base = test::small_room();
  base.scene.view.zoom = 2.0f;
  LiveSettings settings(base);
  set(settings, "zoom", "3");
  set(settings, "orbit", "30,15");
  EXPECT_EQ(settings.job().scene().view.zoom, 3.0f);
  EXPECT_EQ(settings.values()["orbit"], "30,15");
  EXPECT_EQ(settings.changed().size(), 2u);
  settings.set("zoom", nullptr);
  EXPECT_EQ(settings.job().scene().view.zoom, 2.0f);
}

TEST(LiveSettings, bad_values_change_nothing) {
  LiveSettings settings(test::small_room());
  EXPECT_THAT(test::error_message([&] { set(settings, "zoom", "-1"); }), HasSubstr("zoom"));
  EXPECT_THAT(test::error_message([&] { set(settings, "spp", "many"); }), HasSubstr("spp"));
  EXPECT_EQ(settings.job().scene().view.zoom, 1.0f);
  EXPECT_TRUE(settings.changed().empty());
}

TEST(LiveSettings, forbidden_settings_are_refused) {
  LiveSettings settings(test::small_room());
  for (const char* name : {"output", "scene", "asset-root", "video", "nonsense"})
    EXPECT_THAT(test::error_message([&] { set(settings, name, "x"); }), HasSubstr("orbit")) << name;
}

TEST(LiveSettings, settings_cannot_name_files) {
  RenderParams base = test::small_room();
  base.scene.environment = "/home/own.hdr";
  LiveSettings settings(base);
  EXPECT_THAT(test::error_message([&] { set(settings, "environment", "/etc/passwd"); }), HasSubstr("accepts no files"));
  EXPECT_THAT(test::error_message([&] { set(settings, "display", "../visual.json"); }), HasSubstr("presets only"));
  set(settings, "environment", "studio");
  set(settings, "environment", "/home/own.hdr");
  set(settings, "display", "portrait");
}

TEST(LiveSettings, frames_are_limited_to_the_animation) {
  LiveSettings settings(test::small_room());
  settings.set_frame(9, 10);
  EXPECT_EQ(settings.frame(), 9);
  EXPECT_THAT(test::error_message([&] { settings.set_frame(10, 10); }), HasSubstr("0 to 9"));
  EXPECT_THAT(test::error_message([&] { settings.set_frame(-1, 10); }), HasSubstr("0 to 9"));
}

}  // namespace
}  // namespace lippmann
