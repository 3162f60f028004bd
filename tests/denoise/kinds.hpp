#pragma once

#include <vector>

#include "lippmann/optics/optics.hpp"

namespace lippmann {

struct OpticsCase {
  const char* name;
  Optics optics;
  bool whole_views;  ///< each view consists of whole film pixels, as film_layout() requires
};

inline std::vector<OpticsCase> optics_cases(int rows = 1) {
  const MultiView quilt{.columns = 3, .rows = 2, .view_cone = 0.5f, .distance_mm = 60.0f, .pixel_height = 1.5f};
  MultiView grid = quilt;
  grid.baseline_mm = 2.0f;
  const LenticularSheet sheet{.lens_pitch_mm = 0.5f, .gap_mm = 1.0f, .offset_mm = 0.25f};
  LenticularSheet fractional = sheet, slanted = sheet, near = sheet;
  fractional.lens_pitch_mm = 0.34f;
  slanted.slant = 0.18f, slanted.lens_pitch_mm = 0.33f;
  near.viewing_distance_mm = 80.0f, near.eye_height_mm = 2.0f, near.slant = -0.1f;
  const MicrolensArray array{.lens_pitch_mm = 0.25f, .gap_mm = 1.0f, .offset_mm = {0.125f, 0.125f}};
  MicrolensArray odd = array, hexagonal = array;
  odd.lens_pitch_mm = 0.2913f, odd.viewing_distance_mm = 70.0f;
  hexagonal.packing = LensPacking::kHexagonal, hexagonal.lens_pitch_mm = 0.3f;
  SlantedPanel panel{.periods = 23.3, .tilt = -0.19, .center = 0.4, .distance_mm = 60.0f};
  SlantedPanel diamond = panel;
  diamond.inverted = false, diamond.sub_pixels[0][1] = {Vec2f(0.25f, 0.1f), Vec2f(-0.25f, 0.1f), Vec2f(0.0f, -0.3f)};
  const Panel plane{60, 48 * rows, 0.25f};
  return {{"quilt", {{60, 42 * rows, 0.25f}, quilt}, true},
          {"cameras", {{60, 40 * rows, 0.25f}, grid}, true},
          {"single view", {{40, 30 * rows, 0.25f}, SingleView{.distance_mm = 60.0f}}, true},
          {"sheet", {{96, 50 * rows, 0.0625f}, sheet}, true},
          {"fractional sheet", {{96, 50 * rows, 0.0625f}, fractional}, false},
          {"slanted sheet", {{96, 50 * rows, 0.0625f}, slanted}, false},
          {"sheet seen from nearby", {{96, 50 * rows, 0.0625f}, near}, false},
          {"square lenses", {{96, 96 * rows, 0.0625f}, array}, true},
          {"fractional lenses", {{96, 96 * rows, 0.0625f}, odd}, false},
          {"hexagonal lenses", {{96, 96 * rows, 0.0625f}, hexagonal}, false},
          {"slanted panel", {plane, panel}, false},
          {"panel of diamonds", {plane, diamond}, false},
          {"lenses narrower than pixels", {{40, 30 * rows, 0.25f}, LenticularSheet{.lens_pitch_mm = 0.1f}}, false},
          {"table",
           {plane, make_ray_table(plane, 1,
                                  [](Vec2f pixel) {
                                    return Ray{{0.25f * (pixel.x - 30.0f), 0.25f * (24.0f - pixel.y), 0.0f}};
                                  })},
           false}};
}

}  // namespace lippmann
