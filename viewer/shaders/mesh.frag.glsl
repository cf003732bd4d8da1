in vec2 v_coordinate;
in vec3 v_light, v_colour;
flat in int v_material;
in float v_lost;
out vec4 result;

void main() {
  // The rim cuts where the middle of a pixel is beyond it, as `sturm render` has it.
  if (v_lost > 0.0 || !within_rim(vec2(gl_FragCoord.x, u_size.y - gl_FragCoord.y))) discard;
  bool shines = gl_FrontFacing || material_texel(v_material, 1).w > 0.5;
  vec3 emission = shines ? emission_of(v_material, v_coordinate) : vec3(0.0);
  result = vec4(emission + albedo_of(v_material, v_coordinate) * v_colour * v_light, 1.0);
}
