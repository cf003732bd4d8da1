/// One sample of every pixel: a pass of the multipass picture (a point of the pupil for all pixels of a set, as `sturm render` takes
/// them), or a path through a random one.
uniform bool u_gathers;
uniform sampler2D u_passes;  // a row for each of 16 sets: point of the unit disc, place in the pixel
uniform int u_pass;
uniform int u_round;         // so many sets further on
uniform uint u_sample;
layout(location = 0) out vec4 result;
// What a filter asks: colour of what was met and its vergence [D], its normal and the square of the light.
layout(location = 1) out vec4 met_colour;
layout(location = 2) out vec4 met_normal;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.x, u_size.y - gl_FragCoord.y);
  seed_random(uint(pixel.y) * uint(u_size.x) + uint(pixel.x), u_sample);
  vec2 film, disc;
  if (u_gathers) {
    vec4 pass = texelFetch(u_passes, ivec2(u_pass, ((pixel.y % 4) * 4 + pixel.x % 4 + u_round) % 16), 0);
    film = pass.zw;
    disc = pass.xy;
  } else {
    film = random2();
    disc = disc_of(random2());
  }
  result = vec4(0.0, 0.0, 0.0, 1.0);
  met_colour = met_normal = vec4(0.0);
  vec2 place = vec2(pixel) + film;
  Sight sight = sight_at(place);
  if (u_gathers) {  // All passes of a pixel bend as in its middle, as `sturm render` has it.
    Sight middle = sight_at(vec2(pixel) + 0.5);
    sight = Sight(sight.origin, sight.direction, middle.offset_p, middle.offset_s, middle.slope_p, middle.slope_s, middle.reaches);
  }
  if (!sight.reaches) return;
  float accommodation = u_accommodation;
  if (u_seeks_focus) accommodation = accommodation_at(place, 1.0 / first_hit(sight.origin, sight.direction, never, false).t);
  PupilRay ray = ray_through(u_pupil_radius * disc, accommodation);
  if (!ray.launched) {
    result.a = 0.0;
    return;
  }
  vec3 origin, direction;
  bent_ray(sight, ray.p, ray.s, origin, direction);
  Hit hit = first_hit(origin, direction, never, false);
  vec3 colour, normal;
  result.rgb = radiance_along(hit, origin, direction, colour, normal);
  float light = dot(result.rgb, vec3(0.2126, 0.7152, 0.0722));
  met_colour = vec4(colour, 1.0 / (hit.t * length(direction)));
  met_normal = vec4(normal, light * light);
}
