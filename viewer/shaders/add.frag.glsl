/// Adds one pass to the sum: to all pixels, or to those of one of the 16 sets.
uniform sampler2D u_picture;
uniform int u_set;        // −1: all
uniform bool u_rim_shows;  // somewhere in the picture
out vec4 result;

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy), pixel = ivec2(texel.x, int(u_size.y) - 1 - texel.y);
  if (u_set >= 0 && (pixel.y % 4) * 4 + pixel.x % 4 != u_set) discard;
  // The rim cuts where the middle of a pixel is beyond it, as `sturm render` has it.
  bool dark = u_rim_shows && !within_rim(vec2(pixel) + 0.5);
  result = vec4(dark ? vec3(0.0) : texelFetch(u_picture, texel, 0).rgb, 1.0);
}
