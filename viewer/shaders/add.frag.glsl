/// Adds one pass to the sum: to all pixels, or to those of one of the 16 sets.
uniform sampler2D u_picture;
uniform int u_set;  // −1: all
uniform float u_height;
out vec4 result;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy), pixel = ivec2(texel.x, int(u_height) - 1 - texel.y);
  if (u_set >= 0 && (pixel.y % 4) * 4 + pixel.x % 4 != u_set) discard;
  result = vec4(texelFetch(u_picture, texel, 0).rgb, 1.0);
}
