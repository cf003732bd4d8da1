/// A rectangle in space: the panel of the headset.
uniform mat4 u_projection, u_view;
uniform vec3 u_middle, u_right, u_up;  // half its sides [m]
out vec2 v_place;  // 0 … 1, y down

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  v_place = vec2(corner.x, 1.0 - corner.y);
  corner = 2.0 * corner - 1.0;
  gl_Position = u_projection * u_view * vec4(u_middle + corner.x * u_right + corner.y * u_up, 1.0);
}
