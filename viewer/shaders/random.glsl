/// Numbers addressed by pixel, sample and use: PCG's output function as a hash (Jarzynski & Olano 2020, pcg3d).
uvec3 random_state;

void seed_random(uvec2 pixel, uint sample_number) {
  random_state = uvec3(pixel.x | (pixel.y << 16u), sample_number, 0u);
}

vec2 random2() {
  ++random_state.z;
  uvec3 v = random_state * 1664525u + 1013904223u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return vec2(v.xy >> 8u) / 16777216.0;
}

/// Uniform over the unit disc (concentric map of Shirley & Chiu).
vec2 disc_of(vec2 u) {
  vec2 d = 2.0 * u - 1.0;
  if (d.x == 0.0 && d.y == 0.0) return vec2(0.0);
  bool wide = abs(d.x) > abs(d.y);
  float r = wide ? d.x : d.y;
  float angle = wide ? 0.25 * pi * d.y / d.x : 0.5 * pi - 0.25 * pi * d.x / d.y;
  return r * vec2(cos(angle), sin(angle));
}
