/// Light that reaches the vertices of the drawn mesh, for a matt surface of albedo 1: one path for each vertex, and a few lamps.
uniform sampler2D u_vertices;  // two texels a vertex: position, material | normal
uniform int u_vertex_count;
uniform int u_matt_material;   // one whose type is diffuse
uniform uint u_sample;
out vec4 result;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  int vertex = texel.y * 1024 + texel.x;
  if (vertex >= u_vertex_count) discard;
  seed_random(uint(vertex), u_sample);
  vec4 a = fetch_line(u_vertices, 2 * vertex);
  vec3 normal = fetch_line(u_vertices, 2 * vertex + 1).xyz;
  Surface at = Surface(a.xyz, normal, normal, u_matt_material, -1, vec3(1.0), vec3(0.0));
  const int lamps = 2;
  vec3 direct = vec3(0.0), origin = off_surface(a.xyz, normal);
  begin_vertex(u_max_bounces);
  for (int k = 0; k < lamps; ++k) direct += light_by_lobe(origin, normal, frame_about(normal), vec3(0.0, 0.0, 1.0), u_matt_material, matt);
  result = vec4(path_from(at, -normal, true) + direct / float(lamps), 1.0);
}
