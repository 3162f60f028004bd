// Quilts on the GPU: one texture, or layers of whole tiles if the quilt exceeds the GPU's texture size.
import { bind, setFilter, type Gl } from "./gl";

/** Tiles of a layer, (across, down); null: the quilt is a single texture. */
export type LayerTiles = [number, number] | null;

export type Holds = "srgb" | "codes" | "indices";

const kFormats = {
  srgb: (gl: Gl) => [gl.SRGB8_ALPHA8, gl.RGBA],
  codes: (gl: Gl) => [gl.RGBA8, gl.RGBA],
  indices: (gl: Gl) => [gl.R8, gl.RED],
};

interface Size {
  width: number;
  height: number;
}

/** Returns the largest layer that fits into a texture. A single view always fits. */
export function layerTiles(gl: Gl, { width, height }: Size, tiles: readonly [number, number]): LayerTiles {
  const most = gl.getParameter(gl.MAX_TEXTURE_SIZE) as number;
  if (Math.max(width, height) <= most) return null;
  const fitting = (side: number, count: number) => Math.min(count, Math.max(1, Math.floor(most / (side / count))));
  return [fitting(width, tiles[0]), fitting(height, tiles[1])];
}

/** Makes a texture whose first row is the top row of the picture. Shaders sample "srgb" codes as linear light, and other
 *  numbers unchanged. */
export function quiltTexture(gl: Gl, picture: ImageBitmap, tiles: readonly [number, number], holds: Holds): WebGLTexture {
  const [stored, sent] = kFormats[holds](gl);
  const layer = layerTiles(gl, picture, tiles);
  const texture = gl.createTexture() as WebGLTexture;
  bindQuilt(gl, 0, texture, layer);
  if (layer) sendLayers(gl, picture, tiles, layer, [stored, sent]);
  else gl.texImage2D(gl.TEXTURE_2D, 0, stored, sent, gl.UNSIGNED_BYTE, picture);
  setFilter(gl, holds === "srgb" ? gl.LINEAR : gl.NEAREST, layer ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D);
  return texture;
}

/** Uploads layers row by row from the top left. The last layer of a row or column may be partly filled. */
function sendLayers(gl: Gl, picture: ImageBitmap, tiles: readonly [number, number], layer: [number, number], [stored, sent]: number[]): void {
  const view = [picture.width / tiles[0], picture.height / tiles[1]];
  const [width, height] = [view[0] * layer[0], view[1] * layer[1]];
  const [across, down] = [Math.ceil(tiles[0] / layer[0]), Math.ceil(tiles[1] / layer[1])];
  gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, stored, width, height, across * down);
  for (let i = 0; i < across * down; i++) {
    const [left, top] = [(i % across) * width, Math.floor(i / across) * height];
    gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, left);
    gl.pixelStorei(gl.UNPACK_SKIP_ROWS, top);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, i, Math.min(width, picture.width - left), Math.min(height, picture.height - top), 1, sent, gl.UNSIGNED_BYTE, picture);
  }
  gl.pixelStorei(gl.UNPACK_SKIP_PIXELS, 0);
  gl.pixelStorei(gl.UNPACK_SKIP_ROWS, 0);
}

export function bindQuilt(gl: Gl, unit: number, texture: WebGLTexture | null, layer: LayerTiles): { unit: number } {
  if (!layer) return bind(gl, unit, texture);
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D_ARRAY, texture);
  return { unit };
}

/** GLSL that locates tiles. Insert it after u_tiles and u_view_size (floats). With LAYERED, u_layer_tiles holds the tiles of
 *  a layer. */
export const kQuiltPlaces = `
#if LAYERED
#define QUILT sampler2DArray
precision highp sampler2DArray;
uniform ivec2 u_layer_tiles;
#else
#define QUILT sampler2D
#endif
// Returns a tile's position (x, y) in pixels, from the top left, and its layer. Integer division would be slow without a GPU.
vec3 place_of_tile(vec2 tile, vec2 view_size, vec2 tiles) {
#if LAYERED
  vec2 size = vec2(u_layer_tiles), layer = floor((tile + 0.5) / size);
  return vec3((tile - layer * size) * view_size, layer.y * ceil(tiles.x / size.x) + layer.x);
#else
  return vec3(tile * view_size, 0.0);
#endif
}
vec4 texel_of(QUILT quilt, vec3 tile, vec2 pixel) {
#if LAYERED
  return texelFetch(quilt, ivec3(tile.xy + pixel, tile.z), 0);
#else
  return texelFetch(quilt, ivec2(tile.xy + pixel), 0);
#endif
}
`;
