/// Numbers addressed by pixel, sample and dimension: padded Owen-scrambled (0,2)-sequences as pathtrace/sampling/owen_sobol.h has them,
/// so that places in the pixel and points of the pupil are those of `sturm render` with the same seed.
const uint random_film = 0u, random_lens = 1u, random_first_vertex = 2u, random_per_vertex = 8u;

uniform uint u_seed;
uint random_key, random_sample, random_dimension;

uint reversed_bits(uint x) {
  x = (x << 16u) | (x >> 16u);
  x = ((x & 0x00ff00ffu) << 8u) | ((x >> 8u) & 0x00ff00ffu);
  x = ((x & 0x0f0f0f0fu) << 4u) | ((x >> 4u) & 0x0f0f0f0fu);
  x = ((x & 0x33333333u) << 2u) | ((x >> 2u) & 0x33333333u);
  return ((x & 0x55555555u) << 1u) | ((x >> 1u) & 0x55555555u);
}

/// Owen scrambling in bit-reversed space.
uint scrambled(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  return x ^ (x * 0x53a22864u);
}

uint mixed(uint x) {
  x ^= x >> 16u;
  x *= 0x7feb352du;
  x ^= x >> 15u;
  x *= 0x846ca68bu;
  return x ^ (x >> 16u);
}

uint combined(uint a, uint b) {
  return mixed(a ^ (b * 0x9e3779b9u + 0x85ebca6bu));
}

/// The second Sobol dimension in bit-reversed space.
uint second_dimension(uint x) {
  x ^= x >> 16u;
  x ^= (x & 0xff00ff00u) >> 8u;
  x ^= (x & 0xf0f0f0f0u) >> 4u;
  x ^= (x & 0xccccccccu) >> 2u;
  return x ^ ((x & 0xaaaaaaaau) >> 1u);
}

/// `place`: number of the pixel, or of whatever has samples of its own.
void seed_random(uint place, uint sample_number) {
  random_key = combined(combined(u_seed, 0u), place);
  random_sample = reversed_bits(sample_number);
  random_dimension = random_film;
}

/// Each vertex of a path has dimensions of its own, whatever the ones before it took.
void begin_vertex(int bounce) {
  random_dimension = random_first_vertex + random_per_vertex * uint(bounce);
}

vec2 random2() {
  uint key = combined(random_key, random_dimension++);
  uint shuffled = reversed_bits(scrambled(random_sample, key));
  uvec2 words = uvec2(reversed_bits(scrambled(shuffled, mixed(key ^ 0x68bc21ebu))), reversed_bits(scrambled(second_dimension(shuffled), mixed(key ^ 0x02e5be93u))));
  return vec2(words >> 8u) / 16777216.0;
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
