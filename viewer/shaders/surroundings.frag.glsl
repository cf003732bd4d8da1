/// What lies behind all surfaces.
uniform vec2 u_pupil_point;
uniform vec2 u_shift;
out vec4 result;

void main() {
  vec2 p = u_pupil_radius * u_pupil_point, place = vec2(gl_FragCoord.x, u_size.y - gl_FragCoord.y);
  Sight sight = sight_at(place - u_shift);
  vec3 origin, direction;
  bent_ray(sight, p, matrix_slope(p, accommodation_at(place, 0.0)), origin, direction);
  result = vec4(environment_along(direction), 1.0);
}
