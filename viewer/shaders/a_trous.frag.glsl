/// One step of an edge-avoiding à-trous filter (docs/theory.md#96-the-denoiser): a neighbour counts less where its light differs by more than
/// the noise, or where what was met faces elsewhere or is at another distance than its slope explains. Without noise it does nothing.
uniform sampler2D u_light;  // illumination, variance of its luminance
uniform sampler2D u_sum, u_colours, u_normals;
uniform int u_step;         // [px] between neighbours
uniform bool u_last;        // colours come back
out vec4 result;

const float b3_spline[3] = float[3](0.375, 0.25, 0.0625);
const float light_sigma = 2.0, normal_sigma = 0.3, vergence_sigma = 0.05;
const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);

/// Mean over the samples of a pixel.
vec4 mean_of(sampler2D sums, ivec2 texel) {
  return texelFetch(sums, texel, 0) / max(texelFetch(u_sum, texel, 0).a, 1.0);
}

ivec2 inside(ivec2 texel) {
  return clamp(texel, ivec2(0), textureSize(u_light, 0) - 1);
}

/// Of the neighbourhood, since a few samples do not know their own.
float variance_about(ivec2 here) {
  float sum = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) sum += texelFetch(u_light, inside(here + ivec2(x, y)), 0).a * float((2 - abs(x)) * (2 - abs(y)));
  return sum / 16.0;
}

/// The smaller one-sided difference of the vergence for each pixel along a direction.
float vergence_slope(ivec2 here, ivec2 along, float vergence) {
  float ahead = mean_of(u_colours, inside(here + along)).a - vergence, behind = vergence - mean_of(u_colours, inside(here - along)).a;
  return abs(ahead) < abs(behind) ? ahead : behind;
}

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy);
  if (texelFetch(u_sum, here, 0).a == 0.0) {
    result = vec4(0.0);
    return;
  }
  vec4 light = texelFetch(u_light, here, 0), colour = mean_of(u_colours, here);
  vec3 normal = mean_of(u_normals, here).xyz;
  vec2 slope = vec2(vergence_slope(here, ivec2(1, 0), colour.a), vergence_slope(here, ivec2(0, 1), colour.a));
  float own = dot(light.rgb, luminance), noise = light_sigma * light_sigma * 2.0 * variance_about(here) + 1e-20, weights = 0.0;
  vec4 sum = vec4(0.0);
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      ivec2 away = u_step * ivec2(x, y), there = here + away;
      if (there != inside(there) || texelFetch(u_sum, there, 0).a == 0.0) continue;
      vec4 other = texelFetch(u_light, there, 0);
      vec3 turn = mean_of(u_normals, there).xyz - normal;
      float vergence = mean_of(u_colours, there).a, deeper = vergence - colour.a, explained = dot(slope, vec2(away));
      float brighter = dot(other.rgb, luminance) - own, near = vergence_sigma * max(max(vergence, colour.a), 1e-3);
      float cost = brighter * brighter / noise + dot(turn, turn) / (normal_sigma * normal_sigma) + max(0.0, deeper * deeper - explained * explained) / (near * near);
      float weight = b3_spline[abs(x)] * b3_spline[abs(y)] * exp(-cost);
      sum += vec4(other.rgb, other.a * weight) * weight;
      weights += weight;
    }
  vec4 filtered = vec4(sum.rgb / weights, sum.a / (weights * weights));
  result = u_last ? vec4(filtered.rgb * max(colour.rgb, 0.01), 1.0) : filtered;
}
