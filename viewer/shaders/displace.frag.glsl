/// Where in the picture each vertex of the drawn mesh is seen through a point of the pupil, once for all points: a polynomial of the
/// second degree in it, through the pupil's middle and five points about it. A place is that whose first-order ray through the pupil
/// point meets the vertex, by Newton's iteration on the field.
uniform sampler2D u_vertices;  // two texels a vertex: position, material | normal
uniform sampler2D u_shown;     // more than 0 for vertices that are drawn
uniform float u_nearest;       // [m]
layout(location = 0) out vec4 middle;   // place of the middle [px], `never` where there is none | by x·y of the unit disc
layout(location = 1) out vec4 by;       // by x | by y
layout(location = 2) out vec4 squares;  // by x² | by y²

/// Planar head coordinates → where a pinhole in the pupil's centre would see the point [px].
vec2 projected(vec3 point) {
  vec3 seen = (point - u_position) * u_head;
  return u_center + vec2(seen.x, -seen.y) / (max(-seen.z, 1e-3) * u_pixel_slope);
}

/// How far the ray of a place through the pupil point passes from the vertex, per metre of distance, on the head's two axes across it.
/// `t`: the distance, as known before and as found.
vec2 missed(Sight sight, vec2 place, vec3 point, vec2 p, inout float t) {
  vec3 origin, direction;
  bent_ray(sight, p, matrix_slope(p, accommodation_at(place, 1.0 / max(t, 1e-4))), origin, direction);
  vec3 to = point - origin;
  t = dot(to, direction) / dot(direction, direction);
  return (to - t * direction) * mat2x3(u_head[0], u_head[1]) / max(abs(t), 1e-4);
}

/// Of the pupil's middle; false where there is no place, or none that was found. `back`: what has been missed → step in the picture.
bool found(vec3 point, inout vec2 place, inout float t, out mat2 back) {
  vec2 step = vec2(0.0);
  // Two or three steps, but for places at and beyond a rim, where the field bends most.
  for (int k = 0; k < 10 && (k == 0 || length(step) > 0.02); ++k) {
    float ahead = t;
    vec2 here = missed(sight_at(place), place, point, vec2(0.0), t), to_right = place + vec2(1.0, 0.0), below = place + vec2(0.0, 1.0);
    vec2 at_right = missed(sight_at(to_right), to_right, point, vec2(0.0), ahead);
    ahead = t;
    back = inverse(mat2(at_right - here, missed(sight_at(below), below, point, vec2(0.0), ahead) - here));
    step = clamp(back * here, vec2(-0.5 * u_size.y), vec2(0.5 * u_size.y));
    place -= step;
  }
  return t > 0.0 && length(step) < 1.0;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy);
  if (texelFetch(u_shown, texel, 0).x == 0.0) discard;
  vec3 point = fetch_line(u_vertices, 2 * (texel.y * 1024 + texel.x)).xyz;
  middle = vec4(never);
  by = squares = vec4(0.0);
  if (dot(point - u_position, u_head[2]) > -u_nearest) return;
  vec2 place = projected(point);
  float t = length(point - u_position);
  mat2 back;
  if (!found(point, place, t, back)) return;
  Sight sight = sight_at(place);
  // Two steps by the same matrix for each: displacements are small beside what the field changes over.
  vec2 mean = vec2(0.0), cosines = vec2(0.0), sines = vec2(0.0), cosines2 = vec2(0.0), sines2 = vec2(0.0);
  const float radius = 0.8, points = 5.0;
  for (float k = 0.0; k < points; ++k) {
    float turn = 2.0 * pi * k / points, t_there = t;
    vec2 p = radius * u_pupil_radius * vec2(cos(turn), sin(turn)), there = place - back * missed(sight, place, point, p, t_there);
    there -= back * missed(sight_at(there), there, point, p, t_there) + place;
    mean += there / points;
    cosines += 2.0 * cos(turn) * there / points;
    sines += 2.0 * sin(turn) * there / points;
    cosines2 += 2.0 * cos(2.0 * turn) * there / points;
    sines2 += 2.0 * sin(2.0 * turn) * there / points;
  }
  middle = vec4(place, 2.0 * sines2 / (radius * radius));
  by = vec4(cosines, sines) / radius;
  squares = vec4(mean + cosines2, mean - cosines2) / (radius * radius);
}
