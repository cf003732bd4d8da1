/// Vertices as a pinhole at a point of the pupil sees them ([Kakimoto2010] §5: displaced by the blur field).
layout(location = 0) in vec3 a_position;
layout(location = 1) in vec4 a_coordinates;  // on the textures of reflectance and emission
layout(location = 2) in vec4 a_maps;         // their numbers, −1: none; how they are read
layout(location = 3) in vec3 a_reflectance;
layout(location = 4) in vec4 a_emission;     // and whether it shines behind
uniform sampler2D u_baked, u_textures;
uniform sampler2D u_displaced, u_displaced_by, u_displaced_by_squares;  // displace.frag.glsl
uniform bool u_is_displaced;  // else a naked eye that looks straight ahead and seeks no focus
uniform vec2 u_pupil_point;  // of the unit disc
uniform vec2 u_shift;        // of the picture [px], y down
uniform float u_nearest, u_farthest;  // [m]
out vec4 v_coordinates;
out vec3 v_light, v_reflectance;
flat out vec4 v_emission;
flat out ivec4 v_reflectance_map, v_emission_map;
out float v_lost;  // more than 0 anywhere in a triangle of which a corner is seen nowhere

/// Of a place on the picture, −1 … 1, and a depth.
vec4 clipped(vec2 at_by_depth, float depth) {
  return vec4(at_by_depth, (u_farthest + u_nearest) / (u_farthest - u_nearest) * depth - 2.0 * u_farthest * u_nearest / (u_farthest - u_nearest), depth);
}

ivec4 map_of(vec2 number_and_reading) {
  int number = int(number_and_reading.x);
  return number < 0 ? ivec4(-1) : ivec4(fetch_line(u_textures, number).xyz, number_and_reading.y);
}

void main() {
  v_coordinates = a_coordinates;
  v_reflectance = a_reflectance;
  v_emission = a_emission;
  v_reflectance_map = map_of(a_maps.xy);
  v_emission_map = map_of(a_maps.zw);
  ivec2 texel = ivec2(gl_VertexID & 1023, gl_VertexID >> 10);
  vec4 baked = texelFetch(u_baked, texel, 0);
  v_light = baked.a > 0.0 ? baked.rgb / baked.a : vec3(0.5);  // until light has come
  v_lost = 0.0;
  vec3 seen = (a_position - u_position) * u_head;
  if (!u_is_displaced) {
    // x/d + V p, linear in space.
    vec2 p = u_pupil_radius * u_pupil_point, at = (seen.xy - p + seen.z * matrix_slope(p, u_accommodation)) / (u_pixel_slope * 0.5 * u_size);
    vec2 middle = vec2(2.0, -2.0) * (u_center + u_shift) / u_size + vec2(-1.0, 1.0);
    gl_Position = clipped(at - middle * seen.z, -seen.z);
    return;
  }
  vec4 middle = texelFetch(u_displaced, texel, 0), by = texelFetch(u_displaced_by, texel, 0), squares = texelFetch(u_displaced_by_squares, texel, 0);
  if (middle.x >= never) {
    v_lost = 1.0;
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    return;
  }
  vec2 p = u_pupil_point, place = middle.xy + by.xy * p.x + by.zw * p.y + squares.xy * p.x * p.x + middle.zw * p.x * p.y + squares.zw * p.y * p.y;
  vec2 at = vec2(2.0, -2.0) * (place + u_shift) / u_size + vec2(-1.0, 1.0);
  float depth = max(-seen.z, u_nearest);
  gl_Position = clipped(at * depth, depth);
}
