/// Vertices as a pinhole at a point of the pupil sees them ([Kakimoto2010] §5: displaced by the blur field). The place in the picture
/// is that whose first-order ray through the pupil point meets the vertex, by Newton's iteration on the field.
layout(location = 0) in vec4 a_position;  // and material
layout(location = 1) in vec2 a_coordinate;
layout(location = 2) in vec3 a_colour;
uniform sampler2D u_baked;
uniform vec2 u_pupil_point;  // of the unit disc
uniform vec2 u_shift;        // of the picture [px], y down
uniform float u_nearest, u_farthest;  // [m]
out vec2 v_coordinate;
out vec3 v_light, v_colour;
flat out int v_material;
out float v_lost;  // more than 0 anywhere in a triangle of which a corner is seen nowhere

/// Planar head coordinates → where a pinhole in the pupil's centre would see the point [px].
vec2 projected(vec3 point) {
  vec3 seen = (point - u_position) * u_head;
  float depth = max(-seen.z, 1e-3);
  return u_center + vec2(seen.x, -seen.y) / (depth * u_pixel_slope);
}

/// How far the ray of a place through the pupil point passes from the vertex, per metre of distance, on two axes across it.
vec2 missed(vec2 place, vec3 point, vec2 p, mat2x3 across, inout float t) {
  Sight sight = sight_at(place);
  float vergence = 1.0 / max(t, 1e-4);
  vec2 s = matrix_slope(p, accommodation_at(place, vergence));
  vec3 origin, direction;
  bent_ray(sight, p, s, origin, direction);
  vec3 to = point - origin;
  t = dot(to, direction) / dot(direction, direction);
  return (to - t * direction) * across / max(abs(t), 1e-4);
}

void main() {
  vec3 point = a_position.xyz;
  v_coordinate = a_coordinate;
  v_colour = a_colour;
  v_material = int(a_position.w);
  vec4 baked = texelFetch(u_baked, ivec2(gl_VertexID % 1024, gl_VertexID / 1024), 0);
  v_light = baked.a > 0.0 ? baked.rgb / baked.a : vec3(0.5);  // until light has come
  v_lost = 0.0;
  vec2 p = u_pupil_radius * u_pupil_point;
  if (!u_lens && !u_foveal && !u_seeks_focus) {
    // A naked eye that looks straight ahead: x/d + V p, linear in space.
    vec3 seen = (point - u_position) * u_head;
    vec2 at = (seen.xy - p + seen.z * matrix_slope(p, u_accommodation)) / (u_pixel_slope * 0.5 * u_size);
    float depth = -seen.z;
    vec2 middle = vec2(2.0, -2.0) * (u_center + u_shift) / u_size + vec2(-1.0, 1.0);
    gl_Position = vec4(at + middle * depth, (u_farthest + u_nearest) / (u_farthest - u_nearest) * depth - 2.0 * u_farthest * u_nearest / (u_farthest - u_nearest), depth);
    return;
  }
  vec3 from = (point - u_position) * u_head;
  if (from.z > -u_nearest) {
    v_lost = 1.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 place = projected(point), step = vec2(0.0);
  mat2x3 across = mat2x3(u_head[0], u_head[1]);
  float t = length(point - u_position);
  // Two or three steps, but for places at and beyond a rim, where the field bends most.
  for (int k = 0; k < 10 && (k == 0 || length(step) > 0.02); ++k) {
    float ahead = t;
    vec2 here = missed(place, point, p, across, t), right = missed(place + vec2(1.0, 0.0), point, p, across, ahead);
    ahead = t;
    vec2 below = missed(place + vec2(0.0, 1.0), point, p, across, ahead);
    mat2 jacobian = mat2(right - here, below - here);
    step = clamp(inverse(jacobian) * here, vec2(-0.5 * u_size.y), vec2(0.5 * u_size.y));
    place -= step;
  }
  bool seen = t > 0.0 && length(step) < 1.0;  // else nowhere, or nowhere that was found
  v_lost = seen ? 0.0 : 1.0;
  vec2 at = vec2(2.0, -2.0) * (place + u_shift) / u_size + vec2(-1.0, 1.0);
  float w = max(-from.z, u_nearest);
  gl_Position = seen ? vec4(at * w, (u_farthest + u_nearest) / (u_farthest - u_nearest) * w - 2.0 * u_farthest * u_nearest / (u_farthest - u_nearest), w)
                     : vec4(2.0, 2.0, 2.0, 1.0);
}
