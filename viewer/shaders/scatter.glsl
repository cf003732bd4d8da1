/// Directions in which surfaces scatter, chosen in proportion to what they reflect (pathtrace/materials/). In a local frame with z
/// along the normal on the side of `outgoing`.
const int sharp = 0, matt = 1, facets = 2;  // lobes; lamps are chosen for the last two

struct Scattered {
  vec3 direction;   // local; z < 0: through the surface
  vec3 throughput;  // 0: absorbed
  int lobe;
  vec3 of_lamps;    // what multiplies lobe_towards() of a lamp's light
};

float fresnel(float cosine, float eta, out float far) {
  float sine2 = max(0.0, 1.0 - cosine * cosine) / (eta * eta);
  far = 0.0;
  if (sine2 >= 1.0) return 1.0;
  far = sqrt(1.0 - sine2);
  float parallel = (eta * cosine - far) / (eta * cosine + far), perpendicular = (cosine - eta * far) / (cosine + eta * far);
  return 0.5 * (parallel * parallel + perpendicular * perpendicular);
}

vec3 fresnel_metal(float cosine, vec3 eta, vec3 kappa) {
  float c2 = cosine * cosine, s2 = max(0.0, 1.0 - c2);
  vec3 n2 = eta * eta, k2 = kappa * kappa, t = n2 - k2 - s2, squares = sqrt(t * t + 4.0 * n2 * k2), a = sqrt(max(vec3(0.0), 0.5 * (squares + t)));
  vec3 perpendicular = (squares + c2 - 2.0 * a * cosine) / (squares + c2 + 2.0 * a * cosine);
  vec3 x = c2 * squares + s2 * s2, y = 2.0 * a * cosine * s2;
  return 0.5 * perpendicular * (1.0 + (x - y) / (x + y));
}

/// A lobe that is sharp without roughness.
int gloss(float roughness) {
  return roughness > 0.0 ? facets : sharp;
}

float smith_lambda(vec3 w, float alpha) {
  float q = alpha * alpha * dot(w.xy, w.xy) / (w.z * w.z);
  return 0.5 * q / (sqrt(1.0 + q) + 1.0);
}

/// A normal of GGX in proportion to its visible area (Heitz 2018).
vec3 visible_normal(vec3 outgoing, float alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha * outgoing.xy, outgoing.z));
  float flat_length = length(stretched.xy);
  vec3 first = flat_length > 0.0 ? vec3(-stretched.y, stretched.x, 0.0) / flat_length : vec3(1.0, 0.0, 0.0), second = cross(stretched, first);
  vec2 d = disc_of(u);
  float s = 0.5 * (1.0 + stretched.z), y = (1.0 - s) * sqrt(max(0.0, 1.0 - d.x * d.x)) + s * d.y;
  vec3 h = d.x * first + y * second + sqrt(max(0.0, 1.0 - d.x * d.x - y * y)) * stretched;
  return normalize(vec3(alpha * h.xy, max(1e-9, h.z)));
}

/// Reflection at facets: (1 + Λ(out))/(1 + Λ(out) + Λ(in)) is what visible normals leave of masking.
vec3 reflected_at_facets(vec3 outgoing, float roughness, vec2 u, out float cosine, out float shadowing) {
  shadowing = 1.0;
  vec3 h = vec3(0.0, 0.0, 1.0);
  float alpha = roughness * roughness;
  if (alpha > 0.0) h = visible_normal(outgoing, alpha, u);
  cosine = min(1.0, dot(outgoing, h));
  vec3 incoming = 2.0 * cosine * h - outgoing;
  if (incoming.z <= 0.0) shadowing = 0.0;
  else if (alpha > 0.0) shadowing = (1.0 + smith_lambda(outgoing, alpha)) / (1.0 + smith_lambda(outgoing, alpha) + smith_lambda(incoming, alpha));
  return incoming;
}

vec3 cosine_direction(vec2 u) {
  vec2 d = disc_of(u);
  return vec3(d, sqrt(max(0.0, 1.0 - dot(d, d))));
}

Scattered scatter_plastic(vec3 outgoing, vec3 albedo, float roughness, float index, float internal_reflectance) {
  float far, cosine, shadowing, coat = fresnel(outgoing.z, index, far);
  float below = (1.0 - coat) * max(albedo.x, max(albedo.y, albedo.z)), share = below > 0.0 ? coat / (coat + below) : 1.0;
  if (random2().x < share) {
    vec3 incoming = reflected_at_facets(outgoing, roughness, random2(), cosine, shadowing);
    return Scattered(incoming, vec3(fresnel(cosine, index, far) * shadowing / share), gloss(roughness), vec3(1.0 / share));
  }
  // The base: what passes the coat both ways. The way in is counted for each direction by `through_coat`.
  vec3 base = albedo / (1.0 - internal_reflectance * albedo) * ((1.0 - coat) / (index * index * (1.0 - share)));
  return Scattered(cosine_direction(random2()), base, matt, base);
}

Scattered scatter_glass(vec3 outgoing, float eta) {
  float far, reflectance = fresnel(outgoing.z, eta, far);
  if (random2().x < reflectance) return Scattered(vec3(-outgoing.xy, outgoing.z), vec3(1.0), sharp, vec3(0.0));
  return Scattered(vec3(-outgoing.xy / eta, -far), vec3(1.0 / (eta * eta)), sharp, vec3(0.0));
}

/// `inside`: the ray comes from behind the surface.
Scattered scatter(int material, vec3 outgoing, vec3 albedo, bool inside) {
  vec4 numbers = material_texel(material, 2);  // roughness, index, internal reflectance
  int type = int(material_texel(material, 0).w);
  if (type == conductor) {
    float cosine, shadowing;
    vec3 incoming = reflected_at_facets(outgoing, numbers.x, random2(), cosine, shadowing);
    return Scattered(incoming, shadowing * fresnel_metal(cosine, material_texel(material, 3).rgb, material_texel(material, 4).rgb), gloss(numbers.x), vec3(1.0));
  }
  if (type == dielectric) return scatter_glass(outgoing, inside ? 1.0 / numbers.y : numbers.y);
  if (type == plastic) return scatter_plastic(outgoing, albedo, numbers.x, numbers.y, numbers.z);
  return Scattered(cosine_direction(random2()), albedo, matt, albedo);
}

/// What of the light from a direction passes the coat to the base.
float through_coat(int material, float cosine) {
  if (int(material_texel(material, 0).w) != plastic) return 1.0;
  float far;
  return 1.0 - fresnel(cosine, material_texel(material, 2).y, far);
}

/// What a lobe reflects of the radiance from a direction, times its cosine (of the base, for albedo 1 and without its coat), and the
/// density [1/sr] with which it scatters there: 0 where lamps are not chosen.
vec3 lobe_towards(int material, int lobe, vec3 outgoing, vec3 incoming, out float density) {
  density = 0.0;
  if (lobe == sharp || incoming.z <= 0.0) return vec3(0.0);
  if (lobe == matt) {
    density = incoming.z / pi;
    return vec3(density);
  }
  vec4 numbers = material_texel(material, 2);
  float alpha = numbers.x * numbers.x, far;
  vec3 h = normalize(outgoing + incoming);
  float cosine = min(1.0, dot(outgoing, h)), a2 = alpha * alpha, q = dot(h.xy, h.xy) + a2 * h.z * h.z, scale = a2 / (4.0 * pi * q * q * outgoing.z);
  float masked = 1.0 + smith_lambda(outgoing, alpha);
  density = scale / masked;
  bool metal = int(material_texel(material, 0).w) == conductor;
  vec3 reflectance = metal ? fresnel_metal(cosine, material_texel(material, 3).rgb, material_texel(material, 4).rgb) : vec3(fresnel(cosine, numbers.y, far));
  return scale / (masked + smith_lambda(incoming, alpha)) * reflectance;
}
