/// Light that comes straight from a lamp, chosen in proportion to its power.
uniform sampler2D u_lights;  // kind, end of its share, share, shines behind | a, radius | b | c | radiance
uniform int u_light_count;

int chosen_light(float u) {
  int low = 0, high = u_light_count - 1;
  while (low < high) {
    int middle = (low + high) / 2;
    if (u < fetch_line(u_lights, light_texels * middle).y) high = middle;
    else low = middle + 1;
  }
  return low;
}

/// Radiance that a Lambertian surface of albedo 1 reflects of one lamp, over the probability of its choice: cos θ/π times what comes
/// in and passes the coat if there is one. `normal` on the side that is lit.
vec3 light_through_coat(vec3 origin, vec3 normal, int material) {
  if (u_light_count == 0) return vec3(0.0);
  int first = light_texels * chosen_light(random2().x);
  vec2 u = random2();
  vec4 facts = fetch_line(u_lights, first), a = fetch_line(u_lights, first + 1);
  vec3 radiance = fetch_line(u_lights, first + 4).rgb, to, direction;
  float weight, distance_to;
  if (facts.x == 0.0) {  // triangle, uniform over its area
    vec3 e1 = fetch_line(u_lights, first + 2).xyz - a.xyz, e2 = fetch_line(u_lights, first + 3).xyz - a.xyz;
    float root = sqrt(u.x);
    to = a.xyz + (1.0 - root) * e1 + root * u.y * e2 - origin;
    distance_to = length(to);
    direction = to / distance_to;
    vec3 area = 0.5 * cross(e1, e2);
    float facing = -dot(area, direction);
    weight = (facts.w > 0.5 ? abs(facing) : max(0.0, facing)) / (distance_to * distance_to);
  } else if (facts.x == 1.0) {  // sphere, uniform over the cone that it fills
    to = a.xyz - origin;
    float square = dot(to, to), sine2 = a.w * a.w / square;
    if (sine2 >= 1.0) return vec3(0.0);
    float gap = sine2 / (1.0 + sqrt(1.0 - sine2)), cosine = 1.0 - u.x * gap, sine = sqrt(max(0.0, 1.0 - cosine * cosine)), angle = 2.0 * pi * u.y;
    vec3 axis = normalize(to), side = normalize(abs(axis.x) < 0.5 ? cross(axis, vec3(1.0, 0.0, 0.0)) : cross(axis, vec3(0.0, 1.0, 0.0)));
    direction = cosine * axis + sine * (cos(angle) * side + sin(angle) * cross(axis, side));
    float along = dot(to, direction);
    distance_to = along - sqrt(max(0.0, a.w * a.w - (square - along * along)));
    weight = 2.0 * pi * gap;
  } else {  // point
    to = a.xyz - origin;
    distance_to = length(to);
    direction = to / distance_to;
    weight = 1.0 / (distance_to * distance_to);
  }
  float cosine = dot(normal, direction);
  if (!(weight > 0.0) || !(cosine > 0.0)) return vec3(0.0);
  Hit between = first_hit(origin, direction, distance_to * 0.9999, true);
  if (between.triangle >= 0 || between.sphere >= 0) return vec3(0.0);
  return radiance * (weight * cosine * through_coat(material, cosine) / (pi * facts.z));
}
