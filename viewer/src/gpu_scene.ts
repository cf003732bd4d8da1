/** A scene on the graphics card: tables for rays, a mesh for the rasteriser, and the light at its vertices. */
import { luminance } from './colour';
import { drawnMesh, neighboursOf, vertexParts, type DrawnMesh } from './drawn_mesh';
import type { Gpu, Program, Target, Uniform } from './gpu';
import type { Programs } from './programs';
import type { SceneData, Vec3 } from './scene_file';
import { sceneTables } from './scene_tables';
import type { SceneTree } from './scene_tree';
import { indexWithin, type Planes } from './view_volume';

/** Largest edge of the drawn mesh, as seen from the eye: chief rays through strong spectacles bend by 2e-4 rad within it. */
const edge_rad = 0.06;
const bakeWidth = 1024, floatsOfVertex = vertexParts.reduce((sum, size) => sum + size);
export const bakeGoal = 64;

/** How often light is averaged over neighbours after so many samples. */
function smoothings(samples: number): number {
  return samples < 4 ? 4 : samples < 16 ? 2 : samples < bakeGoal ? 1 : 0;
}

export class GpuScene {
  private readonly textures: Record<string, WebGLTexture>;
  private readonly uniforms: Record<string, Uniform>;
  private readonly vertexArray: WebGLVertexArrayObject;
  private readonly buffers: WebGLBuffer[] = [];
  private readonly places: WebGLTexture;
  private readonly mesh: DrawnMesh;
  /** What of it is drawn: numbers of vertices, and of each vertex whether it is. */
  private indexCount = 0;
  private used: WebGLTexture;
  /** Where vertices are seen: displace.frag.glsl. */
  private readonly displaced: Target;
  private readonly neighbours: WebGLTexture;
  private readonly baked: Target;
  /** `baked`, averaged over neighbours. */
  private readonly smoothed: [Target, Target];
  private shown: Target;
  readonly nearest: number;
  readonly farthest: number;
  readonly hasSurroundings: boolean;
  readonly triangleCount: number;
  /** Complete samples at every vertex, and rows of the next one. */
  bakedSamples = 0;
  private bakedRows = 0;

  constructor(private readonly gpu: Gpu, scene: SceneData, tree: SceneTree, eye: Vec3) {
    const tables = sceneTables(scene, tree), environment = scene.environment;
    this.textures = {
      u_bounds: gpu.floatLine(tables.bounds), u_nodes: gpu.uintLine(tables.nodes), u_corners: gpu.floatLine(tables.corners),
      u_attributes: gpu.floatLine(tables.attributes ?? new Float32Array(4)), u_materials: gpu.floatLine(tables.materials), u_texels: gpu.floatLine(tables.texels),
      u_textures: gpu.floatLine(tables.textures), u_spheres: gpu.floatLine(tables.spheres), u_lights: gpu.floatLine(tables.lights),
      u_environment_rows: gpu.floatLine(tables.environmentRows),
    };
    this.hasSurroundings = environment !== null;
    this.uniforms = {
      u_sphere_count: tables.sphereCount, u_has_triangles: scene.triangles.length > 0, u_has_attributes: tables.attributes !== null,
      u_environment: environment ? environment.radiance : [0, 0, 0], u_environment_texture: environment?.texture ?? -1, u_environment_turn: environment?.rotation_rad ?? 0,
      u_light_count: tables.lightCount, u_environment_share: tables.environmentShare, u_matt_material: tables.mattMaterial,
    };
    const mesh = drawnMesh(scene, eye, edge_rad);
    this.triangleCount = mesh.index.length / 3;
    this.mesh = mesh;
    this.places = gpu.floatLine(mesh.places);
    this.vertexArray = this.vertexArrayOf(mesh.vertices);
    this.baked = gpu.target(bakeWidth, Math.max(1, Math.ceil(mesh.vertexCount / bakeWidth)));
    this.displaced = gpu.target(bakeWidth, this.baked.height, false, 2);
    this.used = gpu.bytes(new Uint8Array(bakeWidth * this.baked.height), bakeWidth, this.baked.height);
    this.neighbours = gpu.floatLine(neighboursOf(mesh));
    this.smoothed = [gpu.target(bakeWidth, this.baked.height), gpu.target(bakeWidth, this.baked.height)];
    this.shown = this.smoothed[0];  // nothing yet
    const scatters = scene.materials.some((m) => m.type !== 'diffuse' || m.albedo_map !== null || luminance(m.albedo) > 0);
    if (!scatters) this.bakedSamples = bakeGoal;
    const reach = Math.hypot(...scene.upper.map((x, k) => Math.max(Math.abs(x - (eye[k] ?? 0)), Math.abs((scene.lower[k] ?? 0) - (eye[k] ?? 0)))));
    this.nearest = 0.02;
    this.farthest = 1.01 * reach + 1;
  }

  private vertexArrayOf(vertices: Float32Array): WebGLVertexArrayObject {
    const { gl } = this.gpu, array = gl.createVertexArray();
    gl.bindVertexArray(array);
    this.buffers.push(gl.createBuffer(), gl.createBuffer());
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[0] ?? null);
    gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
    vertexParts.forEach((size, k) => {
      gl.enableVertexAttribArray(k);
      gl.vertexAttribPointer(k, size, gl.FLOAT, false, 4 * floatsOfVertex, 4 * vertexParts.slice(0, k).reduce((sum, before) => sum + before, 0));
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.buffers[1] ?? null);
    gl.bindVertexArray(null);
    return array;
  }

  bind(program: Program): Program {
    program.set(this.uniforms);
    for (const [name, texture] of Object.entries(this.textures)) program.texture(name, texture);
    return program;
  }

  /** What is drawn from now on: triangles that a picture can show. */
  showWithin(planes: Planes | null): void {
    const { gl } = this.gpu, index = indexWithin(planes, this.mesh.vertices, floatsOfVertex, this.mesh.index), used = new Uint8Array(bakeWidth * this.baked.height);
    for (const v of index) used[v] = 255;
    this.indexCount = index.length;
    gl.bindVertexArray(this.vertexArray);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.DYNAMIC_DRAW);
    gl.bindVertexArray(null);
    gl.deleteTexture(this.used);
    this.used = this.gpu.bytes(used, bakeWidth, this.baked.height);
  }

  /** Places of all vertices that are drawn, by `displace`, which knows the eye. */
  displace(program: Program): void {
    program.texture('u_vertices', this.places).texture('u_shown', this.used).set({ u_nearest: this.nearest });
    this.gpu.into(this.displaced);
    this.gpu.fill(false);
  }

  /** By `program`, which knows the eye. */
  draw(program: Program): void {
    const { gl } = this.gpu, [by, squares] = this.displaced.more;
    program.texture('u_baked', this.shown.texture).texture('u_displaced', this.displaced.texture).texture('u_displaced_by', by as WebGLTexture).texture('u_displaced_by_squares', squares as WebGLTexture);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LESS);
    gl.bindVertexArray(this.vertexArray);
    gl.drawElements(gl.TRIANGLES, this.indexCount, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(null);
  }

  get lightIsSettled(): boolean {
    return this.bakedSamples >= bakeGoal;
  }

  /** One path from some rows of 1024 vertices; true where all have got one more. */
  gatherLight(programs: Programs, rowsAtOnce: number, maxBounces: number): boolean {
    const { gl } = this.gpu, rows = Math.min(rowsAtOnce, this.baked.height - this.bakedRows);
    this.bind(programs.use('bake')).texture('u_vertices', this.places)
      .set({ u_vertex_count: this.mesh.vertexCount, u_sample: this.bakedSamples, u_seed: 1, u_max_bounces: maxBounces });
    this.gpu.into(this.baked);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, this.bakedRows, bakeWidth, rows);
    this.gpu.fill(true);
    gl.disable(gl.SCISSOR_TEST);
    this.bakedRows += rows;
    if (this.bakedRows < this.baked.height) return false;
    this.bakedRows = 0;
    ++this.bakedSamples;
    this.shown = this.baked;
    for (let k = 0; k < smoothings(this.bakedSamples); ++k) this.smooth(programs, this.smoothed[k % 2] as Target);
    return true;
  }

  private smooth(programs: Programs, into: Target): void {
    programs.use('smooth').texture('u_light', this.shown.texture).texture('u_neighbours', this.neighbours).set({ u_vertex_count: this.mesh.vertexCount });
    this.gpu.into(into);
    this.gpu.fill(false);
    this.shown = into;
  }

  release(): void {
    const { gl } = this.gpu;
    for (const texture of [...Object.values(this.textures), this.places, this.neighbours, this.used]) gl.deleteTexture(texture);
    for (const target of [this.baked, this.displaced, ...this.smoothed]) this.gpu.release(target);
    for (const buffer of this.buffers) gl.deleteBuffer(buffer);
    gl.deleteVertexArray(this.vertexArray);
  }
}
