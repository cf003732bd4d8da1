/// Light along a ray: paths with one lamp sampled at each matt or rough vertex, ended by Russian roulette.
uniform int u_max_bounces;

mat3 frame_about(vec3 n) {
  vec3 side = normalize(abs(n.x) < 0.5 ? cross(n, vec3(1.0, 0.0, 0.0)) : cross(n, vec3(0.0, 1.0, 0.0)));
  return mat3(side, cross(n, side), n);
}

/// Light that leaves `at` against `direction` by scattering. `lit`: what lamps bring to `at` itself is known already.
vec3 path_from(Surface at, vec3 direction, bool lit) {
  vec3 sum = vec3(0.0), throughput = vec3(1.0);
  for (int bounce = 0; bounce < u_max_bounces; ++bounce) {
    begin_vertex(bounce);
    bool inside = dot(at.normal, direction) > 0.0;
    float side = inside ? -1.0 : 1.0;
    vec3 normal = side * at.normal;
    int type = int(material_texel(at.material, 0).w);
    mat3 frame = frame_about(type == dielectric ? normal : side * at.shading_normal);
    vec3 outgoing = -normalize(direction) * frame;
    if (outgoing.z <= 0.0) {
      frame = frame_about(normal);
      outgoing = -normalize(direction) * frame;
    }
    Scattered next = scatter(at.material, outgoing, at.albedo, inside);
    vec3 origin = off_surface(at.position, normal), of_lamps = throughput * next.of_lamps;
    if (next.lobe != sharp && (bounce > 0 || !lit) && max(of_lamps.x, max(of_lamps.y, of_lamps.z)) > 0.0)
      sum += of_lamps * light_by_lobe(origin, normal, frame, outgoing, at.material, next.lobe);
    throughput *= next.throughput;
    if (next.lobe == matt) throughput *= through_coat(at.material, next.direction.z);
    if (max(throughput.x, max(throughput.y, throughput.z)) <= 0.0) break;
    float density;
    lobe_towards(at.material, next.lobe, outgoing, next.direction, density);
    if (bounce >= 3) {
      float survival = min(0.95, max(throughput.x, max(throughput.y, throughput.z)));
      if (random2().x >= survival) break;
      throughput /= survival;
    }
    direction = frame * next.direction;
    if (next.direction.z < 0.0) origin = off_surface(at.position, -normal);
    else if (dot(direction, normal) <= 0.0) break;
    Hit hit = first_hit(origin, direction, never, false);
    if (hit.triangle < 0 && hit.sphere < 0) {
      float share = density > 0.0 ? way_share(density, environment_density(direction)) : 1.0;
      sum += throughput * share * environment_along(direction);
      break;
    }
    at = surface_at(hit, origin, direction);
    if (shines_towards(at, direction)) {
      float share = density > 0.0 && at.light >= 0 ? way_share(density, lamp_density(at.light, origin, direction, hit.t)) : 1.0;
      sum += throughput * share * at.emission;
    }
  }
  return sum;
}

/// What comes along a ray whose first hit is known, and what the hit looks like: its own colour (of what shines, its light) and normal.
vec3 radiance_along(Hit hit, vec3 origin, vec3 direction, out vec3 colour, out vec3 normal) {
  normal = vec3(0.0);
  if (hit.triangle < 0 && hit.sphere < 0) return colour = environment_along(direction);
  Surface at = surface_at(hit, origin, direction);
  normal = dot(at.shading_normal, direction) > 0.0 ? -at.shading_normal : at.shading_normal;
  vec3 sum = shines_towards(at, direction) ? at.emission : vec3(0.0);
  int type = int(material_texel(at.material, 0).w);
  bool scatters = max(at.albedo.x, max(at.albedo.y, at.albedo.z)) > 0.0 || type != diffuse;
  colour = sum + (type == conductor || type == dielectric ? vec3(1.0) : at.albedo);
  return scatters ? sum + path_from(at, direction, false) : sum;
}
