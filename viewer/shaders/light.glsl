/// Light that comes straight from a lamp, chosen in proportion to its power.
uniform sampler2D u_lights;  // kind, end of its share, share, shines behind | a, radius | b | c | radiance
uniform int u_light_count;
const float lamp_triangle = 0.0, lamp_sphere = 1.0, lamp_point = 2.0, lamp_sky = 3.0;

int chosen_light(float u) {
  int low = 0, high = u_light_count - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (u < fetch_line(u_lights, light_texels * middle).y) high = middle;
    else low = middle + 1;
  }
  return low;
}

/// 1 − cos of the half angle under which a ball is seen; 0 from within.
float ball_gap(vec3 to, float radius) {
  float sine2 = radius * radius / dot(to, to);
  return sine2 < 1.0 ? sine2 / (1.0 + sqrt(1.0 - sine2)) : 0.0;
}

/// Of a lamp of the table: the unit direction to a point of it, how far that is, and 1 over the density of the direction (of a point,
/// over the square of its distance).
float chosen_point(int first, float kind, bool behind, vec3 origin, vec2 u, out vec3 direction, out float distance_to) {
  vec4 a = fetch_line(u_lights, first + 1);
  vec3 to = a.xyz - origin;
  if (kind == lamp_triangle) {  // uniform over its area
    vec3 e1 = fetch_line(u_lights, first + 2).xyz - a.xyz, e2 = fetch_line(u_lights, first + 3).xyz - a.xyz;
    float root = sqrt(u.x);
    to += (1.0 - root) * e1 + root * u.y * e2;
    distance_to = length(to);
    direction = to / distance_to;
    float facing = -dot(0.5 * cross(e1, e2), direction);
    return (behind ? abs(facing) : max(0.0, facing)) / (distance_to * distance_to);
  }
  if (kind == lamp_sphere) {  // uniform over the cone that it fills
    float gap = ball_gap(to, a.w), cosine = 1.0 - u.x * gap, sine = sqrt(max(0.0, 1.0 - cosine * cosine)), angle = 2.0 * pi * u.y, square = dot(to, to);
    vec3 axis = normalize(to), side = normalize(abs(axis.x) < 0.5 ? cross(axis, vec3(1.0, 0.0, 0.0)) : cross(axis, vec3(0.0, 1.0, 0.0)));
    direction = cosine * axis + sine * (cos(angle) * side + sin(angle) * cross(axis, side));
    float along = dot(to, direction);
    distance_to = along - sqrt(max(0.0, a.w * a.w - (square - along * along)));
    return 2.0 * pi * gap;
  }
  distance_to = length(to);
  direction = to / distance_to;
  return 1.0 / (distance_to * distance_to);
}

/// Density [1/sr] with which a lamp's choice takes the direction to a place of this one, `distance_to` away.
float lamp_density(int light, vec3 origin, vec3 direction, float distance_to) {
  int first = light_texels * light;
  vec4 facts = fetch_line(u_lights, first), a = fetch_line(u_lights, first + 1);
  if (facts.x == lamp_sphere) {
    float gap = ball_gap(a.xyz - origin, a.w);
    return gap > 0.0 ? facts.z / (2.0 * pi * gap) : 0.0;
  }
  vec3 e1 = fetch_line(u_lights, first + 2).xyz - a.xyz, e2 = fetch_line(u_lights, first + 3).xyz - a.xyz;
  return facts.z * distance_to * distance_to / abs(dot(0.5 * cross(e1, e2), direction));
}

/// Radiance that a lobe reflects of one lamp, over the probability of its choice, and its share beside that of paths that find the lamp
/// by themselves. `normal`: of the surface, on the side that is lit; the frame is that of `outgoing`.
vec3 light_by_lobe(vec3 origin, vec3 normal, mat3 frame, vec3 outgoing, int material, int lobe) {
  if (u_light_count == 0) return vec3(0.0);
  int first = light_texels * chosen_light(random2().x);
  vec2 u = random2();
  vec4 facts = fetch_line(u_lights, first);
  vec3 direction = normal;
  float distance_to = never, density = 0.0;
  vec3 radiance;
  if (facts.x == lamp_sky) {
    radiance = chosen_sky(u, direction, density);
  } else {
    float weight = chosen_point(first, facts.x, facts.w > 0.5, origin, u, direction, distance_to) / facts.z;
    radiance = weight * fetch_line(u_lights, first + 4).rgb;
    if (facts.x != lamp_point && weight > 0.0) density = 1.0 / weight;
  }
  float of_lobe;
  vec3 incoming = direction * frame;
  radiance *= lobe_towards(material, lobe, outgoing, incoming, of_lobe);
  if (!(max(radiance.x, max(radiance.y, radiance.z)) > 0.0) || !(dot(normal, direction) > 0.0)) return vec3(0.0);
  if (lobe == matt) radiance *= through_coat(material, incoming.z);
  if (facts.x != lamp_point) radiance *= way_share(density, of_lobe);
  Hit between = first_hit(origin, direction, distance_to * 0.9999, true);
  return between.triangle >= 0 || between.sphere >= 0 ? vec3(0.0) : radiance;
}
