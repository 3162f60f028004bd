// The inverse mapping finds all sub-pixels that see a point (X, Y, Z), with the viewing distance D and the lens pitch p:
// 1. The line from an eye at (e, D) through the point crosses z = 0 at x = X M + e (1 - M), where M = D / (D - Z).
// 2. A sub-pixel below lens k with the phase k + f lies at x = (k + f - c) p, where c is the phase at x = 0.
// 3. The eye of this sub-pixel is at e = s D tan(cone (v - 1/2)), with the parallax s and v = 1 - f (inverted) or v = f.
// 4. Therefore f solves G(f) = p f + a tan(cone (f - 1/2)) = X M - (k - c) p, with a = (1 - M) D s if v = 1 - f, and
//    a = (M - 1) D s if v = f.
// 5. G is monotone, except for some points in front of the panel, near the depth where a lens shows one point over its full
//    width (Z cone = p). There G has two turning points, at cos^2(cone (f - 1/2)) = -a cone / p. In each interval where G is
//    monotone, there is at most one solution per lens.
#include "optics/slanted_panel.hpp"

#include <algorithm>

#include "core/degrees.hpp"
#include "core/json_fields.hpp"
#include "optics/checks.hpp"

namespace lippmann {
namespace {

/// The function G(f) of step 4 at the top of this file.
class LensEquation {
 public:
  LensEquation(double pitch_mm, double a, double cone) : pitch_(pitch_mm), a_(a), cone_(cone) {}

  double value(double f) const { return pitch_ * f + a_ * std::tan(cone_ * (f - 0.5)); }

  std::vector<double> ends() const {
    const double cos2 = -a_ * cone_ / pitch_;
    std::vector<double> ends{0.0};
    if (cos2 > 0.0 && cos2 < 1.0) {
      const double turn = std::acos(std::sqrt(cos2)) / cone_;
      if (turn > 0.0 && turn < 0.5) ends.insert(ends.end(), {0.5 - turn, 0.5 + turn});
    }
    ends.push_back(1.0);
    return ends;
  }

  /// Returns the f in [low, high] with G(f) = `wanted`. G must be monotone in [low, high]. Uses Newton steps, and bisection
  /// where a Newton step would leave the interval.
  double solve(double wanted, double low, double high) const {
    const bool rising = value(high) >= value(low);
    double f = 0.5 * (low + high);
    for (int step = 0; step < 64 && high - low > 1e-15; ++step) {
      const double over = value(f) - wanted;
      if (over == 0.0) return f;
      ((over > 0.0) == rising ? high : low) = f;
      const double cosine = std::cos(cone_ * (f - 0.5));
      const double next = f - over / (pitch_ + a_ * cone_ / (cosine * cosine));
      if (std::abs(next - f) < 1e-15) return f;
      f = next > low && next < high ? next : 0.5 * (low + high);
    }
    return f;
  }

 private:
  double pitch_, a_, cone_;
};

constexpr double kMaxTilt = 1e3, kMaxPhase = 1e6;  ///< within these limits, phases are exact to 1e-7 lenses
constexpr double kMaxOffset = 4;                   ///< maximum distance of a sub-pixel from its pixel's centre, in pixels

void append_sub_pixels(const Panel& panel, const SlantedPanel& slanted, double x, double y, std::vector<Vec2f>& pixels) {
  const int width = panel.width, height = panel.height;
  for (int up = 0; up < 4; ++up)
    for (int column = 0; column < 2; ++column)
      for (int color = 0; color < 3; ++color) {
        const Vec2f offset =
            slanted.sub_pixels[static_cast<std::size_t>(up)][static_cast<std::size_t>(column)][static_cast<std::size_t>(color)];
        // If the point lies on this sub-pixel, i and j are the column and row (from the bottom) of the pixel.
        const double from_left = x - offset.x - 0.5, from_bottom = y - offset.y;
        const double i = std::floor(from_left + 0.5), j = std::floor(from_bottom);
        if (!(i >= 0.0 && i < width && j >= 0.0 && j < height)) continue;
        if ((static_cast<int>(i) & 1) != column || (static_cast<int>(j) & 3) != up) continue;
        const double in_sub_pixel = 3.0 * (from_left - i) + 0.5;
        if (in_sub_pixel >= 0.0 && in_sub_pixel < 1.0)
          pixels.emplace_back(3.0 * i + color + in_sub_pixel, height - from_bottom);
      }
}

}  // namespace

SubPixelOffsets striped_sub_pixels(bool blue_first) {
  const float third = blue_first ? -1.0f / 3.0f : 1.0f / 3.0f;
  SubPixelOffsets offsets;
  for (auto& row : offsets)
    for (auto& column : row) column = {Vec2f(-third, 0.0f), Vec2f(0.0f), Vec2f(third, 0.0f)};
  return offsets;
}

SlantedPanelRays make_slanted_panel(const Panel& panel, const SlantedPanel& slanted, float z_front_mm) {
  const int width = panel.width;
  SlantedPanelRays c{};
  c.lenses_per_px = slanted.periods / width;
  c.lenses_per_row = slanted.tilt * slanted.periods / panel.height;
  c.phase_at_corner = -slanted.center;
  c.phase_sign = slanted.inverted ? -1.0f : 1.0f;
  c.half_cone = 0.5f * slanted.view_cone;
  c.width_px = static_cast<float>(width), c.height_px = static_cast<float>(panel.height);
  c.pixel_mm = panel.pixel_pitch_mm;
  c.eye_reach_mm = slanted.parallax * slanted.distance_mm;
  c.eye_y_mm = slanted.eye_height_mm;
  c.distance_mm = slanted.distance_mm, c.inverse_distance = 1.0f / slanted.distance_mm;
  c.front_from_eye_mm = z_front_mm - slanted.distance_mm;
  int at = 0;
  for (const auto& row : slanted.sub_pixels)
    for (const auto& column : row)
      for (const Vec2f offset : column) c.offset_x[at] = offset.x, c.offset_y[at] = offset.y, ++at;
  return c;
}

LIPPMANN_MULTIVERSION
void write_block(const SlantedPanelRays& c, const RayFrame& frame, const float* px, const float* py, const RayArrays& rays) {
  write_ray_block(frame, px, py, rays, [&c](float x, float y) LIPPMANN_INLINE_LAMBDA { return crossing(c, x, y); });
}

void pixels_seeing(const Panel& panel, const SlantedPanel& slanted, Vec3f point_mm, std::vector<Vec2f>& pixels) {
  const double distance = slanted.distance_mm, from_eye = distance - point_mm.z;
  if (!(from_eye > 0.0)) return;
  const double magnification = distance / from_eye, pixel_mm = panel.pixel_pitch_mm;
  const double width_mm = panel.width * static_cast<double>(panel.pixel_pitch_mm);
  const double y_mm = point_mm.y * magnification + slanted.eye_height_mm * (1.0 - magnification);
  const double up = 0.5 * panel.height + y_mm / pixel_mm;
  constexpr double kReach = 4.0;  // maximum distance of a sub-pixel from its pixel, in pixels (kMaxOffset)
  if (!(up >= -kReach && up <= panel.height + kReach)) return;
  const double pitch = width_mm / slanted.periods, x_mm = point_mm.x * magnification;
  const double phase_at_middle = slanted.periods * (0.5 + slanted.tilt * up / panel.height) - slanted.center;
  const double a = (slanted.inverted ? 1.0 : -1.0) * (1.0 - magnification) * distance * slanted.parallax;
  const LensEquation equation(pitch, a, slanted.view_cone);
  const std::vector<double> ends = equation.ends();
  std::vector<double> values;
  for (const double end : ends) values.push_back(equation.value(end));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double offset = phase_at_middle + x_mm / pitch, half_panel = 0.5 * slanted.periods + kReach * pixel_mm / pitch;
  const double first = std::max(std::floor(offset - *most / pitch), std::floor(phase_at_middle - half_panel));
  const double last = std::min(std::ceil(offset - *least / pitch), std::floor(phase_at_middle + half_panel));
  for (double k = first; k <= last; ++k) {
    const double wanted = x_mm - (k - phase_at_middle) * pitch;
    for (std::size_t piece = 0; piece + 1 < ends.size(); ++piece) {
      const double low = std::min(values[piece], values[piece + 1]), high = std::max(values[piece], values[piece + 1]);
      if (!(wanted >= low && wanted <= high)) continue;
      const double f = equation.solve(wanted, ends[piece], ends[piece + 1]);
      const double x = (k + f - phase_at_middle) * pitch;
      append_sub_pixels(panel, slanted, x / pixel_mm + 0.5 * panel.width, up, pixels);
    }
  }
}

void check_model(const Panel& panel, const SlantedPanel& slanted) {
  check_number("slanted.periods", slanted.periods, 1e-3, 3.0 * panel.width);  // lenses are at least one sub-pixel wide
  check_number("slanted.tilt", slanted.tilt, -kMaxTilt, kMaxTilt);
  check_number("slanted.center", slanted.center, -kMaxPhase, kMaxPhase);
  check_cone("slanted.view_cone", slanted.view_cone);
  check_length("slanted.distance_mm", slanted.distance_mm);
  for (const auto& row : slanted.sub_pixels)
    for (const auto& column : row)
      for (const Vec2f offset : column)
        for (const float value : {offset.x, offset.y}) check_number("slanted.sub_pixels", value, -kMaxOffset, kMaxOffset);
  check_parallax("slanted.parallax", slanted.parallax);
  check_position("slanted.eye_height_mm", slanted.eye_height_mm);
}

namespace {

using Json = nlohmann::ordered_json;

Json sub_pixels_json(const SubPixelOffsets& offsets) {
  Json rows = Json::array();
  for (const auto& row : offsets) {
    Json columns = Json::array();
    for (const auto& column : row) {
      Json colors = Json::array();
      for (const Vec2f offset : column) colors.push_back({offset.x, offset.y});
      columns.push_back(std::move(colors));
    }
    rows.push_back(std::move(columns));
  }
  return rows;
}

template <class List>
void read_list(const JsonFields& members, const Json& json, List& list, const auto& read_element) {
  if (!json.is_array() || json.size() != list.size())
    members.reject("sub_pixel_offsets_px", "has a wrong shape",
                   "4 rows of 2 columns of 3 colours of [x, y], in panel pixels from the pixel's centre");
  for (std::size_t i = 0; i < list.size(); ++i) read_element(json[i], list[i]);
}

}  // namespace

void write_model(const SlantedPanel& slanted, Json& json) {
  json["periods"] = slanted.periods;
  json["tilt"] = slanted.tilt;
  json["center"] = slanted.center;
  json["inverted"] = slanted.inverted;
  json["view_cone_deg"] = to_degrees(slanted.view_cone);
  json["distance_mm"] = slanted.distance_mm;
  if (slanted.eye_height_mm != 0.0f) json["eye_height_mm"] = slanted.eye_height_mm;
  if (slanted.sub_pixels != striped_sub_pixels()) json["sub_pixel_offsets_px"] = sub_pixels_json(slanted.sub_pixels);
}

void read_model(const JsonFields& json, SlantedPanel& slanted) {
  json.require({"periods", "tilt", "center", "view_cone_deg", "distance_mm"});
  slanted.periods = json.number("periods"), slanted.tilt = json.number("tilt"), slanted.center = json.number("center");
  slanted.inverted = json.flag_or("inverted", true);
  slanted.view_cone = from_degrees(json.number("view_cone_deg"));
  slanted.distance_mm = json.float_number("distance_mm");
  slanted.eye_height_mm = json.float_or("eye_height_mm", 0.0f);
  constexpr std::string_view kOffsets = "sub_pixel_offsets_px";
  if (json.has(kOffsets))
    read_list(json, json.value(kOffsets), slanted.sub_pixels, [&](const Json& row, auto& columns) {
      read_list(json, row, columns, [&](const Json& column, auto& colors) {
        read_list(json, column, colors, [&](const Json& offset, Vec2f& to) {
          const std::vector<double> xy = json.numbers_in(kOffsets, offset, 2);
          to = Vec2f(Vec2d(xy[0], xy[1]));
        });
      });
    });
}

OpticsFacts facts_of(const Panel& panel, const SlantedPanel& slanted) {
  const SlantedLens lens = slanted_lens(panel, slanted);
  const int film_width = 3 * panel.width;
  OpticsFacts facts = facts_of_window(panel, slanted.distance_mm);
  facts.eye_height_mm = slanted.eye_height_mm;
  facts.viewing_zone = slanted.view_cone;
  facts.depth_budget_mm = lens.pitch_mm / lens.slope_step;
  facts.parallax = {true, false};
  facts.view_counts = {rounded_up_count(film_width / std::abs(slanted.periods)), 1};
  facts.lens_step_mm = facts.window.size.x / std::abs(slanted.periods);
  facts.views_by_angle = true;
  facts.repeats_beyond_zone = true;
  facts.lens_columns_per_row = film_width * slanted.tilt / panel.height;
  facts.crosstalk_pitch = {1.0, 0.0};
  return facts;
}

LensCells lens_cells_of(const Panel& panel, const SlantedPanel& slanted) {
  // Converts the phase (x + y T) P - center (slanted_panel.hpp) to a function of mm from the panel's centre.
  const double periods = slanted.periods, pixel = panel.pixel_pitch_mm;
  LensCells cells;
  cells.lenses_per_mm = Vec2d(1.0 / panel.width, slanted.tilt / panel.height) * (periods / pixel);
  cells.first_lens = slanted.center - 0.5 * (1.0 + slanted.tilt) * periods;
  cells.cell_px.x = 3 * panel.width / periods;
  cells.cone = slanted.view_cone, cells.parallax = slanted.parallax, cells.sign = slanted.inverted ? -1.0 : 1.0;
  return cells;
}

Vec2d zone_slope(const Panel&, const SlantedPanel& slanted, Vec2d share) {
  return {std::tan(slanted.view_cone * (share.x - 0.5)), 0.0};
}

StepRule step_rule(const Panel& panel, const SlantedPanel& slanted, StepsWithin) {
  const SlantedPanelRays c = make_slanted_panel(panel, slanted, 0.0f);
  StepRule rule;
  rule.across.x = static_cast<float>(3.0 / std::abs(c.lenses_per_px));
  rule.down.x =
      // One row down, the phase is lower by lenses_per_row. The step to the right compensates for this.
      static_cast<float>(3.0 * c.lenses_per_row / c.lenses_per_px);
  return rule;
}

}  // namespace lippmann
