// Interlaces views for a panel, as `lippmann convert --to native` does. The position of a sub-pixel below its lens, called
// phase, selects the view. The phase is the fractional part of a row term plus a column term. Both terms are tables of 64-bit
// fractions, because single precision is too coarse for hundreds of lenses.
import type { PanelDisplay } from "./display";
import { Refusal, type Field } from "./field";
import { bind, CodeTarget, Program, wordTexture, type Gl, type Uniform } from "./gl";
import { bindQuilt, kQuiltPlaces, type LayerTiles } from "./quilt";

const kFilters = ["nearest", "linear", "gaussian", "as they are"] as const;
type Filter = (typeof kFilters)[number];

const shader = (filter: Filter, layered: boolean): string => `#version 300 es
#define FILTER ${kFilters.indexOf(filter)}
#define LAYERED ${Number(layered)}
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
${kQuiltPlaces}
uniform QUILT u_views;            // codes: the quilt, or the panel's own picture
// The phase of a sub-pixel is the sum of a term of its row and a term of its column, as 64-bit fractions. Each row, counted from the
// bottom, has six terms: red, green and blue of even pixels, then of odd pixels.
uniform usampler2D u_rows;
uniform usampler2D u_columns;
uniform ivec2 u_view_size, u_tiles, u_panel_size;
uniform int u_count;
uniform bool u_inverted;
uniform float u_sigma;
out vec4 color;

// Multiplies a 64-bit fraction by the number of views. Returns the integer part, and 32 bits of the fraction.
uvec2 view_place(uvec2 fraction) {
  uint count = uint(u_count);
  uint lower = ((fraction.y >> 16u) * count + (((fraction.y & 0xffffu) * count) >> 16u)) >> 16u;
  uint middle = (fraction.x & 0xffffu) * count + lower;
  uint upper = (fraction.x >> 16u) * count + (middle >> 16u);
  return uvec2(upper >> 16u, (upper << 16u) | (middle & 0xffffu));
}

// For N views, returns the integer part and the fraction of v N for a sub-pixel. v is the phase, or 1 minus the phase
// on inverted panels. v = 1 belongs to the last view.
uvec2 view_of(ivec2 pixel, int channel) {
  uvec2 row = texelFetch(u_rows, ivec2(3 * (pixel.x & 1) + channel, pixel.y), 0).xy;
  uvec2 column = texelFetch(u_columns, ivec2(pixel.x, 0), 0).xy;
  uint low = row.y + column.y;
  uvec2 z = uvec2(row.x + column.x + (low < row.y ? 1u : 0u), low);
  if (!u_inverted) return view_place(z);
  if (z == uvec2(0u)) return uvec2(uint(u_count), 0u);
  return view_place(uvec2(~z.x + (z.y == 0u ? 1u : 0u), ~z.y + 1u));
}

vec3 origin_of(int view) {
  return place_of_tile(vec2(view % u_tiles.x, u_tiles.y - 1 - view / u_tiles.x), vec2(u_view_size), vec2(u_tiles));
}
float code(vec3 origin, ivec2 at, int channel) { return texel_of(u_views, origin, vec2(at))[channel]; }

float nearest(int view, ivec2 pixel, int channel) {
  ivec2 from_top = ivec2(pixel.x, u_panel_size.y - 1 - pixel.y);
  return code(origin_of(view), ((2 * from_top + 1) * u_view_size) / (2 * u_panel_size), channel);
}

float bilinear(int view, ivec2 pixel, int channel) {
  vec2 from_top = vec2(pixel.x, u_panel_size.y - 1 - pixel.y) + 0.5;
  vec2 place = clamp(from_top * vec2(u_view_size) / vec2(u_panel_size) - 0.5, vec2(0.0), vec2(u_view_size - 1));
  ivec2 at = ivec2(place), next = min(at + 1, u_view_size - 1);
  vec3 origin = origin_of(view);
  vec2 share = place - vec2(at);
  float top = mix(code(origin, at, channel), code(origin, ivec2(next.x, at.y), channel), share.x);
  float below = mix(code(origin, ivec2(at.x, next.y), channel), code(origin, next, channel), share.x);
  return mix(top, below, share.y);
}

float between(uvec2 place, ivec2 pixel, int channel) {
  // View n of N covers the phases from n / N to (n + 1) / N. Its centre is at the phase (n + 1/2) / N.
  int view = int(place.x) - (place.y < 0x80000000u ? 1 : 0);
  float share = float(place.y ^ 0x80000000u) / 4294967296.0;
  if (view < 0) view = 0, share = 0.0;
  if (view >= u_count - 1) view = u_count - 1, share = 0.0;
#if FILTER == 1
  float here = bilinear(view, pixel, channel);
  return share == 0.0 ? here : mix(here, bilinear(view + 1, pixel, channel), share);
#else
  float reach = 3.0 * u_sigma + 0.5, sum = 0.0, weights = 0.0;
  int last = min(u_count - 1 - view, int(floor(share + reach)));
  for (int i = max(-view, int(ceil(share - reach))); i <= last; ++i) {
    float away = (float(i) - share) / u_sigma, weight = exp(-0.5 * away * away);
    sum += weight * bilinear(view + i, pixel, channel), weights += weight;
  }
  return sum / weights;
#endif
}

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 codes;
#if FILTER == 3
  codes = texel_of(u_views, vec3(0.0), vec2(pixel.x, u_panel_size.y - 1 - pixel.y)).rgb;
#else
  for (int channel = 0; channel < 3; ++channel) {
    uvec2 place = view_of(pixel, channel);
#if FILTER == 0
    codes[channel] = nearest(min(int(place.x), u_count - 1), pixel, channel);
#else
    codes[channel] = between(place, pixel, channel);
#endif
  }
#endif
  color = vec4(codes, 1.0);
}
`;

/** Returns the fraction of each value as 64 bits: the upper and the lower 32-bit word. */
function fractionsOf(values: number[]): Uint32Array {
  const words = new Uint32Array(2 * values.length);
  values.forEach((value, i) => {
    const upper = (value - Math.floor(value)) * 2 ** 32;
    words[2 * i] = upper;
    words[2 * i + 1] = (upper - Math.floor(upper)) * 2 ** 32;
  });
  return words;
}

/** Phases at the left end of every row, bottom row first, for each sub-pixel (src/layout/sub_pixel_views.hpp). */
export function rowPhases({ pixels, panel }: PanelDisplay): number[] {
  const phases: number[] = [];
  for (let up = 0; up < pixels[1]; up++)
    for (const pixel of panel.sub_pixels[up % 4])
      for (const [offsetX, offsetY] of pixel) {
        const x = (0.5 + offsetX) / pixels[0];
        const y = (up + 0.5 + offsetY) / pixels[1];
        phases.push((x + y * panel.tilt) * panel.periods - panel.center);
      }
  return phases;
}

export class Interlacer {
  private readonly programs = new Map<string, Program>();
  private readonly rows: WebGLTexture;
  private readonly columns: WebGLTexture;

  constructor(
    private readonly gl: Gl,
    readonly display: PanelDisplay,
  ) {
    const { pixels, panel } = display;
    const most = gl.getParameter(gl.MAX_TEXTURE_SIZE) as number;
    if (Math.max(...pixels) > most)
      throw new Refusal(`The panel has ${pixels[0]}\u00d7${pixels[1]} pixels, but this device's GPU supports at most ${most} a side.`);
    this.rows = wordTexture(gl, 6, pixels[1], fractionsOf(rowPhases(display)));
    const perPixel = panel.periods / pixels[0];
    this.columns = wordTexture(gl, pixels[0], 1, fractionsOf([...Array(pixels[0]).keys()].map((i) => i * perPixel)));
  }

  /** Returns a texture of codes, bottom row first. */
  fromViews(field: Field, views: WebGLTexture, viewSize: [number, number], layer: LayerTiles): WebGLTexture {
    return this.draw(this.display.filter, views, layer, {
      u_layer_tiles: { integers: layer ?? field.tiles },
      u_view_size: { integers: viewSize.map(Math.floor) },
      u_tiles: { integers: field.tiles },
      u_count: { integers: [field.across.views] },
      u_inverted: this.display.panel.inverted,
      u_sigma: this.display.sigma_views,
    });
  }

  /** A picture that was made for this panel needs no interlacing. */
  fromOwn(picture: WebGLTexture): WebGLTexture {
    return this.draw("as they are", picture, null, {});
  }

  private draw(filter: Filter, pictures: WebGLTexture, layer: LayerTiles, uniforms: Record<string, Uniform>): WebGLTexture {
    const gl = this.gl;
    const { pixels } = this.display;
    const key = `${filter}${layer ? ", layered" : ""}`;
    const program = this.programs.get(key) ?? new Program(gl, shader(filter, layer !== null));
    this.programs.set(key, program);
    const target = new CodeTarget(gl, pixels[0], pixels[1]);
    program.draw({
      ...uniforms,
      u_views: bindQuilt(gl, 0, pictures, layer),
      u_rows: bind(gl, 1, this.rows),
      u_columns: bind(gl, 2, this.columns),
      u_panel_size: { integers: pixels },
    });
    return target.end();
  }

  dispose(): void {
    for (const texture of [this.rows, this.columns]) this.gl.deleteTexture(texture);
  }
}
