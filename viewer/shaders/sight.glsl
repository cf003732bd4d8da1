/// The rays that one place of the picture gathers, to first order (conoid/pictures/sight_field.h): a naked eye's in
/// closed form, through spectacles those of a grid that the core has traced, linear in between.
uniform mat3 u_head;         // right, up, back of the head in the world
uniform vec3 u_position;     // pupil centre in primary gaze [m]
uniform vec2 u_size;         // of the picture [px]
uniform vec2 u_center;       // where straight ahead is in it [px], y down
uniform vec2 u_pixel_slope;  // of a pixel's width and height
uniform bool u_foveal;
uniform bool u_sphere;       // the picture is of all directions; the head turns to each and the eye looks straight ahead
uniform float u_rotation_center;  // behind the pupil [m]
uniform bool u_lens;
uniform sampler2D u_sights;  // 10 texels a node, head frame: origin and how far within the rim, direction, columns of the four maps
uniform vec2 u_sight_nodes;
uniform vec2 u_sight_first, u_sight_step;  // chief slopes
uniform sampler2D u_focus;   // accommodation by vergence and direction
uniform bool u_seeks_focus;
uniform float u_accommodation;
uniform float u_focus_last_vergence;

struct Sight {
  vec3 origin, direction;
  mat2x3 offset_p, offset_s, slope_p, slope_s;
  bool reaches;
};

/// Columns right, up, back of the head.
mat3 head_at(vec2 place) {
  if (!u_sphere) return u_head;
  float longitude = (place.x / u_size.x - 0.5) * 2.0 * pi, latitude = (0.5 - place.y / u_size.y) * pi;
  float sx = sin(longitude), cx = cos(longitude), sy = sin(latitude), cy = cos(latitude);
  return u_head * mat3(cx, 0.0, sx, -sx * sy, cy, cx * sy, -sx * cy, -sy, cx * cy);
}

vec2 slope_of(vec2 place) {
  if (u_sphere) return vec2(0.0);
  return vec2(place.x - u_center.x, u_center.y - place.y) * u_pixel_slope;
}

/// The smallest rotation that takes straight ahead to `gaze`; its first two columns.
mat2x3 turned_frame(vec3 gaze) {
  float scale = 1.0 / (1.0 - gaze.z);
  return mat2x3(vec3(1.0 - scale * gaze.x * gaze.x, -scale * gaze.x * gaze.y, gaze.x),
                vec3(-scale * gaze.x * gaze.y, 1.0 - scale * gaze.y * gaze.y, gaze.y));
}

Sight naked_sight(vec2 place, mat3 head) {
  vec3 toward = vec3(slope_of(place), -1.0);
  mat2x3 none = mat2x3(0.0), frame = mat2x3(head[0], head[1]);
  if (!u_foveal || u_sphere) return Sight(u_position, head * toward, frame, none, none, frame, true);
  vec3 gaze = normalize(toward);
  frame = head * turned_frame(gaze);
  vec3 pupil = u_rotation_center * (gaze + vec3(0.0, 0.0, 1.0));
  return Sight(u_position + head * pupil, head * gaze, frame, none, none, frame, true);
}

/// Texel k of the grid at a place between nodes; beyond the grid its last cell goes on.
vec4 grid_texel(vec2 at, int k) {
  vec2 corner = clamp(floor(at), vec2(0.0), u_sight_nodes - 2.0), f = at - corner;
  ivec2 node = ivec2(corner);
  ivec2 first = ivec2(10 * node.x + k, node.y), right = ivec2(10, 0), down = ivec2(0, 1);
  return mix(mix(texelFetch(u_sights, first, 0), texelFetch(u_sights, first + right, 0), f.x),
             mix(texelFetch(u_sights, first + down, 0), texelFetch(u_sights, first + right + down, 0), f.x), f.y);
}

vec2 grid_place(vec2 place) {
  return (slope_of(place) - u_sight_first) / u_sight_step;
}

/// Whether spectacles let the line of sight of a place through.
bool within_rim(vec2 place) {
  return !u_lens || grid_texel(grid_place(place), 0).w > 0.0;
}

mat2x3 grid_map(vec2 at, int k, mat3 head) {
  return head * mat2x3(grid_texel(at, k).xyz, grid_texel(at, k + 1).xyz);
}

Sight sight_at(vec2 place) {
  mat3 head = head_at(place);
  if (!u_lens) return naked_sight(place, head);
  vec2 at = grid_place(place);
  vec4 origin = grid_texel(at, 0);
  return Sight(u_position + head * origin.xyz, head * grid_texel(at, 1).xyz, grid_map(at, 2, head), grid_map(at, 4, head), grid_map(at, 6, head), grid_map(at, 8, head),
               origin.w > 0.0);
}

/// Accommodation [D] of an eye that looks at this vergence there.
float accommodation_at(vec2 place, float vergence) {
  if (!u_seeks_focus) return u_accommodation;
  ivec2 size = textureSize(u_focus, 0);
  vec2 cells = vec2(size.y - 1, size.x - 1);
  float column = clamp(vergence / u_focus_last_vergence, 0.0, 1.0) * cells.y;
  int i = min(int(column), size.x - 2), j = int((u_sphere ? 0.5 : clamp(place.y / u_size.y, 0.0, 1.0)) * cells.x + 0.5);
  return mix(texelFetch(u_focus, ivec2(i, j), 0).x, texelFetch(u_focus, ivec2(i + 1, j), 0).x, column - float(i));
}

void bent_ray(Sight sight, vec2 p, vec2 s, out vec3 origin, out vec3 direction) {
  origin = sight.origin + sight.offset_p * p + sight.offset_s * s;
  direction = sight.direction + sight.slope_p * p + sight.slope_s * s;
}
