/** WebGL2 in the few words that the pictures need. */

export type Uniform = number | boolean | ReadonlyArray<number> | Float32Array;

export interface Target {
  texture: WebGLTexture;
  /** Further ones that a shader writes at the same time. */
  more: WebGLTexture[];
  framebuffer: WebGLFramebuffer;
  depth: WebGLRenderbuffer | null;
  width: number;
  height: number;
}

/** A linked program with its uniforms, set by name; what the program does not use is passed over. */
export class Program {
  private readonly places = new Map<string, WebGLUniformLocation>();
  private readonly types = new Map<string, number>();
  private units = 0;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    readonly handle: WebGLProgram,
  ) {
    const count = gl.getProgramParameter(handle, gl.ACTIVE_UNIFORMS) as number;
    for (let i = 0; i < count; ++i) {
      const info = gl.getActiveUniform(handle, i);
      const place = info && gl.getUniformLocation(handle, info.name);
      if (!info || !place) continue;
      const name = info.name.replace(/\[0\]$/, '');
      this.places.set(name, place);
      this.types.set(name, info.type);
    }
  }

  use(): this {
    this.gl.useProgram(this.handle);
    this.units = 0;
    return this;
  }

  set(uniforms: Readonly<Record<string, Uniform>>): this {
    for (const [name, value] of Object.entries(uniforms)) this.setOne(name, value);
    return this;
  }

  texture(name: string, texture: WebGLTexture): this {
    const place = this.places.get(name);
    if (!place) return this;
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + this.units);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(place, this.units++);
    return this;
  }

  private setOne(name: string, value: Uniform): void {
    const { gl } = this;
    const place = this.places.get(name);
    if (!place) return;
    const type = this.types.get(name);
    if (typeof value === 'number' || typeof value === 'boolean') {
      if (type === gl.FLOAT) gl.uniform1f(place, Number(value));
      else if (type === gl.UNSIGNED_INT) gl.uniform1ui(place, Number(value) >>> 0);
      else gl.uniform1i(place, Number(value));
      return;
    }
    switch (type) {
      case gl.FLOAT_VEC2: gl.uniform2fv(place, value); break;
      case gl.FLOAT_VEC3: gl.uniform3fv(place, value); break;
      case gl.FLOAT_VEC4: gl.uniform4fv(place, value); break;
      case gl.INT_VEC2: gl.uniform2iv(place, value); break;
      case gl.FLOAT_MAT3: gl.uniformMatrix3fv(place, false, value); break;
      case gl.FLOAT_MAT4: gl.uniformMatrix4fv(place, false, value); break;
      default: gl.uniform1fv(place, value);
    }
  }
}

export class Gpu {
  readonly gl: WebGL2RenderingContext;
  private readonly empty: WebGLVertexArrayObject;

  /** Throws where the browser cannot draw into single precision. */
  constructor(canvas: HTMLCanvasElement | OffscreenCanvas) {
    const gl = canvas.getContext('webgl2', { antialias: false, alpha: false, depth: false, preserveDrawingBuffer: true, powerPreference: 'high-performance' });
    if (!gl) throw new Error('This browser has no WebGL 2, which the pictures need.');
    for (const name of ['EXT_color_buffer_float', 'EXT_float_blend'])
      if (!gl.getExtension(name)) throw new Error(`This graphics driver lacks ${name}, which the pictures need.`);
    this.gl = gl as WebGL2RenderingContext;
    this.empty = this.gl.createVertexArray();
  }

  program(name: string, vertex: string, fragment: string): Program {
    const { gl } = this;
    const handle = gl.createProgram();
    const shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([type, source]) => {
      const shader = gl.createShader(type as number);
      if (!shader) throw new Error('The graphics context is lost.');
      gl.shaderSource(shader, source as string);
      gl.compileShader(shader);
      gl.attachShader(handle, shader);
      return shader;
    });
    gl.linkProgram(handle);
    if (!gl.getProgramParameter(handle, gl.LINK_STATUS) && !gl.isContextLost())
      throw new Error(`Shader ${name}: ${shaders.map((s) => gl.getShaderInfoLog(s)).join(' ')} ${gl.getProgramInfoLog(handle)}`);
    shaders.forEach((shader) => gl.deleteShader(shader));
    return new Program(gl, handle);
  }

  /** A texture of RGBA in single precision for texelFetch, with at least one texel. */
  floats(data: Float32Array | null, width: number, height: number): WebGLTexture {
    const { gl } = this;
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, data);
    this.nearest();
    return texture;
  }

  /** Rows of 4096 texels, as `fetch_line` of the shaders reads them. `data` holds 4 floats a texel. */
  floatLine(data: Float32Array): WebGLTexture {
    const texels = Math.max(1, data.length / 4);
    const width = Math.min(4096, texels);
    const height = Math.ceil(texels / width);
    const full = new Float32Array(4 * width * height);
    full.set(data);
    return this.floats(full, width, height);
  }

  uintLine(data: Uint32Array): WebGLTexture {
    const { gl } = this;
    const texels = Math.max(1, data.length / 2);
    const width = Math.min(4096, texels);
    const height = Math.ceil(texels / width);
    const full = new Uint32Array(2 * width * height);
    full.set(data);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG32UI, width, height, 0, gl.RG_INTEGER, gl.UNSIGNED_INT, full);
    this.nearest();
    return texture;
  }

  /** One byte a texel; `width` is a multiple of 4. */
  bytes(data: Uint8Array, width: number, height: number): WebGLTexture {
    const { gl } = this, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R8, width, height, 0, gl.RED, gl.UNSIGNED_BYTE, data);
    this.nearest();
    return texture;
  }

  private nearest(): void {
    const { gl } = this;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  }

  target(width: number, height: number, withDepth = false, further = 0): Target {
    const { gl } = this;
    const texture = this.floats(null, width, height);
    const framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    const more = Array.from({ length: further }, (_, k) => {
      const also = this.floats(null, width, height);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT1 + k, gl.TEXTURE_2D, also, 0);
      return also;
    });
    gl.drawBuffers(Array.from({ length: 1 + further }, (_, k) => gl.COLOR_ATTACHMENT0 + k));
    let depth: WebGLRenderbuffer | null = null;
    if (withDepth) {
      depth = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    }
    const target = { texture, more, framebuffer, depth, width, height };
    this.clear(target);
    return target;
  }

  release(target: Target): void {
    const { gl } = this;
    [target.texture, ...target.more].forEach((texture) => gl.deleteTexture(texture));
    gl.deleteFramebuffer(target.framebuffer);
    if (target.depth) gl.deleteRenderbuffer(target.depth);
  }

  /** Draws into a target from here on; null: onto the canvas. */
  into(target: Target | null): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target ? target.framebuffer : null);
    if (target) gl.viewport(0, 0, target.width, target.height);
  }

  clear(target: Target): void {
    const { gl } = this;
    this.into(target);
    gl.disable(gl.SCISSOR_TEST);
    gl.clearColor(0, 0, 0, 0);
    gl.clearDepth(1);
    gl.depthMask(true);
    gl.clear(gl.COLOR_BUFFER_BIT | (target.depth ? gl.DEPTH_BUFFER_BIT : 0));
  }

  /** One triangle over the whole target. `add`: what is drawn is added to what is there. */
  fill(add: boolean): void {
    const { gl } = this;
    gl.disable(gl.DEPTH_TEST);
    if (add) {
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.ONE, gl.ONE);
    } else {
      gl.disable(gl.BLEND);
    }
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
  }

  /** A rectangle of four vertices that the program places, over what is there. */
  rectangle(): void {
    const { gl } = this;
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
  }

  /** A painted canvas as a texture that is read between its texels, its upper row first. */
  painted(texture: WebGLTexture | null, canvas: HTMLCanvasElement): WebGLTexture {
    const { gl } = this, made = texture ?? gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
    this.nearest();
    for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.LINEAR);
    return made;
  }

  /** All pixels of a target, RGBA, the lowest row first. */
  read(target: Target): Float32Array {
    const { gl } = this;
    const pixels = new Float32Array(4 * target.width * target.height);
    this.into(target);
    gl.readPixels(0, 0, target.width, target.height, gl.RGBA, gl.FLOAT, pixels);
    return pixels;
  }

  /** Waits until all is drawn: in Chromium only reading a pixel does. */
  finish(target: Target): void {
    this.into(target);
    this.gl.readPixels(0, 0, 1, 1, this.gl.RGBA, this.gl.FLOAT, new Float32Array(4));
  }
}
