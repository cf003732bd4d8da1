/// The ray models alone, one ray a pixel: for tests that hold them against the core's.
uniform sampler2D u_points;  // [m]
out vec4 result;

void main() {
  PupilRay ray = ray_through(texelFetch(u_points, ivec2(gl_FragCoord.xy), 0).xy, u_accommodation);
  result = vec4(ray.s, ray.launched ? 1.0 : 0.0, 0.0);
}
