// When a scene point moves, it must be reprojected to the pixel that shows it in the same view, or below the same lens
// (reuse/landing.hpp). The expected pixel
// is computed in double precision or found by search.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <sstream>

#include "lippmann/core/error.hpp"
#include "optics/random_optics.hpp"
#include "reuse/make_landing.hpp"
#include "reuse/point_images.hpp"
#include "reuse/splat.hpp"

namespace lippmann {
namespace {

using test::at_depth;
using test::KnownMotion;
using test::OpticsSampler;

using Place = std::optional<glm::dvec2>;

using test::centre_of;

bool on_panel(const Optics& optics, glm::dvec2 p) {
  return p.x >= 0 && p.y >= 0 && p.x < film_size(optics).x && p.y < optics.panel.height;
}

/// Returns the centre of the microlens above the pixel. For a sheet, x is the distance of the lens axis from the
/// slanted axis through the origin, and y is 0.
glm::dvec2 lens_above(const Optics& optics, Vec2f pixel) {
  const Vec3f p = at_depth(ray_of_pixel(optics, pixel), 0.0f);
  const auto* sheet = std::get_if<LenticularSheet>(&optics.model);
  return sheet ? glm::dvec2(p.x * std::cos(sheet->slant) + p.y * std::sin(sheet->slant), 0.0) : glm::dvec2(p.x, p.y);
}

float lens_pitch(const Optics& optics) {
  const auto* sheet = std::get_if<LenticularSheet>(&optics.model);
  return sheet ? sheet->lens_pitch_mm : std::get<MicrolensArray>(optics.model).lens_pitch_mm;
}

bool same_lens(const Optics& optics, Vec2f a, Vec2f b) {
  return glm::distance(lens_above(optics, a), lens_above(optics, b)) < 0.25 * lens_pitch(optics);
}

Place seen_below_lens(const Optics& optics, Vec2f from, Vec3f point) {
  // If the panel's edge cuts the area below a lens, the image of the point may lie outside the panel. The panel is
  // enlarged by this margin in pixels.
  constexpr float kMargin = 8.0f;
  Optics wide = optics;
  wide.z_front_mm = resolved_z_front_mm(optics);
  wide.panel.width += 2 * static_cast<int>(kMargin), wide.panel.height += 2 * static_cast<int>(kMargin);
  std::vector<Vec2f> pixels;
  pixels_seeing(wide, point, pixels);
  const auto* sheet = std::get_if<LenticularSheet>(&optics.model);
  for (const Vec2f p : pixels) {
    if (!same_lens(wide, p, from + kMargin)) continue;
    const Vec2f place = p - kMargin;
    if (!sheet) return place;
    // A pixel of a sheet shows points of its whole row, so the place moves along the lens axis to the centre of the
    // row.
    const float row = std::floor(place.y) + 0.5f;
    return glm::dvec2(place.x + (row - place.y) * std::tan(sheet->slant), row);
  }
  return std::nullopt;
}

struct Lattice {
  double pitch, row_pitch;  ///< in mm; row_pitch is 0 for a sheet
  glm::dvec2 offset;
  double spread;   ///< width of the area below a lens / width of the lens
  glm::dvec2 eye;  ///< position of the viewer's eye, in the coordinates of `offset`
  bool hexagonal = false;
};

Lattice lattice_of(const Optics& optics) {
  if (const auto* s = std::get_if<LenticularSheet>(&optics.model)) {
    const bool far = std::isinf(s->viewing_distance_mm);
    return {s->lens_pitch_mm,
            0.0,
            {s->offset_mm, 0.0},
            1.0 + s->gap_mm / double{s->viewing_distance_mm},
            {far ? 0.0 : s->eye_height_mm * std::sin(s->slant), 0.0}};
  }
  const auto& a = std::get<MicrolensArray>(optics.model);
  const bool hexagonal = a.packing == LensPacking::kHexagonal;
  return {a.lens_pitch_mm,
          a.lens_pitch_mm * (hexagonal ? std::sqrt(3.0) / 2 : 1.0),
          {a.offset_mm.x, a.offset_mm.y},
          1.0 + a.gap_mm / double{a.viewing_distance_mm},
          {0.0, 0.0},
          hexagonal};
}

glm::dvec2 nearest_lens(const Lattice& lattice, glm::dvec2 p) {
  const auto nearest = [](double x, double first, double pitch) { return first + std::round((x - first) / pitch) * pitch; };
  if (lattice.row_pitch == 0.0) return {nearest(p.x, lattice.offset.x, lattice.pitch), 0.0};
  // Every second row of hexagonal lenses is shifted, so several rows near the point are compared.
  const double row = std::round((lattice.offset.y - p.y) / lattice.row_pitch);
  glm::dvec2 best(1e30);
  for (double r = row - 2; r <= row + 2; ++r) {
    const bool odd = lattice.hexagonal && std::fmod(std::abs(r), 2.0) == 1.0;
    const glm::dvec2 lens(nearest(p.x, lattice.offset.x + (odd ? 0.5 * lattice.pitch : 0.0), lattice.pitch),
                          lattice.offset.y - r * lattice.row_pitch);
    if (glm::distance(lens, p) < glm::distance(best, p)) best = lens;
  }
  return best;
}

/// Compares positions that have the same offset as `from` from the centre of the area below their lens. Returns the
/// position whose ray passes nearest to the point.
Place seen_in_lens_view(const Optics& optics, Vec2f from, Vec3f point) {
  const Lattice lattice = lattice_of(optics);
  const double m = optics.panel.pixel_pitch_mm, w = optics.panel.width, h = optics.panel.height;
  const auto* sheet = std::get_if<LenticularSheet>(&optics.model);
  const double gap = sheet ? sheet->gap_mm : std::get<MicrolensArray>(optics.model).gap_mm;
  const double parallax = sheet ? sheet->parallax : std::get<MicrolensArray>(optics.model).parallax;
  const double vergence = (lattice.spread - 1.0) / gap, from_eye = 1.0 - point.z * vergence;
  if (from_eye <= 0.0) return std::nullopt;
  glm::dvec2 panel_mm((from.x - w / 2) * m, (h / 2 - from.y) * m), p(point.x, point.y);
  const double cosine = sheet ? std::cos(sheet->slant) : 1.0, sine = sheet ? std::sin(sheet->slant) : 0.0;
  if (sheet) {
    panel_mm = {panel_mm.x * cosine + panel_mm.y * sine, 0.0};
    p = {p.x * cosine + p.y * sine, 0.0};
  }
  const auto cell_centre = [&](glm::dvec2 lens) { return lens + (lens - lattice.eye) * (lattice.spread - 1.0); };
  // `own` is the lens above the pixel. At the offset o from the centre of the area below this lens, the ray has the
  // slope -parallax o / gap - (l - e) / V, with the lens position l, the viewing distance V, and e = lattice.eye.
  const glm::dvec2 own = nearest_lens(lattice, (panel_mm + lattice.eye * (lattice.spread - 1.0)) / lattice.spread);
  const glm::dvec2 o = panel_mm - cell_centre(own);
  const glm::dvec2 through = (p + (parallax * o / gap - lattice.eye * vergence) * double{point.z}) / from_eye;
  const glm::dvec2 landed = cell_centre(nearest_lens(lattice, through)) + o;
  if (!sheet) return glm::dvec2(landed.x / m + w / 2, h / 2 - landed.y / m);
  // Computes the row of pixels that shows the point. Along the lenses of a sheet, all rays run towards the eye.
  const double y_eye = sheet->eye_height_mm, v = sheet->viewing_distance_mm;
  const double y = std::isinf(v) ? point.y : (point.y * (v + gap) - y_eye * (point.z + gap)) / (v - point.z);
  const double row = std::floor(h / 2 - y / m);
  return glm::dvec2((landed.x + (row + 0.5 - h / 2) * m * sine) / cosine / m + w / 2, row + 0.5);
}

/// Returns the position in the same view whose ray passes nearest to the point, for quilts and single views. The
/// position may be half a pixel beyond the edge.
Place seen_in_picture(const Optics& optics, Vec2f from, Vec3f point) {
  const auto* views = std::get_if<MultiView>(&optics.model);
  const float distance = views ? views->distance_mm : std::get<SingleView>(optics.model).distance_mm;
  if (point.z >= distance) return std::nullopt;
  const Vec2i tile = views ? Vec2i(optics.panel.width / views->columns, optics.panel.height / views->rows)
                           : Vec2i(optics.panel.width, optics.panel.height);
  const int padding = views ? optics.panel.height - views->rows * tile.y : 0;
  const auto tile_at = [&](Vec2f p) {
    const Vec2i last = views ? Vec2i(views->columns - 1, views->rows - 1) : Vec2i(0);
    return glm::min(Vec2i(static_cast<int>(p.x) / tile.x, std::max(0, static_cast<int>(p.y) - padding) / tile.y), last);
  };
  const double spacing = optics.panel.pixel_pitch_mm * (1.0 - point.z / distance);
  glm::dvec2 best(0.0), miss(1e30);
  for (int i = 0; i < optics.panel.width; ++i) {
    const Vec2f p(i + 0.5f, from.y);
    const double d = std::abs(at_depth(ray_of_pixel(optics, p), point.z).x - point.x);
    if (tile_at(p).x == tile_at(from).x && d < miss.x) miss.x = d, best.x = p.x;
  }
  for (int j = 0; j < optics.panel.height; ++j) {
    const Vec2f p(from.x, j + 0.5f);
    const double d = std::abs(at_depth(ray_of_pixel(optics, p), point.z).y - point.y);
    if (tile_at(p).y == tile_at(from).y && d < miss.y) miss.y = d, best.y = p.y;
  }
  const double row_spacing = spacing * (views ? views->pixel_height : 1.0f);
  return miss.x <= 0.5 * spacing && miss.y <= 0.5 * row_spacing ? Place(best) : std::nullopt;
}

Place expected_place(const Optics& optics, SplatMode mode, Vec2f from, Vec3f point) {
  const bool lenses =
      std::holds_alternative<LenticularSheet>(optics.model) || std::holds_alternative<MicrolensArray>(optics.model);
  if (!lenses) return seen_in_picture(optics, from, point);
  return mode == SplatMode::kLens ? seen_below_lens(optics, from, point) : seen_in_lens_view(optics, from, point);
}

std::optional<std::uint32_t> pixel_at(const Optics& optics, const Place& place) {
  if (!place || !on_panel(optics, *place)) return std::nullopt;
  return static_cast<std::uint32_t>(place->y) * static_cast<std::uint32_t>(film_size(optics).x) +
         static_cast<std::uint32_t>(place->x);
}

bool is_on_pixel_edge(double place) { return std::abs(place - std::round(place)) < 1e-3; }

/// Returns whether a shift of the point by a thousandth of a pixel's footprint changes the expected pixel.
bool is_close_call(const Optics& optics, SplatMode mode, Vec2f from, Vec3f point) {
  const Vec2f footprint = sample_footprint_mm(optics, point.z);
  const float step = 1e-3f * std::min(footprint.x, optics.panel.pixel_pitch_mm);
  const Place place = expected_place(optics, mode, from, point);
  if (place && (is_on_pixel_edge(place->x) || is_on_pixel_edge(place->y))) return true;
  const auto here = pixel_at(optics, place);
  for (const Vec3f nudge : {Vec3f(step, 0, 0), Vec3f(-step, 0, 0), Vec3f(0, step, 0), Vec3f(0, -step, 0)})
    if (pixel_at(optics, expected_place(optics, mode, from, point + nudge)) != here) return true;
  return false;
}

/// At the edge of the area below a lens, the position may lie in a pixel whose centre is below the neighbouring lens.
/// The point may then land nowhere, or on a pixel below its own lens, at most 1.5 pixels away.
bool is_own_neighbour(const Optics& optics, glm::dvec2 place, glm::dvec2 lens, std::optional<std::uint32_t> landed) {
  if (!landed) return true;
  const Vec2f centre = centre_of(optics, *landed);
  return glm::distance(lens_above(optics, centre), lens) < 0.25 * lens_pitch(optics) && std::abs(centre.x - place.x) <= 1.5 &&
         std::abs(centre.y - place.y) <= 1.5;
}

void check(const Optics& optics, SplatMode mode, OpticsSampler& random) {
  const Splatter splatter(optics, {mode, true});
  const float reach = std::min(20.0f, 0.5f * resolved_z_front_mm(optics));
  const bool lenses = whole_pixels_per_lens(optics) != Vec2i(1, 1);
  int compared = 0;
  for (int k = 0; k < 250; ++k) {
    const auto pixel = static_cast<std::uint32_t>(random.integer(0, film_size(optics).x * optics.panel.height - 1));
    const Vec2f from = centre_of(optics, pixel);
    const float z = random.uniform(0.1f, reach) * (random.coin() ? 1.0f : -1.0f);
    const float step = 4.0f * sample_footprint_mm(optics, z).x;
    const Affine3f a{Mat3f(1.0f), {random.uniform(-step, step), random.uniform(-step, step), random.uniform(-0.05f, 0.05f)}};
    const KnownMotion motion({a});
    const Vec3f moved = at_depth(ray_of_pixel(optics, from), z) + a.translation;
    if (is_close_call(optics, mode, from, moved)) continue;
    ++compared;
    const Place place = expected_place(optics, mode, from, moved);
    const auto landed = splatter.landing(pixel, z, 0, motion.motion), expected = pixel_at(optics, place);
    if (landed == expected) continue;
    std::ostringstream what;
    what << test::model_name(optics) << " " << optics.panel.width << "x" << optics.panel.height << ", pixel " << pixel
         << ", landed on " << (landed ? std::to_string(*landed) : "nothing") << ", expected ";
    (place ? what << place->x << " " << place->y : what << "nothing");
    ASSERT_TRUE(place && lenses) << what.str();
    // With kLens, the point must land below the same lens as the original pixel. With kView, it must land below the
    // lens that covers the expected position.
    const Vec2f floor_centre(std::floor(place->x) + 0.5, std::floor(place->y) + 0.5);
    const glm::dvec2 lens = mode == SplatMode::kLens ? lens_above(optics, from) : lens_above(optics, Vec2f(*place));
    EXPECT_TRUE(glm::distance(lens_above(optics, floor_centre), lens) > 0.25 * lens_pitch(optics) || !on_panel(optics, *place))
        << what.str();
    EXPECT_TRUE(is_own_neighbour(optics, *place, lens, landed)) << what.str();
  }
  // at least 100 of the 250 random points must be compared
  EXPECT_GT(compared, 100) << test::model_name(optics);
}

TEST(Landing, same_view_agrees_with_its_definition) {
  OpticsSampler random(1);
  for (int k = 0; k < 60; ++k) check(random.any(k), SplatMode::kView, random);
}

TEST(Landing, same_lens_agrees_with_the_inverse_projection) {
  OpticsSampler random(2);
  for (int k = 0; k < 60; ++k) check(random.any(k), SplatMode::kLens, random);
}

TEST(Landing, static_points_stay_in_their_pixels) {
  OpticsSampler random(3);
  const KnownMotion still({Affine3f{}});
  for (int k = 0; k < 60; ++k) {
    const Optics optics = random.any(k);
    for (const SplatMode mode : {SplatMode::kView, SplatMode::kLens}) {
      PointImage image = test::empty_points(optics.panel);
      const auto pixels = static_cast<std::uint32_t>(image.points.z.size());
      for (std::uint32_t p = 0; p < pixels; ++p) test::set_point(image, p, random.uniform(-30.0f, 30.0f));
      SplatBuffer buffer;
      Splatter(optics, {mode, true}).splat(image, still.motion, ThreadPool(1), buffer);
      for (std::uint32_t p = 0; p < pixels; ++p) ASSERT_EQ(SplatBuffer::source(buffer.keys[p]), p) << test::model_name(optics);
    }
  }
}

Optics slanted_panel(OpticsSampler& random) {
  Optics optics = random.slanted_panel();
  std::get<SlantedPanel>(optics.model).sub_pixels = striped_sub_pixels(random.coin());
  return optics;
}

TEST(Landing, slanted_panels_keep_the_direction) {
  OpticsSampler random(5);
  for (int k = 0; k < 20; ++k) {
    const Optics optics = slanted_panel(random);
    const auto& slanted = std::get<SlantedPanel>(optics.model);
    const Splatter splatter(optics, {SplatMode::kView, true});
    // Returns the eye's angle as a fraction of the view cone. Neighbouring sub-pixels differ by 1 / (sub-pixels per
    // lens).
    const auto view_of = [&](Vec2f pixel) {
      const Vec3f eye = at_depth(ray_of_pixel(optics, pixel), slanted.distance_mm);
      return std::atan(eye.x / (slanted.parallax * slanted.distance_mm)) / slanted.view_cone;
    };
    const double sub_pixels = std::abs(film_size(optics).x / slanted.periods);
    int seen = 0;
    for (int n = 0; n < 100; ++n) {
      const auto pixel = static_cast<std::uint32_t>(random.integer(0, film_size(optics).x * optics.panel.height - 1));
      const Vec2f from = centre_of(optics, pixel);
      const float z = random.uniform(-20.0f, 20.0f),
                  step = 2.0f * static_cast<float>(sub_pixels) * optics.panel.pixel_pitch_mm / 3.0f;
      const Affine3f a{Mat3f(1.0f), {random.uniform(-step, step), random.uniform(-step, step), 0.0f}};
      const auto landed = splatter.landing(pixel, z, 0, KnownMotion({a}).motion);
      const Vec3f eye = at_depth(ray_of_pixel(optics, from), slanted.distance_mm);
      const Vec3f moved = at_depth(ray_of_pixel(optics, from), z) + a.translation;
      const Vec3f in_plane = eye + (moved - eye) * (slanted.distance_mm / (slanted.distance_mm - moved.z));
      if (!landed) continue;
      ++seen;
      const Vec2f centre = centre_of(optics, *landed);
      const Vec3f place = at_depth(ray_of_pixel(optics, centre), 0.0f);
      // The tolerance is half a row in y, and half a lens plus half a sub-pixel in x. The tolerance of the view is half
      // the step between neighbouring sub-pixels. Views repeat from lens to lens.
      const double pitch = optics.panel.pixel_pitch_mm / 3.0;
      EXPECT_LE(std::abs(place.y - in_plane.y), 1.51 * pitch);
      EXPECT_LE(std::abs(place.x - in_plane.x), (0.5 * sub_pixels + 0.51) * pitch);
      const double off = view_of(centre) - view_of(from);
      EXPECT_LE(std::abs(off - std::round(off)), 0.51 / sub_pixels);
    }
    EXPECT_GT(seen, 30);
  }
}

TEST(Landing, static_points_of_slanted_panels_stay) {
  OpticsSampler random(6);
  const KnownMotion still({Affine3f{}});
  const KnownMotion hardly({Affine3f{Mat3f(1.0f), Vec3f(1e-7f, 0.0f, 0.0f)}});
  for (int k = 0; k < 20; ++k) {
    const Optics optics = slanted_panel(random);
    const Splatter splatter(optics, {SplatMode::kView, true});
    for (int n = 0; n < 100; ++n) {
      const auto pixel = static_cast<std::uint32_t>(random.integer(0, film_size(optics).x * optics.panel.height - 1));
      const float z = random.uniform(-20.0f, 20.0f);
      EXPECT_EQ(splatter.landing(pixel, z, 0, still.motion), pixel);
      EXPECT_EQ(splatter.landing(pixel, z, 0, hardly.motion), pixel);
    }
  }
}

TEST(Landing, unsupported_modes_of_slanted_panels_are_refused) {
  Optics optics;
  optics.panel = {200, 100, 0.3f};
  SlantedPanel slanted{.periods = 60.0};
  const auto refused = [&](SplatMode mode) {
    optics.model = slanted;
    try {
      make_landing(optics, mode);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kUsage);
      EXPECT_FALSE(error.accepted().empty());
      return error.where();
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refused(SplatMode::kView), "accepted");
  EXPECT_EQ(refused(SplatMode::kLens), "splat");
  slanted.sub_pixels[1][0][2].y = 0.25f;
  EXPECT_EQ(refused(SplatMode::kView), "reuse");
}

TEST(Landing, whole_splat_equals_single_points) {
  OpticsSampler random(4);
  for (int k = 0; k < 24; ++k) {
    const Optics optics = random.any(k);
    const SplatMode mode = random.coin() ? SplatMode::kView : SplatMode::kLens;
    PointImage image = test::empty_points(optics.panel);
    const auto pixels = static_cast<std::uint32_t>(image.points.z.size());
    // The random depths are multiples of 0.5, so that some are equal.
    for (std::uint32_t p = 0; p < pixels; ++p)
      test::set_point(image, p, 0.5f * static_cast<float>(random.integer(-20, 20)), static_cast<std::uint32_t>(p % 3));
    const KnownMotion motion({test::shift(1.0f, 0.2f, 0), test::shift(-2.0f, 3.0f, 0), Affine3f{}});
    const Splatter splatter(optics, {mode, true});
    std::vector<std::uint32_t> nearest(pixels, kNoSource);
    std::vector<float> depth(pixels, -kInfinity);
    for (std::uint32_t p = 0; p < pixels; ++p) {
      const auto at =
          image.points.object[p] == 2 ? p : splatter.landing(p, image.points.z[p], image.points.object[p], motion.motion);
      if (!at || image.points.z[p] <= depth[*at]) continue;
      nearest[*at] = p, depth[*at] = image.points.z[p];
    }
    for (const int threads : {1, 2, 4}) {
      SplatBuffer buffer;
      splatter.splat(image, motion.motion, ThreadPool(threads), buffer);
      for (std::uint32_t p = 0; p < pixels; ++p)
        ASSERT_EQ(SplatBuffer::source(buffer.keys[p]), nearest[p]) << test::model_name(optics) << ", pixel " << p;
    }
  }
}

}  // namespace
}  // namespace lippmann
