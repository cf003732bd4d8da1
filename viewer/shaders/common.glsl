precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

const float pi = 3.14159265358979;
const float never = 1e30;

/// Texel of a table in rows of at most 4096.
vec4 fetch_line(sampler2D table, int i) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(i % width, i / width), 0);
}
uvec2 fetch_line(usampler2D table, int i) {
  int width = textureSize(table, 0).x;
  return texelFetch(table, ivec2(i % width, i / width), 0).xy;
}
