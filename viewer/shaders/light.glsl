/// Light that comes straight from a lamp, chosen in proportion to its power.
uniform sampler2D u_lights;  // kind, end of its share, share, shines behind | a, radius | b | c | radiance
uniform int u_light_count;
const float lamp_triangle = 0.0, lamp_sphere = 1.0, lamp_sky = 3.0;

int chosen_light(float u) {
  int low = 0, high = u_light_count - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (u < fetch_line(u_lights, light_texels * middle).y) high = middle;
    else low = middle + 1;
  }
  return low;
}

/// Of a lamp of the table: the unit direction to a point of it, how far that is, and its radiance over the density of the direction.
vec3 chosen_point(int first, float kind, bool behind, vec3 origin, vec2 u, out vec3 direction, out float distance_to) {
  vec4 a = fetch_line(u_lights, first + 1);
  vec3 to = a.xyz - origin;
  float weight;
  if (kind == lamp_triangle) {  // uniform over its area
    vec3 e1 = fetch_line(u_lights, first + 2).xyz - a.xyz, e2 = fetch_line(u_lights, first + 3).xyz - a.xyz;
    float root = sqrt(u.x);
    to += (1.0 - root) * e1 + root * u.y * e2;
    distance_to = length(to);
    direction = to / distance_to;
    float facing = -dot(0.5 * cross(e1, e2), direction);
    weight = (behind ? abs(facing) : max(0.0, facing)) / (distance_to * distance_to);
  } else if (kind == lamp_sphere) {  // uniform over the cone that it fills
    float square = dot(to, to), sine2 = a.w * a.w / square;
    if (sine2 >= 1.0) return vec3(0.0);
    float gap = sine2 / (1.0 + sqrt(1.0 - sine2)), cosine = 1.0 - u.x * gap, sine = sqrt(max(0.0, 1.0 - cosine * cosine)), angle = 2.0 * pi * u.y;
    vec3 axis = normalize(to), side = normalize(abs(axis.x) < 0.5 ? cross(axis, vec3(1.0, 0.0, 0.0)) : cross(axis, vec3(0.0, 1.0, 0.0)));
    direction = cosine * axis + sine * (cos(angle) * side + sin(angle) * cross(axis, side));
    float along = dot(to, direction);
    distance_to = along - sqrt(max(0.0, a.w * a.w - (square - along * along)));
    weight = 2.0 * pi * gap;
  } else {  // a point
    distance_to = length(to);
    direction = to / distance_to;
    weight = 1.0 / (distance_to * distance_to);
  }
  return weight * fetch_line(u_lights, first + 4).rgb;
}

/// Radiance that a Lambertian surface of albedo 1 reflects of one lamp, over the probability of its choice: cos θ/π times what comes
/// in and passes the coat if there is one. `normal` on the side that is lit.
vec3 light_through_coat(vec3 origin, vec3 normal, int material) {
  if (u_light_count == 0) return vec3(0.0);
  int first = light_texels * chosen_light(random2().x);
  vec2 u = random2();
  vec4 facts = fetch_line(u_lights, first);
  vec3 direction = normal;
  float distance_to = never, density = 0.0;
  vec3 radiance = facts.x == lamp_sky ? chosen_sky(u, direction, density) : chosen_point(first, facts.x, facts.w > 0.5, origin, u, direction, distance_to) / facts.z;
  float cosine = dot(normal, direction);
  if (!(max(radiance.x, max(radiance.y, radiance.z)) > 0.0) || !(cosine > 0.0)) return vec3(0.0);
  // Paths find the sky as well.
  if (facts.x == lamp_sky) radiance *= way_share(density, cosine / pi);
  Hit between = first_hit(origin, direction, distance_to * 0.9999, true);
  if (between.triangle >= 0 || between.sphere >= 0) return vec3(0.0);
  return radiance * (cosine * through_coat(material, cosine) / pi);
}
