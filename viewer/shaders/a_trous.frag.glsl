/// One step of an edge-avoiding à-trous filter (Dammertz et al. 2010), which stops where light differs by more than its noise (Schied et
/// al. 2017) or where what was met faces elsewhere or is at another distance. Without noise it does nothing.
uniform sampler2D u_light;  // illumination, variance of its luminance
uniform sampler2D u_sum, u_colours, u_normals;
uniform int u_step;         // [px] between neighbours
uniform bool u_last;        // colours come back
out vec4 result;

const float kernel[3] = float[3](0.375, 0.25, 0.0625);

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(u_light, 0) - 1;
  float samples = texelFetch(u_sum, here, 0).a;
  if (samples == 0.0) {
    result = vec4(0.0);
    return;
  }
  const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
  vec4 light = texelFetch(u_light, here, 0), colour = texelFetch(u_colours, here, 0) / samples;
  vec3 normal = texelFetch(u_normals, here, 0).xyz / samples;
  float own = dot(light.rgb, luminance), noise = 3.0 * sqrt(light.a), weights = 0.0;
  vec4 sum = vec4(0.0);
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      ivec2 there = here + u_step * ivec2(x, y);
      if (any(lessThan(there, ivec2(0))) || any(greaterThan(there, last))) continue;
      float count = texelFetch(u_sum, there, 0).a;
      if (count == 0.0) continue;
      vec4 other = texelFetch(u_light, there, 0);
      vec3 turn = texelFetch(u_normals, there, 0).xyz / count - normal;
      vec4 change = abs(texelFetch(u_colours, there, 0) / count - colour);
      float apart = abs(dot(other.rgb, luminance) - own) / (noise + 1e-6 * own + 1e-20);
      float further = change.a / (0.02 * float(u_step) * max(colour.a, 1e-3));
      float weight = kernel[abs(x)] * kernel[abs(y)] * exp(-apart - further - 16.0 * dot(turn, turn));
      sum += vec4(other.rgb, 0.0) * weight;
      sum.a += other.a * weight * weight;
      weights += weight;
    }
  vec4 filtered = vec4(sum.rgb / weights, sum.a / (weights * weights));
  result = u_last ? vec4(filtered.rgb * max(colour.rgb, 0.01), 1.0) : filtered;
}
