/// Light from infinity: one colour, or a latitude–longitude picture that is constant within each of its pixels and chosen in proportion
/// to what it sends (pathtrace/lights/environment_map.h). A texel's fourth number is the end of its share of its row.
uniform vec3 u_environment;
uniform int u_environment_texture;    // −1: one colour
uniform float u_environment_turn;     // [rad]
uniform sampler2D u_environment_rows; // end of its share, share, cosines of its upper and lower edge
uniform float u_environment_share;    // of all choices of a lamp; 0: never chosen

struct Sky {
  int first;
  ivec2 size;
};

Sky sky() {
  vec4 facts = fetch_line(u_textures, u_environment_texture);
  return Sky(int(facts.x), ivec2(facts.yz));
}

/// Of a unit vector.
ivec2 sky_pixel(Sky picture, vec3 direction) {
  float turns = 0.5 + (atan(direction.x, -direction.z) - u_environment_turn) / (2.0 * pi), polar = acos(clamp(direction.y, -1.0, 1.0)) / pi;
  return min(ivec2(vec2(turns - floor(turns), polar) * vec2(picture.size)), picture.size - 1);
}

vec4 sky_texel(Sky picture, ivec2 at) {
  return fetch_line(u_texels, picture.first + at.y * picture.size.x + at.x);
}

/// `direction` of any length but 0.
vec3 environment_along(vec3 direction) {
  if (u_environment_texture < 0) return u_environment;
  Sky picture = sky();
  return u_environment * sky_texel(picture, sky_pixel(picture, normalize(direction))).rgb;
}

/// Density [1/sr] with which the lamps' choice takes this pixel.
float sky_density(Sky picture, ivec2 at) {
  vec4 row = fetch_line(u_environment_rows, at.y);
  float share = sky_texel(picture, at).a - (at.x > 0 ? sky_texel(picture, at - ivec2(1, 0)).a : 0.0);
  return u_environment_share * row.y * share * float(picture.size.x) / (2.0 * pi * (row.z - row.w));
}

float environment_density(vec3 unit) {
  if (u_environment_share == 0.0) return 0.0;
  Sky picture = sky();
  return sky_density(picture, sky_pixel(picture, unit));
}

/// A direction towards the surroundings; returns what comes from there over its density.
vec3 chosen_sky(vec2 u, out vec3 direction, out float density) {
  Sky picture = sky();
  int low = 0, high = picture.size.y - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (u.y < fetch_line(u_environment_rows, middle).x) high = middle;
    else low = middle + 1;
  }
  vec4 row = fetch_line(u_environment_rows, low);
  ivec2 at = ivec2(0, low);
  int last = picture.size.x - 1;
  while (at.x < last) {
    int middle = (at.x + last) / 2;
    if (u.x < sky_texel(picture, ivec2(middle, low)).a) last = middle;
    else at.x = middle + 1;
  }
  float begin = at.x > 0 ? sky_texel(picture, at - ivec2(1, 0)).a : 0.0, end = sky_texel(picture, at).a;
  vec2 within = clamp(vec2((u.x - begin) / max(end - begin, 1e-20), (row.x - u.y) / max(row.y, 1e-20)), 0.0, 1.0);
  float cosine = mix(row.w, row.z, within.y), sine = sqrt(max(0.0, 1.0 - cosine * cosine));
  float azimuth = ((float(at.x) + within.x) / float(picture.size.x) - 0.5) * 2.0 * pi + u_environment_turn;
  direction = vec3(sine * sin(azimuth), cosine, -sine * cos(azimuth));
  density = sky_density(picture, at);
  return u_environment * sky_texel(picture, at).rgb / density;
}

/// The power heuristic's share of one of two ways to a direction.
float way_share(float own, float other) {
  return own > 0.0 ? own * own / (own * own + other * other) : 0.0;
}
