precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

const float pi = 3.14159265358979;
const float never = 1e30;

/// Texel of a table in rows of 4096, or in one that is shorter.
vec4 fetch_line(sampler2D table, int i) {
  return texelFetch(table, ivec2(i & 4095, i >> 12), 0);
}
uvec2 fetch_line(usampler2D table, int i) {
  return texelFetch(table, ivec2(i & 4095, i >> 12), 0).xy;
}
