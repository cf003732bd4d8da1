/// First hits through the tree that three-mesh-bvh builds; triangles lie in the order of its leaves.
uniform sampler2D u_bounds;      // two texels a node
uniform usampler2D u_nodes;
uniform sampler2D u_corners;     // three texels a triangle: corner and material | number | light
uniform sampler2D u_spheres;     // two texels each: centre, radius | material, light
uniform int u_sphere_count;
uniform bool u_has_triangles;

struct Hit {
  float t;
  int triangle;  // in the order of the tree; −1: none or a sphere
  int sphere;
  vec2 uv;
};

bool meets_box(vec3 origin, vec3 inverse, int node, float limit, out float at) {
  vec3 a = (fetch_line(u_bounds, 2 * node).xyz - origin) * inverse, b = (fetch_line(u_bounds, 2 * node + 1).xyz - origin) * inverse;
  vec3 low = min(a, b), high = max(a, b);
  at = max(max(low.x, low.y), max(low.z, 0.0));
  return min(min(high.x, high.y), high.z) * 1.0000004 >= at && at < limit;
}

/// Möller and Trumbore. The tolerance closes the seams between triangles.
void meet_triangle(vec3 origin, vec3 direction, int triangle, inout Hit hit) {
  vec3 a = fetch_line(u_corners, 3 * triangle).xyz;
  vec3 e1 = fetch_line(u_corners, 3 * triangle + 1).xyz - a, e2 = fetch_line(u_corners, 3 * triangle + 2).xyz - a;
  vec3 h = cross(direction, e2);
  float det = dot(e1, h);
  if (det == 0.0) return;
  float inverse = 1.0 / det;
  vec3 from = origin - a, q = cross(from, e1);
  float u = dot(from, h) * inverse, v = dot(direction, q) * inverse, t = dot(e2, q) * inverse;
  const float seam = 1e-6;
  if (u < -seam || v < -seam || u + v > 1.0 + seam || !(t > 0.0) || !(t < hit.t)) return;
  hit = Hit(t, triangle, -1, vec2(u, v));
}

void meet_spheres(vec3 origin, vec3 direction, inout Hit hit) {
  for (int k = 0; k < u_sphere_count; ++k) {
    vec4 ball = fetch_line(u_spheres, 2 * k);
    vec3 from = origin - ball.xyz;
    float a = dot(direction, direction), b = dot(from, direction);
    // The discriminant from the distance of the line, so that nothing cancels for small spheres far away.
    vec3 nearest = from - b / a * direction;
    float d = a * (ball.w * ball.w - dot(nearest, nearest));
    if (d < 0.0) continue;
    float root = sqrt(d), t = (-b - root) / a;
    // A ray that starts on the sphere leaves it: its first meeting is rounding.
    if (!(t > 1e-4 * ball.w)) t = (-b + root) / a;
    if (t > 1e-4 * ball.w && t < hit.t) hit = Hit(t, -1, k, vec2(0.0));
  }
}

/// The nearest hit before `limit`; `any`: whichever is found first.
Hit first_hit(vec3 origin, vec3 direction, float limit, bool any) {
  Hit hit = Hit(limit, -1, -1, vec2(0.0));
  meet_spheres(origin, direction, hit);
  if (!u_has_triangles) return hit;
  vec3 inverse = 1.0 / mix(direction, vec3(1e-20), equal(direction, vec3(0.0)));
  int stack[48];
  int depth = 0;
  float at;
  stack[0] = 0;
  while (depth >= 0) {
    int node = stack[depth--];
    if (!meets_box(origin, inverse, node, hit.t, at)) continue;
    uvec2 content = fetch_line(u_nodes, node);
    if ((content.x & 0xffff0000u) != 0u) {
      int begin = int(content.y), end = begin + int(content.x & 0xffffu);
      for (int k = begin; k < end; ++k) meet_triangle(origin, direction, k, hit);
      if (any && hit.triangle >= 0) return hit;
    } else {
      bool ahead = direction[content.x] >= 0.0;
      int left = node + 1, right = node + int(content.y);
      if (depth < 46) {
        stack[++depth] = ahead ? right : left;
        stack[++depth] = ahead ? left : right;
      }
    }
  }
  return hit;
}
