import { Refusal } from "./field";

export type Gl = WebGL2RenderingContext;

export function openGl(canvas: HTMLCanvasElement): Gl {
  const gl = canvas.getContext("webgl2", { alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true });
  if (!gl) throw new Refusal("This browser has no WebGL 2, which this page needs. Any current browser with graphics enabled has it.");
  gl.getExtension("EXT_color_buffer_float");
  gl.pixelStorei(gl.UNPACK_COLORSPACE_CONVERSION_WEBGL, gl.NONE);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  return gl;
}

function compile(gl: Gl, kind: number, source: string): WebGLShader {
  const shader = gl.createShader(kind) as WebGLShader;
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
    throw new Error(`shader: ${gl.getShaderInfoLog(shader)}`);
  return shader;
}

export type Uniform = number | boolean | readonly number[] | { integers: readonly number[] } | { unit: number };

const kCovering = `#version 300 es
  void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    gl_Position = vec4(corner, 0.0, 1.0);
  }`;

/** A fragment shader that runs for every pixel of the target, or of the polygon whose corners a vertex shader returns. */
export class Program {
  private readonly program: WebGLProgram;
  private readonly places = new Map<string, WebGLUniformLocation | null>();

  constructor(
    private readonly gl: Gl,
    fragment: string,
    vertex = kCovering,
  ) {
    this.program = gl.createProgram() as WebGLProgram;
    gl.attachShader(this.program, compile(gl, gl.VERTEX_SHADER, vertex));
    gl.attachShader(this.program, compile(gl, gl.FRAGMENT_SHADER, fragment));
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error(`program: ${gl.getProgramInfoLog(this.program)}`);
  }

  draw(uniforms: Record<string, Uniform>, corners = 3): void {
    const gl = this.gl;
    gl.useProgram(this.program);
    for (const [name, value] of Object.entries(uniforms)) this.setUniform(name, value);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, corners);
  }

  private setUniform(name: string, value: Uniform): void {
    const gl = this.gl;
    if (!this.places.has(name)) this.places.set(name, gl.getUniformLocation(this.program, name));
    const place = this.places.get(name) as WebGLUniformLocation | null;
    if (place === null) return;
    if (typeof value === "boolean") gl.uniform1i(place, value ? 1 : 0);
    else if (typeof value === "number") gl.uniform1f(place, value);
    else if ("unit" in value) gl.uniform1i(place, value.unit);
    else if ("integers" in value) {
      if (value.integers.length === 1) gl.uniform1i(place, value.integers[0]);
      else gl.uniform2i(place, value.integers[0], value.integers[1]);
    } else if (value.length === 2) gl.uniform2fv(place, value);
    else if (value.length === 3) gl.uniform3fv(place, value);
    else if (value.length === 16) gl.uniformMatrix4fv(place, false, value);
    else gl.uniform4fv(place, value);
  }
}

export function bind(gl: Gl, unit: number, texture: WebGLTexture | null): { unit: number } {
  gl.activeTexture(gl.TEXTURE0 + unit);
  gl.bindTexture(gl.TEXTURE_2D, texture);
  return { unit };
}

export function setFilter(gl: Gl, filter: number, target: number = gl.TEXTURE_2D): void {
  for (const key of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(target, key, filter);
  for (const key of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(target, key, gl.CLAMP_TO_EDGE);
}

/** Makes a texture whose first row is the top row of the picture. Shaders sample "srgb" codes as linear light, and other
 *  codes unchanged. */
export function pictureTexture(gl: Gl, picture: ImageBitmap, holds: "srgb" | "codes"): WebGLTexture {
  const texture = gl.createTexture() as WebGLTexture;
  bind(gl, 0, texture);
  if (holds === "srgb") gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  else gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  setFilter(gl, holds === "srgb" ? gl.LINEAR : gl.NEAREST);
  return texture;
}

/** The texture has two 32-bit words per texel. */
export function wordTexture(gl: Gl, width: number, height: number, words: Uint32Array): WebGLTexture {
  const texture = gl.createTexture() as WebGLTexture;
  bind(gl, 0, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG32UI, width, height, 0, gl.RG_INTEGER, gl.UNSIGNED_INT, words);
  setFilter(gl, gl.NEAREST);
  return texture;
}

/** A render target of 8-bit codes, bottom row first. */
export class CodeTarget {
  private readonly texture: WebGLTexture;
  private readonly framebuffer: WebGLFramebuffer;

  constructor(
    private readonly gl: Gl,
    width: number,
    height: number,
  ) {
    this.texture = gl.createTexture() as WebGLTexture;
    bind(gl, 0, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    setFilter(gl, gl.NEAREST);
    this.framebuffer = gl.createFramebuffer() as WebGLFramebuffer;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
    gl.viewport(0, 0, width, height);
  }

  end(): WebGLTexture {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);
    this.gl.deleteFramebuffer(this.framebuffer);
    return this.texture;
  }
}

/** A render target, bottom row first. Stores linear light if the device supports such targets. */
export class Target {
  readonly texture: WebGLTexture;
  readonly framebuffer: WebGLFramebuffer;
  private size: [number, number] = [0, 0];

  constructor(private readonly gl: Gl) {
    this.texture = gl.createTexture() as WebGLTexture;
    this.framebuffer = gl.createFramebuffer() as WebGLFramebuffer;
  }

  get width(): number {
    return this.size[0];
  }
  get height(): number {
    return this.size[1];
  }

  begin(width: number, height: number): void {
    const gl = this.gl;
    if (this.size[0] !== width || this.size[1] !== height) {
      bind(gl, 0, this.texture);
      if (gl.getExtension("EXT_color_buffer_float"))
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA16F, width, height, 0, gl.RGBA, gl.HALF_FLOAT, null);
      else gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
      setFilter(gl, gl.LINEAR);
      gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
      this.size = [width, height];
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.viewport(0, 0, width, height);
  }

  /** Returns linear RGBA, bottom row first. */
  read(x: number, y: number, width: number, height: number): Float32Array {
    const gl = this.gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    const values = new Float32Array(width * height * 4);
    if (gl.getExtension("EXT_color_buffer_float")) {
      gl.readPixels(x, y, width, height, gl.RGBA, gl.FLOAT, values);
      return values;
    }
    const codes = new Uint8Array(values.length);
    gl.readPixels(x, y, width, height, gl.RGBA, gl.UNSIGNED_BYTE, codes);
    return values.map((_, i) => linearFromCode(codes[i]));
  }
}

export const linearFromCode = (code: number): number => {
  const v = code / 255;
  return v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4;
};

export const codeFromLinear = (linear: number): number => {
  const v = Math.min(Math.max(linear, 0), 1);
  return Math.floor(255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055) + 0.5);
};
