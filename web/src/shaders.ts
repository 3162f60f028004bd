// The shaders. View v shows the scene from the same slope S_v at every point of the display. An eye at E sees the point s of
// the display's plane at the slope S = E.xy / E.z - s (1 / E.z - vergence). A scene point on this line of sight has the
// position s + (S - S_v) w in view v. The disparity w is a length (src/view/disparity_codes.hpp).

import { kQuiltPlaces } from "./quilt";

const kCommon = `
precision highp float;
precision highp int;
precision highp sampler2D;

${kQuiltPlaces}
uniform QUILT u_views;        // linear light
uniform QUILT u_depth;        // codes of disparity, laid out like the quilt
uniform vec2 u_view_size;     // pixels
uniform ivec2 u_tiles, u_grid;
uniform vec2 u_window_centre, u_window_size;  // mm
// Axes of views. x: slope or angle of view 0; y: step between views; z: 1 if both are angles; w: what an eye sees beyond the zone
// (0: the outermost view, 1: the views again, 2: the pixels of the next lens).
uniform vec4 u_across, u_up;
uniform float u_vergence, u_disparity_scale;
uniform vec3 u_eye;           // mm
#if OVERLAY
uniform QUILT u_provenance;      // codes of provenance, laid out like the quilt
uniform vec4 u_tints[8];         // colour and opacity for each code
#endif

vec2 slope_at(vec2 s) { return u_eye.xy / u_eye.z - s * (1.0 / u_eye.z - u_vergence); }

// Returns the position of a slope among the views of an axis. View v has the position v.
float view_place(vec4 axis, float slope) {
#if BY_ANGLE
  if (axis.z > 0.5) slope = atan(slope);
#endif
  return axis.y == 0.0 ? 0.0 : (slope - axis.x) / axis.y;
}
vec2 view_places(vec2 slope) { return vec2(view_place(u_across, slope.x), view_place(u_up, slope.y)); }

float view_slope(vec4 axis, float view) {
  float place = axis.x + axis.y * view;
#if BY_ANGLE
  if (axis.z > 0.5) return tan(place);
#endif
  return place;
}
vec2 view_slopes(ivec2 view) { return vec2(view_slope(u_across, float(view.x)), view_slope(u_up, float(view.y))); }

// Converts a point of the display from mm to pixels of a view, from the top left.
vec2 pixel_of(vec2 s) {
  vec2 share = (s - u_window_centre) / u_window_size;
  return vec2(share.x + 0.5, 0.5 - share.y) * u_view_size;
}
bool inside(vec2 pixel) {
  return all(greaterThanEqual(pixel, vec2(-0.001))) && all(lessThanEqual(pixel, u_view_size + 0.001));
}

vec3 tile_of(ivec2 view) {
  float index = float(view.y * u_grid.x + view.x), columns = float(u_tiles.x);
  float row = floor((index + 0.5) / columns);
  return place_of_tile(vec2(index - row * columns, float(u_tiles.y) - 1.0 - row), u_view_size, vec2(u_tiles));
}
#if OVERLAY
// The tint has nearly the luminance of the colour, so that the picture stays readable.
vec3 with_origin(vec3 seen, vec3 tile, vec2 pixel) {
  vec4 tint = u_tints[int(texel_of(u_provenance, tile, pixel).r * 255.0 + 0.5) & 7];
  return mix(seen, tint.rgb * (0.2 + 0.8 * dot(seen, vec3(0.2126, 0.7152, 0.0722))), tint.a);
}
#endif
vec3 in_view(ivec2 view, vec2 pixel) {
  vec3 tile = tile_of(view);
  vec2 place = tile.xy + clamp(pixel, vec2(0.5), u_view_size - 0.5);
#if LAYERED
  vec3 seen = texture(u_views, vec3(place / (u_view_size * vec2(u_layer_tiles)), tile.z)).rgb;
#else
  vec3 seen = texture(u_views, place / (u_view_size * vec2(u_tiles))).rgb;
#endif
#if OVERLAY
  seen = with_origin(seen, tile, clamp(floor(pixel), vec2(0.0), u_view_size - 1.0));
#endif
  return seen;
}
// Returns the disparity of a pixel, or -1e30 where there is no surface.
float disparity_in_tile(vec3 tile, vec2 pixel) {
  vec2 at = clamp(floor(pixel), vec2(0.0), u_view_size - 1.0);
  vec2 bytes = floor(texel_of(u_depth, tile, at).rg * 255.0 + 0.5);
  float code = bytes.x * 256.0 + bytes.y;
  if (code < 0.5) return -1e30;
  float t = (code - 1.0) / 32767.0 - 1.0;
  return u_disparity_scale * t / max(1.0 - abs(t), 1e-6);
}
float disparity_in_view(ivec2 view, vec2 pixel) { return disparity_in_tile(tile_of(view), pixel); }
`;

/** Features of the shader. They are selected at compile time, because every branch of a shader takes time without a
 *  GPU. */
export interface Variant {
  byAngle: boolean;
  rows: boolean;
  depth: boolean;
  task: "eye" | "refocus" | "line" | "find";
  /** Writes codes to the screen and applies the exposure; otherwise writes linear light to a target. */
  screen: boolean;
  /** Rounds positions to the centres of lenses. */
  snap: boolean;
  /** Adds the light of neighbouring pixels. */
  crosstalk: boolean;
  /** Green tint for depths that the display shows sharply, red tint for depths that it blurs. */
  budget: boolean;
  overlay: boolean;
  layered: boolean;
}

const kTasks = ["eye", "refocus", "line", "find"];

const preamble = (variant: Variant): string => `#version 300 es
#define BY_ANGLE ${Number(variant.byAngle)}
#define ROWS ${Number(variant.rows)}
#define DEPTH ${Number(variant.depth)}
#define TASK ${kTasks.indexOf(variant.task)}
#define SCREEN ${Number(variant.screen)}
#define SNAP ${Number(variant.snap)}
#define CROSSTALK ${Number(variant.crosstalk)}
#define BUDGET ${Number(variant.budget)}
#define OVERLAY ${Number(variant.overlay)}
#define LAYERED ${Number(variant.layered)}
`;

const kSrgb = `
vec3 srgb(vec3 linear) {
  vec3 v = clamp(linear, 0.0, 1.0);
  return mix(12.92 * v, 1.055 * pow(v, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, v));
}
`;

export const eyeShader = (variant: Variant): string => `${preamble(variant)}${kCommon}${kSrgb}
uniform vec2 u_output_size, u_offset;  // size of the picture, and its offset in the target, in pixels
uniform float u_exposure;
uniform bvec2 u_snap;           // snap to the centres of lenses
uniform vec2 u_disparities; // lowest and highest disparity
uniform float u_aperture, u_focus; // aperture: share of the viewing zone; focus: disparity
uniform float u_line;           // 0 ... 1 from the top: line of an epipolar-plane image, whose rows are eyes
uniform vec2 u_point;           // point that the focus finder examines, mm
uniform float u_sigma;          // sigma of the crosstalk, views
uniform float u_budget;         // depth budget on either side of the plane, mm
out vec4 color;

// Follows a line of sight from front to back through the depth of a view. s: point of the line on the display. apart: slope of the line
// minus slope of the view. Returns the disparity of the first surface on the line, and 1 if the view sees that point, else 0.
// The line may pass behind a nearer surface of the view. If it does not come out again, the view does not see the point.
vec2 meet(ivec2 view, vec2 s, vec2 apart) {
  vec3 tile = tile_of(view);
  vec2 start = pixel_of(s), per_disparity = apart * vec2(1.0, -1.0) * u_view_size / u_window_size;
  float range = u_disparities.y - u_disparities.x, per = max(abs(per_disparity.x), abs(per_disparity.y));
  int steps = clamp(int(ceil(per * range)), 1, 40);
  float step_w = range / float(steps), w = u_disparities.y, before = w;
  bool hidden = false;
  for (int edges = 0, i = 0; edges < 3 && i <= steps; ++edges) {
    float at = w;
    for (; i <= steps; ++i) {
      at = max(disparity_in_tile(tile, start + per_disparity * w), u_disparities.x);
      bool behind = at - w >= -1e-4 * range;
      if (behind && !hidden) break;
      hidden = behind;
      w -= step_w;
    }
    if (i > steps) break;
    // The line has passed behind a surface between the last two steps.
    float near = i == 0 ? w : w + step_w, far = w;
    for (int j = 0; j < 3; ++j) {
      float middle = 0.5 * (near + far);
      float there = max(disparity_in_tile(tile, start + per_disparity * middle), u_disparities.x);
      if (there >= middle) far = middle, at = there;
      else near = middle;
    }
    if (per * (at - far) < 0.75) return vec2(at, 1.0);
    before = near;
    hidden = true;
    w -= step_w;
    ++i;
  }
  return hidden ? vec2(before, 0.0) : vec2(u_disparities.x, 1.0);
}

#if BUDGET
// Tints a pixel green up to half the depth budget, yellow at the budget, and red from twice the budget.
vec3 tinted(ivec2 view, vec2 pixel, float disparity) {
  vec3 seen = in_view(view, pixel);
  if (disparity_in_view(view, pixel) < -1e29) return seen;
  float share = abs(disparity / max(1.0 + disparity * u_vergence, 0.02)) / u_budget;
  vec3 tint = mix(vec3(0.02, 0.6, 0.08), vec3(0.9, 0.55, 0.02), clamp(2.0 * share - 1.0, 0.0, 1.0));
  tint = mix(tint, vec3(0.8, 0.02, 0.01), clamp(share - 1.0, 0.0, 1.0));
  return mix(seen, tint * (0.12 + 0.88 * dot(seen, vec3(0.2126, 0.7152, 0.0722))), 0.7);
}
#endif

#if DEPTH
// Interpolates a view. Leaves out texels that are nearer than the sample, because they belong to another surface.
// per_disparity: motion in pixels per unit of disparity. A texel has no weight if its disparity moves it by 3/4 pixel
// or more relative to the sample.
vec3 in_view_behind(ivec2 view, vec2 pixel, vec2 per_disparity) {
  vec3 tile = tile_of(view);
  vec2 last = u_view_size - 1.0, at = clamp(pixel, vec2(0.5), u_view_size - 0.5) - 0.5, first = floor(at), share = at - first;
  vec2 next = min(first + 1.0, last);
  vec4 disparities = vec4(disparity_in_tile(tile, first), disparity_in_tile(tile, vec2(next.x, first.y)), disparity_in_tile(tile, vec2(first.x, next.y)), disparity_in_tile(tile, next));
  vec2 row = share.y < 0.5 ? disparities.xy : disparities.zw;
  float own = share.x < 0.5 ? row.x : row.y;
  // The difference is very large where a neighbour has a surface but the sample's own texel has none.
  vec4 moved = max(abs(per_disparity.x), abs(per_disparity.y)) * (disparities - own);
  if (all(lessThan(moved, vec4(0.25)))) return in_view(view, pixel);
  vec2 rest = 1.0 - share;
  vec4 weights = vec4(rest.x * rest.y, share.x * rest.y, rest.x * share.y, share.x * share.y) * (1.0 - smoothstep(0.25, 0.75, moved));
  vec3 sum = weights.x * texel_of(u_views, tile, first).rgb + weights.y * texel_of(u_views, tile, vec2(next.x, first.y)).rgb;
  sum += weights.z * texel_of(u_views, tile, vec2(first.x, next.y)).rgb + weights.w * texel_of(u_views, tile, next).rgb;
  vec3 seen = sum / (weights.x + weights.y + weights.z + weights.w);
#if OVERLAY
  seen = with_origin(seen, tile, clamp(floor(pixel), vec2(0.0), last));
#endif
  return seen;
}
#endif

vec3 in_view_at(ivec2 view, vec2 s, vec2 slope, out float weight) {
  weight = 1.0;
#if DEPTH
  vec2 apart = slope - view_slopes(view);
  vec2 met = meet(view, s, apart);
  s += apart * met.x;
  weight = met.y > 0.5 ? 1.0 : 0.01;
#if BUDGET
  return tinted(view, pixel_of(s), met.x);
#endif
  return in_view_behind(view, pixel_of(s), apart * u_view_size / u_window_size);
#else
  return in_view(view, pixel_of(s));
#endif
}

vec3 between_views(vec2 s, vec2 slope, vec2 place) {
  vec2 last = vec2(u_grid - 1);
  vec2 near = clamp(place, vec2(0.0), last);
  ivec2 first = ivec2(min(floor(near), max(last - 1.0, vec2(0.0))));
  vec2 share = near - vec2(first);
  ivec2 right = ivec2(min(1, u_grid.x - 1), 0);
  vec4 weight;
  vec3 a = in_view_at(first, s, slope, weight.x), b = in_view_at(first + right, s, slope, weight.y);
  weight.xy *= vec2(1.0 - share.x, share.x);
#if ROWS
  ivec2 above = ivec2(0, min(1, u_grid.y - 1));
  vec3 c = in_view_at(first + above, s, slope, weight.z), d = in_view_at(first + right + above, s, slope, weight.w);
  weight *= vec4(vec2(1.0 - share.y), vec2(share.y)) * vec4(1.0, 1.0, 1.0 - share.x, share.x);
  return (a * weight.x + b * weight.y + c * weight.z + d * weight.w) / max(weight.x + weight.y + weight.z + weight.w, 1e-9);
#else
  return (a * weight.x + b * weight.y) / max(weight.x + weight.y, 1e-9);
#endif
}

// Returns the position among the views that an eye sees. Beyond the viewing zone, the views may repeat. count: number of views.
// turns: number of the repeated zone in which the eye is; 0 is the viewing zone.
float wrapped(float place, float count, float beyond, out float turns) {
  turns = beyond > 0.5 ? floor((place + 0.5) / count) : 0.0;
  return place - turns * count;
}

#if CROSSTALK
// Error function with an error below 1.5e-7 (Abramowitz and Stegun, 7.1.26).
float erf(float x) {
  float t = 1.0 / (1.0 + 0.3275911 * abs(x));
  float series = t * (0.254829592 + t * (-0.284496736 + t * (1.421413741 + t * (-1.453152027 + t * 1.061405429))));
  return sign(x) * (1.0 - series * exp(-x * x));
}
// Weight of view i, which covers i ... i + 1, in a Gaussian around place, as in src/optics/crosstalk.cpp.
float share_of(float i, float place) {
  float scale = 0.70710678 / u_sigma;
  return 0.5 * (erf((i + 1.0 - place) * scale) - erf((i - place) * scale));
}
// Returns the colour that a blurry lens shows: the weighted mean of pixels around the intended one, also below the neighbouring lens.
vec3 through_lens(vec2 s, vec2 place) {
  vec2 count = vec2(u_grid), pitch = u_window_size / u_view_size, reach = vec2(4.0 * u_sigma);
#if !ROWS
  place.y = 0.0, reach.y = 0.0;
#endif
  vec2 first = floor(place + 0.5 - reach), last = floor(place + 0.5 + reach);
  bvec2 next_lens = greaterThan(vec2(u_across.w, u_up.w), vec2(1.5));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (float j = first.y; j <= last.y; ++j)
    for (float i = first.x; i <= last.x; ++i) {
      vec2 turns = floor(vec2(i, j) / count);
      vec2 pixel = pixel_of(s - pitch * turns);
      bool there = (turns.x == 0.0 || next_lens.x) && (turns.y == 0.0 || next_lens.y) && inside(pixel);
      if (!there) continue;
      float weight = u_grid.x > 1 ? share_of(i, place.x + 0.5) : 1.0;
#if ROWS
      weight *= share_of(j, place.y + 0.5);
#endif
      sum += weight * in_view(ivec2(vec2(i, j) - turns * count), pixel);
      weights += weight;
    }
  return weights > 0.0 ? sum / weights : vec3(0.0);
}
#endif

vec3 seen(vec2 s) {
  vec2 pixel = pixel_of(s);
  if (!inside(pixel)) return vec3(0.0);
#if SNAP
  vec2 middle = (floor(clamp(pixel, vec2(0.0), u_view_size - 0.5)) + 0.5) / u_view_size;
  vec2 lens = u_window_centre + vec2(middle.x - 0.5, 0.5 - middle.y) * u_window_size;
  s = vec2(u_snap.x ? lens.x : s.x, u_snap.y ? lens.y : s.y);
#endif
  vec2 slope = slope_at(s), place = view_places(slope), turns;
  place = vec2(wrapped(place.x, float(u_grid.x), u_across.w, turns.x), wrapped(place.y, float(u_grid.y), u_up.w, turns.y));
  // If the eye is to the right of a lens's zone, the lens shows pixels of its left neighbour.
  vec2 pitch = u_window_size / u_view_size;
  s -= pitch * vec2(u_across.w > 1.5 ? turns.x : 0.0, u_up.w > 1.5 ? turns.y : 0.0);
  if (!inside(pixel_of(s))) return vec3(0.0);
#if CROSSTALK
  vec2 last = vec2(u_grid - 1);
  if (u_across.w < 0.5) place.x = clamp(place.x, 0.0, last.x);
  if (u_up.w < 0.5) place.y = clamp(place.y, 0.0, last.y);
  return through_lens(s, place);
#endif
  if (turns != vec2(0.0)) slope = vec2(view_slope(u_across, place.x), view_slope(u_up, place.y));
  return between_views(s, slope, place);
}

// Averages the views within the aperture around the eye, shifted by the disparity u_focus (shift-and-sum refocusing).
vec3 refocused(vec2 s) {
  vec2 slope = slope_at(s), place = view_places(slope), half_width = 0.5 * u_aperture * vec2(u_grid);
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int j = 0; j < u_grid.y; ++j)
    for (int i = 0; i < u_grid.x; ++i) {
      vec2 reach = clamp(half_width - abs(vec2(i, j) - place) + 0.5, 0.0, 1.0);
      if (u_aperture >= 0.999) reach = vec2(1.0);
      if (u_grid.y == 1) reach.y = 1.0;
      if (reach.x * reach.y <= 0.0) continue;
      vec2 pixel = pixel_of(s + (slope - view_slopes(ivec2(i, j))) * u_focus);
      if (!inside(pixel)) continue;
      sum += reach.x * reach.y * in_view(ivec2(i, j), pixel);
      weights += reach.x * reach.y;
    }
  return weights > 0.0 ? sum / weights : vec3(0.0);
}

// Returns the variance of the views around u_point for an assumed disparity. The variance is lowest at the disparity of
// the surface. share: 0 is the lowest disparity, 1 the highest.
float disagreement(float share) {
  float w = mix(u_disparities.x, u_disparities.y, share);
  float sum = 0.0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      vec2 s = u_point + vec2(x, y) * u_window_size / u_view_size;
      vec2 slope = slope_at(s);
      vec3 mean = vec3(0.0), squares = vec3(0.0);
      float count = 0.0;
      for (int j = 0; j < u_grid.y; ++j)
        for (int i = 0; i < u_grid.x; ++i) {
          vec2 pixel = pixel_of(s + (slope - view_slopes(ivec2(i, j))) * w);
          if (!inside(pixel)) continue;
          vec3 c = in_view(ivec2(i, j), pixel);
          mean += c, squares += c * c, count += 1.0;
        }
      if (count > 1.0) sum += dot(squares / count - mean * mean / (count * count), vec3(1.0));
    }
  return sum;
}

void main() {
  vec2 share = (gl_FragCoord.xy - u_offset) / u_output_size;
  vec2 s = u_window_centre + (share - 0.5) * u_window_size;
#if TASK == 0
  color = vec4(seen(s), 1.0);
#elif TASK == 1
  color = vec4(refocused(s), 1.0);
#elif TASK == 2
  // Epipolar-plane image: rows are eyes, evenly spread over the zone, with the leftmost at the top.
  s.y = u_window_centre.y + (0.5 - u_line) * u_window_size.y;
  float place = clamp((1.0 - share.y) * float(u_grid.x) - 0.5, 0.0, float(u_grid.x - 1));
  float up = clamp(view_places(slope_at(s)).y, 0.0, float(u_grid.y - 1));
  color = vec4(between_views(s, vec2(view_slope(u_across, place), view_slope(u_up, up)), vec2(place, up)), 1.0);
#elif DEPTH
  vec2 slope = slope_at(u_point);
  ivec2 view = ivec2(clamp(floor(view_places(slope) + 0.5), vec2(0.0), vec2(u_grid - 1)));
  color = vec4(meet(view, u_point, slope - view_slopes(view)).x);
#else
  color = vec4(disagreement(share.x));
#endif
#if SCREEN
  color.rgb = srgb(u_exposure * color.rgb);
#endif
}
`;

/** Renders what the panel shows without lenses, in linear light. */
export const panelShader = ({ overlay, layered }: Pick<Variant, "overlay" | "layered">): string => `#version 300 es
#define BY_ANGLE 0
#define OVERLAY ${Number(overlay)}
#define LAYERED ${Number(layered)}
${kCommon}
uniform sampler2D u_panel;  // the panel's own picture
uniform vec2 u_output_size, u_panel_size;
uniform vec2 u_samples;     // pixels of a whole view; previews and first pictures have fewer
uniform int u_kind;         // 0: integral image, 1: quilt, 2: the panel's own picture
uniform vec4 u_part;        // shown part of the panel: left, top, width, height, in pixels
uniform vec4 u_loupe;       // x, y, radius in pixels of the output from its top left; magnification
uniform vec2 u_loupe_at;    // the panel pixel in the middle of the loupe
out vec4 color;

vec3 panel_pixel(ivec2 p) {
  if (any(lessThan(p, ivec2(0))) || any(greaterThanEqual(p, ivec2(u_panel_size)))) return vec3(0.0);
  if (u_kind == 2) return texelFetch(u_panel, p, 0).rgb;
  if (u_kind == 1) {
    // A quilt may have padding at the top and right. The server does not send it, so it is black.
    vec2 q = (vec2(p) + 0.5 - vec2(0.0, u_panel_size.y - float(u_tiles.y) * u_samples.y)) * (u_view_size / u_samples);
    if (q.y < 0.0 || q.x >= float(u_tiles.x) * u_view_size.x) return vec3(0.0);
    vec2 column_row = floor(q / u_view_size), pixel = floor(q) - column_row * u_view_size;
    vec3 tile = place_of_tile(column_row, u_view_size, vec2(u_tiles)), seen = texel_of(u_views, tile, pixel).rgb;
#if OVERLAY
    seen = with_origin(seen, tile, pixel);
#endif
    return seen;
  }
  // A lens rotates the pixels below it by 180 degrees: its rightmost pixel is seen from the left, its topmost pixel
  // from below.
  ivec2 cell = p / u_grid, in_cell = p - cell * u_grid;
  ivec2 view = ivec2(u_grid.x - 1 - in_cell.x, in_cell.y);
  if (u_grid.y == 1) view.y = 0;
  return in_view(view, (vec2(cell) + 0.5) * (u_view_size / u_samples));
}

void main() {
  vec2 at = vec2(gl_FragCoord.x, u_output_size.y - gl_FragCoord.y);
  vec2 panel = u_part.xy + at / u_output_size * u_part.zw;
  vec2 from_loupe = at - u_loupe.xy;
  float reach = max(abs(from_loupe.x), abs(from_loupe.y));
  if (u_loupe.z > 0.0 && reach < u_loupe.z) {
    vec2 place = u_loupe_at + from_loupe / u_loupe.w;
    vec3 c = panel_pixel(ivec2(floor(place)));
    if (u_kind == 0) {
      vec2 to_edge = abs(fract(place / vec2(u_grid) + 0.5) - 0.5) * vec2(u_grid) * u_loupe.w;
      bool marked = ivec2(floor(place / vec2(u_grid))) == ivec2(floor(u_loupe_at / vec2(u_grid)));
      bool edge = to_edge.x < 1.0 || (u_grid.y > 1 && to_edge.y < 1.0);
      if (edge) c = mix(c, marked ? vec3(1.0, 0.55, 0.05) : vec3(0.5), 0.8);
      else if (!marked) c *= 0.45;
    }
    color = vec4(reach > u_loupe.z - 1.5 ? vec3(0.6) : c, 1.0);
    return;
  }
  // If an output pixel covers several pixels of the panel, averages up to 4 x 4 of them.
  vec2 size = u_part.zw / u_output_size;
  vec3 sum = vec3(0.0);
  int n = clamp(int(ceil(max(size.x, size.y))), 1, 4);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      sum += panel_pixel(ivec2(floor(panel + ((vec2(i, j) + 0.5) / float(n) - 0.5) * size)));
  color = vec4(sum / float(n * n), 1.0);
}
`;

export const kFrameShader = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D u_frame;
out vec4 color;
void main() { color = texelFetch(u_frame, ivec2(gl_FragCoord.xy), 0); }
`;

/** Vertex shader that places the display's window in a headset's picture. */
export const kWindowVertices = `#version 300 es
uniform mat4 u_clip_from_display;
uniform vec2 u_window_centre, u_window_size;  // mm
out vec2 share;
void main() {
  share = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = u_clip_from_display * vec4(u_window_centre + (share - 0.5) * u_window_size, 0.0, 1.0);
}
`;
export const kWindowShader = `#version 300 es
precision highp float;
precision highp sampler2D;
uniform sampler2D u_first;
uniform float u_exposure;
in vec2 share;
out vec4 color;
${kSrgb}
void main() { color = vec4(srgb(u_exposure * texture(u_first, share).rgb), 1.0); }
`;

/** Ways to compose the canvas from one or two pictures. */
export const kScreenModes = ["first", "anaglyph", "wipe", "difference", "beside", "above"] as const;
export type ScreenMode = (typeof kScreenModes)[number];

export const screenShader = (mode: ScreenMode): string => `#version 300 es
#define MODE ${kScreenModes.indexOf(mode)}
precision highp float;
precision highp int;
precision highp sampler2D;
uniform sampler2D u_first, u_second;
uniform vec4 u_place;    // rectangle of the picture on the canvas: left, bottom, width and height, in pixels
uniform float u_wipe, u_exposure, u_scale;
uniform vec3 u_ground;
out vec4 color;

${kSrgb}
vec3 first(vec2 at) { return srgb(u_exposure * texture(u_first, at).rgb); }
vec3 second(vec2 at) { return srgb(u_exposure * texture(u_second, at).rgb); }

#if MODE == 3
// From black through blue, red and yellow to white, for t from 0 to 1.
vec3 heat(float t) {
  vec3 c = mix(vec3(0.01, 0.01, 0.06), vec3(0.16, 0.12, 0.55), smoothstep(0.0, 0.25, t));
  c = mix(c, vec3(0.72, 0.15, 0.42), smoothstep(0.2, 0.5, t));
  c = mix(c, vec3(0.98, 0.60, 0.12), smoothstep(0.45, 0.75, t));
  return mix(c, vec3(1.0, 0.98, 0.85), smoothstep(0.7, 1.0, t));
}
#endif

void main() {
  vec2 at = (gl_FragCoord.xy - u_place.xy) / u_place.zw;
  if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) {
    color = vec4(u_ground, 1.0);
    return;
  }
  vec3 c;
#if MODE == 1
    // The luminance of the left eye's picture strains the eyes less than its red channel.
    c = vec3(dot(first(at), vec3(0.299, 0.587, 0.114)), second(at).gb);
#elif MODE == 2
    c = at.x < u_wipe ? first(at) : second(at);
    if (abs(at.x - u_wipe) * u_place.z < 1.0) c = vec3(1.0);
#elif MODE == 3
    vec3 d = abs(first(at) - second(at)) * 255.0;
    c = heat(clamp(max(d.r, max(d.g, d.b)) / u_scale, 0.0, 1.0));
#elif MODE == 4
    c = at.x < 0.5 ? first(vec2(2.0 * at.x, at.y)) : second(vec2(2.0 * at.x - 1.0, at.y));
#elif MODE == 5
    c = at.y > 0.5 ? first(vec2(at.x, 2.0 * at.y - 1.0)) : second(vec2(at.x, 2.0 * at.y));
#else
  c = first(at);
#endif
  color = vec4(c, 1.0);
}
`;
