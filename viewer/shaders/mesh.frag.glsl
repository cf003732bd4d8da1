in vec2 v_coordinate;
in vec3 v_light, v_reflectance;
flat in vec4 v_emission;  // and whether it shines behind
flat in int v_mapped;     // material whose textures are laid on; −1: none
in float v_lost;
out vec4 result;

void main() {
  if (v_lost > 0.0) discard;
  vec3 emission = gl_FrontFacing || v_emission.w > 0.5 ? v_emission.rgb : vec3(0.0), reflectance = v_reflectance;
  if (v_mapped >= 0) {
    emission *= emission_map(v_mapped, v_coordinate);
    reflectance *= albedo_map(v_mapped, v_coordinate);
  }
  result = vec4(emission + reflectance * v_light, 1.0);
}
