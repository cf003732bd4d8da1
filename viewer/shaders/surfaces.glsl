/// What a ray met: materials and textures. Tables are written by src/scene_tables.ts.
const int diffuse = 0, conductor = 1, dielectric = 2, plastic = 3;
const int material_texels = 10, light_texels = 5, attribute_texels = 9;

uniform sampler2D u_materials;
uniform sampler2D u_attributes;  // of triangles, in the order of the tree
uniform bool u_has_attributes;
uniform sampler2D u_texels;
uniform sampler2D u_textures;    // first texel, width, height

struct Surface {
  vec3 position, normal, shading_normal;  // normals on the side that emits
  int material, light;
  vec3 albedo, emission;
};

vec4 material_texel(int material, int k) {
  return fetch_line(u_materials, material_texels * material + k);
}

float within(float t, int wrap) {
  if (wrap == 1) return t - floor(t);
  if (wrap == 2) {
    float turn = t - 2.0 * floor(0.5 * t);
    return turn > 1.0 ? 2.0 - turn : turn;
  }
  return clamp(t, 0.0, 1.0);
}

int shown(int i, int n, int wrap) {
  if (wrap == 1) return i < 0 ? i + n : i >= n ? i - n : i;
  return clamp(i, 0, n - 1);
}

/// `first`: texel of the table. `uv`: (0, 0) is the lower left corner.
vec3 texture_at(int first, ivec2 size, vec2 uv, ivec2 wrap, bool nearest) {
  vec2 at = vec2(within(uv.x, wrap.x), 1.0 - within(uv.y, wrap.y)) * vec2(size);
  if (nearest) return fetch_line(u_texels, first + shown(int(at.y), size.y, wrap.y) * size.x + shown(int(at.x), size.x, wrap.x)).rgb;
  vec2 corner = floor(at - 0.5), f = at - 0.5 - corner;
  int x0 = shown(int(corner.x), size.x, wrap.x), x1 = shown(int(corner.x) + 1, size.x, wrap.x);
  int y0 = first + shown(int(corner.y), size.y, wrap.y) * size.x, y1 = first + shown(int(corner.y) + 1, size.y, wrap.y) * size.x;
  return mix(mix(fetch_line(u_texels, y0 + x0).rgb, fetch_line(u_texels, y0 + x1).rgb, f.x),
             mix(fetch_line(u_texels, y1 + x0).rgb, fetch_line(u_texels, y1 + x1).rgb, f.x), f.y);
}

/// A map of a material: its texels 5, 6 (albedo) or 7, 8 (emission), `number` its texture.
vec3 mapped(int material, int texel, int number, vec2 coordinate) {
  vec4 upper = material_texel(material, texel), lower = material_texel(material, texel + 1);
  vec3 at = vec3(coordinate, 1.0), facts = fetch_line(u_textures, number).xyz;
  return texture_at(int(facts.x), ivec2(facts.yz), vec2(dot(upper.xyz, at), dot(lower.xyz, at)), ivec2(upper.w, lower.w), material_texel(material, 2).w > 0.5);
}

vec3 albedo_map(int material, vec2 coordinate) {
  int number = int(material_texel(material, 3).w);
  return number < 0 ? vec3(1.0) : mapped(material, 5, number, coordinate);
}

vec3 emission_map(int material, vec2 coordinate) {
  int number = int(material_texel(material, 4).w);
  return number < 0 ? vec3(1.0) : mapped(material, 7, number, coordinate);
}

Surface sphere_surface(Hit hit, vec3 origin, vec3 direction) {
  vec4 ball = fetch_line(u_spheres, 2 * hit.sphere), facts = fetch_line(u_spheres, 2 * hit.sphere + 1);
  vec3 normal = normalize(origin + hit.t * direction - ball.xyz);
  int material = int(facts.x);
  return Surface(ball.xyz + ball.w * normal, normal, normal, material, int(facts.y), material_texel(material, 0).rgb, material_texel(material, 1).rgb);
}

Surface surface_at(Hit hit, vec3 origin, vec3 direction) {
  if (hit.sphere >= 0) return sphere_surface(hit, origin, direction);
  vec4 a = fetch_line(u_corners, 3 * hit.triangle), b = fetch_line(u_corners, 3 * hit.triangle + 1), c = fetch_line(u_corners, 3 * hit.triangle + 2);
  vec3 e1 = b.xyz - a.xyz, e2 = c.xyz - a.xyz, normal = normalize(cross(e1, e2)), weights = vec3(1.0 - hit.uv.x - hit.uv.y, hit.uv);
  int material = int(a.w);
  Surface at = Surface(a.xyz + hit.uv.x * e1 + hit.uv.y * e2, normal, normal, material, int(c.w), vec3(0.0), vec3(0.0));
  vec2 coordinate = vec2(0.0), of_emission = vec2(0.0);
  vec3 colour = vec3(1.0);
  if (u_has_attributes) {
    int first = attribute_texels * hit.triangle;
    vec4 n0 = fetch_line(u_attributes, first), n1 = fetch_line(u_attributes, first + 1), n2 = fetch_line(u_attributes, first + 2);
    vec3 smoothed = mat3(n0.xyz, n1.xyz, n2.xyz) * weights;
    if (dot(smoothed, smoothed) > 0.0) {
      at.shading_normal = normalize(smoothed);
      if (dot(at.shading_normal, normal) < 0.0) at.shading_normal = -at.shading_normal;
    }
    coordinate = vec2(dot(vec3(n0.w, n1.w, n2.w), weights), dot(fetch_line(u_attributes, first + 3).xyz, weights));
    of_emission = vec2(dot(fetch_line(u_attributes, first + 4).xyz, weights), dot(fetch_line(u_attributes, first + 5).xyz, weights));
    colour = mat3(fetch_line(u_attributes, first + 6).xyz, fetch_line(u_attributes, first + 7).xyz, fetch_line(u_attributes, first + 8).xyz) * weights;
  }
  at.albedo = material_texel(material, 0).rgb * albedo_map(material, coordinate) * colour;
  at.emission = material_texel(material, 1).rgb * emission_map(material, of_emission);
  return at;
}

bool shines_towards(Surface at, vec3 direction) {
  return dot(at.normal, direction) < 0.0 || material_texel(at.material, 1).w > 0.5;
}

vec3 off_surface(vec3 position, vec3 normal) {
  vec3 size = abs(position);
  return position + 2e-5 * max(1.0, max(size.x, max(size.y, size.z))) * normal;
}
