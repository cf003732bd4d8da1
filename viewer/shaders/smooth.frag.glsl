/// Light at the vertices, averaged with that at their neighbours on the same surface while it is noisy.
uniform sampler2D u_light;
uniform sampler2D u_neighbours;  // two texels a vertex: up to 8 numbers, −1: none
uniform int u_vertex_count;
out vec4 result;

vec4 light_at(int vertex) {
  return texelFetch(u_light, ivec2(vertex % 1024, vertex / 1024), 0);
}

void main() {
  int vertex = int(gl_FragCoord.y) * 1024 + int(gl_FragCoord.x);
  if (vertex >= u_vertex_count) discard;
  result = light_at(vertex);
  for (int k = 0; k < 2; ++k) {
    vec4 numbers = fetch_line(u_neighbours, 2 * vertex + k);
    for (int c = 0; c < 4; ++c)
      if (numbers[c] >= 0.0) result += light_at(int(numbers[c]));
  }
}
