/// The display version: clamped, sRGB.
uniform sampler2D u_sum;
uniform vec2 u_corner;  // of the part of the canvas [px]
uniform vec2 u_scale;   // picture pixels per canvas pixel
uniform float u_exposure;
out vec4 result;

void main() {
  ivec2 size = textureSize(u_sum, 0);
  ivec2 texel = clamp(ivec2((gl_FragCoord.xy - u_corner) * u_scale), ivec2(0), size - 1);
  vec4 sum = texelFetch(u_sum, texel, 0);
  vec3 linear = clamp(u_exposure * (sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0)), 0.0, 1.0);
  result = vec4(mix(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308))), 1.0);
}
