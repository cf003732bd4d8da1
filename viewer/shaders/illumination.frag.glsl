/// What lights a pixel of a traced picture: its mean over the mean colour of what its rays met, and the variance of that mean.
uniform sampler2D u_sum, u_colours, u_normals;
out vec4 result;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  vec4 sum = texelFetch(u_sum, texel, 0);
  if (sum.a == 0.0) {
    result = vec4(0.0);
    return;
  }
  const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
  vec3 mean = sum.rgb / sum.a, colour = max(texelFetch(u_colours, texel, 0).rgb / sum.a, 0.01);
  float light = dot(mean, luminance), spread = max(0.0, texelFetch(u_normals, texel, 0).w / sum.a - light * light);
  // Two or three samples do not know their spread: then it is as large as the light itself.
  if (sum.a < 4.0) spread = max(spread, light * light);
  float own = dot(colour, luminance);
  result = vec4(mean / colour, spread / (sum.a * own * own));
}
