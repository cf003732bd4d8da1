in vec4 v_coordinates;    // on the textures of reflectance and emission
in vec3 v_light, v_reflectance;
flat in vec4 v_emission;  // and whether it shines behind
flat in ivec4 v_reflectance_map, v_emission_map;  // first texel, −1: none; width; height; how it is read
in float v_lost;
out vec4 result;

vec3 painted(ivec4 map, vec2 uv) {
  return map.x < 0 ? vec3(1.0) : texture_at(map.x, map.yz, uv, ivec2(map.w & 3, (map.w >> 2) & 3), map.w >= 16);
}

void main() {
  if (v_lost > 0.0) discard;
  vec3 emission = gl_FrontFacing || v_emission.w > 0.5 ? v_emission.rgb : vec3(0.0);
  result = vec4(emission * painted(v_emission_map, v_coordinates.zw) + v_reflectance * painted(v_reflectance_map, v_coordinates.xy) * v_light, 1.0);
}
