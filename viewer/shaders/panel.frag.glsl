/// What is painted on the panel, and a ring where it is pointed at.
uniform sampler2D u_painted;
uniform vec2 u_pointed;  // as v_place; negative: nowhere
uniform float u_aspect;  // width over height
in vec2 v_place;
out vec4 result;

void main() {
  vec2 away = (v_place - u_pointed) * vec2(u_aspect, 1.0);
  float ring = abs(length(away) - 0.018);
  result = u_pointed.x >= 0.0 && ring < 0.005 ? vec4(1.0, 0.82, 0.25, 1.0) : vec4(texture(u_painted, v_place).rgb, 1.0);
}
