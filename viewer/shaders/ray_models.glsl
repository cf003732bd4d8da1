/// How the eye bends the ray that leaves it through a pupil point (docs/theory.md#5-ray-models), as
/// pathtrace/cameras/ray_model.h has it. Powers in dioptres, wearer frame.
const int model_pinhole = 0, model_thin_lens = 1, model_metalstigmatism = 2, model_sin2_radial = 3, model_power_matrix = 4, model_zernike = 5;
const int wave_terms = 66;  // of a polynomial of degree 10

uniform int u_ray_model;
uniform float u_pupil_radius;       // [m]
uniform vec3 u_correction;          // F: xx, xy, yy
uniform float u_focus_distance;     // d_f [m]; 0: infinite
uniform vec2 u_wave_slopes[wave_terms];  // of x^i y^j in p/radius, i + j ascending, then j
uniform int u_wave_degree;
uniform float u_wave_radius;        // [m]

struct PupilRay {
  vec2 p, s;      // point [m], slope [rad]
  bool launched;  // false at the pole of metalstigmatism
};

float meridional_power(vec2 p) {
  float square = dot(p, p);
  return square > 0.0 ? (u_correction.x * p.x * p.x + 2.0 * u_correction.y * p.x * p.y + u_correction.z * p.y * p.y) / square : 0.0;
}

PupilRay focal_distances_added(vec2 p) {
  if (u_focus_distance == 0.0) return PupilRay(p, vec2(0.0), true);
  float power = meridional_power(p), denominator = 1.0 + u_focus_distance * power;
  if (abs(denominator) < 1e-6) return PupilRay(p, vec2(0.0), false);
  return PupilRay(p, -power / denominator * p, true);
}

vec2 wave_slope(vec2 p) {
  vec2 at = p / u_wave_radius, sum = vec2(0.0);
  int k = 0;
  for (int degree = 0; degree <= u_wave_degree; ++degree)
    for (int j = 0; j <= degree; ++j) {
      float monomial = 1.0;
      for (int i = 0; i < degree - j; ++i) monomial *= at.x;
      for (int i = 0; i < j; ++i) monomial *= at.y;
      sum += monomial * u_wave_slopes[k++];
    }
  return sum;
}

/// S p of the linear models.
vec2 matrix_slope(vec2 p, float accommodation) {
  return vec2(dot(u_correction.xy, p), dot(u_correction.yz, p)) - accommodation * p;
}

/// `p`: pupil point [m].
PupilRay ray_through(vec2 p, float accommodation) {
  switch (u_ray_model) {
    case model_pinhole:
      return PupilRay(vec2(0.0), vec2(0.0), true);
    case model_thin_lens:
      return PupilRay(p, (0.5 * (u_correction.x + u_correction.z) - accommodation) * p, true);
    case model_metalstigmatism:
      return focal_distances_added(p);
    case model_sin2_radial:
      return PupilRay(p, (meridional_power(p) - accommodation) * p, true);
    case model_zernike:
      return PupilRay(p, wave_slope(p) - accommodation * p, true);
    default:
      return PupilRay(p, matrix_slope(p, accommodation), true);
  }
}
