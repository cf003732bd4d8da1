/** The tree of a scene's triangles: for the shaders, and for single rays of the page. */
import { BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3 } from 'three';
import { MeshBVH, MeshBVHUniformStruct, SAH } from 'three-mesh-bvh';
import type { SceneData, Vec3 } from './scene_file';

export class SceneTree {
  readonly bounds: Float32Array = new Float32Array(8);
  readonly nodes: Uint32Array = new Uint32Array(2);
  /** Vertices of the triangles in the order of the leaves, and each one's number in the scene. */
  readonly index: Uint32Array = new Uint32Array(0);
  readonly numbers: Uint32Array = new Uint32Array(0);
  private readonly tree: MeshBVH | null = null;

  constructor(private readonly scene: SceneData) {
    if (scene.triangles.length === 0) return;
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(scene.positions, 3));
    geometry.setIndex(new BufferAttribute(scene.triangles, 1));
    const tree = new MeshBVH(geometry, { strategy: SAH, indirect: true, targetLeafSize: 4 });
    const tables = new MeshBVHUniformStruct();
    tables.updateFrom(tree);
    // Not in the package's types.
    const known = tables as unknown as Record<'bvhBounds' | 'bvhContents', { image: { data: unknown } }>;
    this.bounds = known.bvhBounds.image.data as Float32Array;
    this.nodes = known.bvhContents.image.data as Uint32Array;
    this.numbers = Uint32Array.from((tree as unknown as { _indirectBuffer: ArrayLike<number> })._indirectBuffer);
    this.index = new Uint32Array(scene.triangles.length);
    this.numbers.forEach((triangle, k) => this.index.set(scene.triangles.subarray(3 * triangle, 3 * triangle + 3), 3 * k));
    this.tree = tree;
  }

  /** Distance [in lengths of `direction`] to what a ray meets first; Infinity where it meets nothing. */
  distance(origin: Vec3, direction: Vec3): number {
    const length = Math.hypot(...direction), ray = new Ray(new Vector3(...origin), new Vector3(...direction).divideScalar(length));
    let nearest = (this.tree?.raycastFirst(ray, DoubleSide)?.distance ?? Infinity) / length;
    for (const ball of this.scene.spheres) {
      const from = origin.map((x, k) => x - (ball.center_m[k] ?? 0)), b = from.reduce((sum, x, k) => sum + x * (direction[k] ?? 0), 0) / length;
      const d = b * b - from.reduce((sum, x) => sum + x * x, 0) + ball.radius_m ** 2;
      if (d < 0) continue;
      const t = -b - Math.sqrt(d) > 1e-6 ? -b - Math.sqrt(d) : -b + Math.sqrt(d);
      if (t > 1e-6) nearest = Math.min(nearest, t / length);
    }
    return nearest;
  }
}
