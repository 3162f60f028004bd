#include "replay/spoc.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lippmann/core/error.hpp"
#include "lippmann/optics/viewing.hpp"
#include "optics/models.hpp"

namespace lippmann {
namespace {

/// Finds the recorded pixel that looks at a point, preferably through the lens where the ray meets the recording array.
template <class Sight>
class RecordedPixels {
 public:
  RecordedPixels(const Optics& optics, const Sight& sight, double reference_mm)
      : sight_(sight), size_(optics.panel.width, optics.panel.height), design_(design_viewer(optics)), z_(reference_mm) {}

  std::uint32_t looking_at(Vec2d point_mm, Vec2d ray_meets_array_mm) const {
    constexpr int kTries = 16;
    const Viewer from_point = viewer_at({point_mm, z_});
    // If the nearest lens has no such pixel, tries the lenses on the line to `foot`. The lens at `foot` images the point to the
    // middle of its cell.
    const Vec2d foot = (point_mm - design_.slope_at_centre * z_) / (1.0 - design_.vergence * z_);
    for (int i = 0; i <= kTries; ++i) {
      const Vec2d at = glm::mix(ray_meets_array_mm, foot, static_cast<double>(i) / kTries);
      const PanelPoint seen = sight_.seen_from(from_point, at);
      const Vec2i pixel(glm::floor(glm::clamp(seen.pixel, Vec2d(-1.0), Vec2d(size_))));
      const bool on_panel = pixel.x >= 0 && pixel.y >= 0 && pixel.x < size_.x && pixel.y < size_.y;
      if (on_panel && sight_.cell(seen.pixel) == seen.lens)
        return static_cast<std::uint32_t>(pixel.y) * static_cast<std::uint32_t>(size_.x) + static_cast<std::uint32_t>(pixel.x);
    }
    return kNoPixel;
  }

 private:
  Sight sight_;
  Vec2i size_;
  Viewer design_;
  double z_;
};

template <class Sight>
PixelMap map_rays(const Optics& display, const SpocParams& params, const RecordedPixels<Sight>& recorded) {
  const Panel& panel = display.panel;
  PixelMap map{panel.width, panel.height, {}};
  for (int y = 0; y < panel.height; ++y)
    for (int x = 0; x < panel.width; ++x) {
      const Ray ray = ray_of_pixel(display, Vec2f(x, y) + 0.5f);
      const auto at_depth = [&](double z) {
        return Vec2d(ray.origin) + Vec2d(ray.direction) * ((z - ray.origin.z) / ray.direction.z);
      };
      map.source.push_back(
          recorded.looking_at(at_depth(params.distance_mm - params.reference_mm), at_depth(params.distance_mm)));
    }
  return map;
}

void check(const SpocParams& params) {
  if (!(std::abs(params.distance_mm) <= 1e6))
    throw usage_error("spoc", fmt::format("{} mm is out of range", params.distance_mm), "a distance above 0");
  if (!(params.reference_mm > 0.0 && params.reference_mm <= 1e6))
    throw usage_error("reference-plane", fmt::format("{} mm is out of range", params.reference_mm),
                      "a distance in front of the recording array, > 0");
}

[[noreturn]] void refuse_without_lenses() {
  throw usage_error("spoc", "the picture was not recorded by a lens array", "pictures of `optics` lenticular or microlens");
}

}  // namespace

Optics spoc_display(const Optics& recorded, const SpocDisplay& display) {
  if (display.pixels < 1 || display.pixels > 4096 || !(display.lens_pitch_mm > 0.0))
    throw usage_error("lens-pixels", fmt::format("is {} with a lens pitch of {} mm", display.pixels, display.lens_pitch_mm),
                      "1 to 4096 pixels and a pitch above 0");
  Optics optics = recorded;
  const Vec2d window = display_window(recorded).size;
  const std::optional<LensArray> lenses = lens_array(recorded);
  if (!lenses) refuse_without_lenses();
  const double pitch_along_x = display.lens_pitch_mm / lenses->slant_cosine, pixel = pitch_along_x / display.pixels;
  const auto whole = [](double count) { return std::clamp(std::round(count), 1.0, 65536.0); };
  const double across = whole(window.x / pitch_along_x), along = whole(window.y / pitch_along_x);
  const double rows = lenses->row_pitch_mm > 0.0 ? along * display.pixels : whole(window.y / pixel);
  optics.panel = {static_cast<int>(std::min(across * display.pixels, 1e9)), static_cast<int>(std::min(rows, 1e9)),
                  static_cast<float>(pixel)};
  // The middle of the panel is a cell boundary if the number of lenses is even, and a lens centre if it is odd.
  const Vec2f offset(std::fmod(across, 2.0) == 0.0 ? 0.5 * display.lens_pitch_mm : 0.0,
                     std::fmod(along, 2.0) == 0.0 ? 0.5 * display.lens_pitch_mm : 0.0);
  optics.model =
      *with_lenses(recorded.model, static_cast<float>(display.lens_pitch_mm), static_cast<float>(display.gap_mm), offset);
  try {
    validate(optics);
  } catch (const Error& error) {
    throw usage_error("spoc", "the display's array is invalid: " + error.where() + " " + error.problem(), error.accepted());
  }
  return optics;
}

PixelMap spoc(const Optics& recorded, const Optics& display, const SpocParams& params) {
  check(params);
  return std::visit(
      [&]<class Sight>(const Sight& sight) -> PixelMap {
        if constexpr (requires { sight.cell(Vec2d(0.0)); })
          return map_rays(display, params, RecordedPixels<Sight>(recorded, sight, params.reference_mm));
        else
          refuse_without_lenses();
      },
      make_sight(recorded));
}

}  // namespace lippmann
