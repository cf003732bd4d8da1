// What the same sources compute when they are compiled for this machine: the truth that the WebAssembly core is held
// to. viewer_reference fields          hashes of three blur fields as JSON viewer_reference ellipses FILE   20 000 blur
// ellipses: inputs and results as doubles
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "conoid/blur_field/depth_analytic_field.h"
#include "conoid/blur_field/voxel_fill.h"
#include "conoid/tracing/turned_eye.h"
#include "io/files/sha256.h"
#include "lensmodel/gaze.h"
#include "lensmodel/needed_power.h"
#include "lensmodel/progressive.h"
#include "lensmodel/single_vision.h"

namespace {

using namespace sturm;

/// The eye and the lenses that tests/viewer/core_bits.cjs builds from the same numbers.
Eye eye_of_the_fields() {
  return Eye::with({.sphere_D = -2.0, .cylinder_D = -1.5, .axis_deg = 30.0, .vertex_distance_m = 12e-3}, 4e-3,
                   FixedAccommodation{0.5, 0.0});
}

std::string hash_of(const void* data, std::size_t bytes) {
  return sha256(std::string_view(static_cast<const char*>(data), bytes));
}

void print_field(const char* name, const Spectacles* lens) {
  const Eye eye = eye_of_the_fields();
  const FieldGrid grid{32, 32, 256, 0.7, 0.5, 4.0, 0.0};
  const TracedDirections directions = trace_directions(lens, eye.rotation_center_m, grid);
  const DepthAnalyticField analytic(grid, directions, eye.correction);
  VoxelField voxels = fill_voxels(lens, eye, grid, directions);
  std::printf("\"%s\": {\"analytic\": \"%s\", \"voxels\": \"%s\"}", name,
              hash_of(analytic.nodes().data(), analytic.nodes().size() * sizeof(DepthAnalyticField::Node)).c_str(),
              hash_of(voxels.column(0), grid.voxels() * VoxelField::floats_per_voxel * sizeof(float)).c_str());
}

int print_fields() {
  const Prescription rx = needed_power(eye_of_the_fields(), 12e-3);
  const Spectacles toric = single_vision(rx, {});
  ProgressiveDesign design;
  design.lens.center_thickness_m = 2.2e-3;
  design.lens.refractive_index = 1.6;
  design.lens.diameter_m = 60e-3;
  design.addition_D = 2.0;
  design.near_shift_m = -2.5e-3;
  design.zone_width_m = 10e-3;
  const Spectacles progressive = progressive_lens(rx, design).lens;
  std::printf("{");
  print_field("naked", nullptr);
  std::printf(", ");
  print_field("toric", &toric);
  std::printf(", ");
  print_field("progressive", &progressive);
  std::printf("}\n");
  return 0;
}

/// Ten inputs (sphere, cylinder, AXIS, pupil, azimuth, elevation, distance, lens sphere, cylinder, AXIS; a lens AXIS of
/// −1: naked), then the map, the semi-axes in radians and the orientation (1000 where there is none). A third of them
/// is naked, a third looks straight through a lens, a third looks askance through one.
int write_ellipses(const char* file) {
  std::mt19937_64 random(1);
  const auto between = [&](double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(random() >> 11), -53);
  };
  const auto quarters = [&](double low, double high) { return 0.25 * std::nearbyint(4.0 * between(low, high)); };
  std::vector<double> numbers;
  for (int k = 0; k < 20000; ++k) {
    const bool naked = k % 3 == 0, askance = k % 3 == 2;
    const double axis = std::nearbyint(between(1, 180)), lens_axis = naked ? -1.0 : std::nearbyint(between(1, 180));
    const double azimuth = askance ? between(-0.6, 0.6) : 0.0, elevation = askance ? between(-0.6, 0.6) : 0.0;
    const double in[10] = {
        quarters(-12, 8), quarters(-6, 6), axis,     between(1e-3, 8e-3), azimuth, elevation, 1.0 / between(0.0, 5.0),
        quarters(-8, 6),  quarters(-4, 0), lens_axis};
    const Eye eye = Eye::with({.sphere_D = in[0], .cylinder_D = in[1], .axis_deg = in[2], .vertex_distance_m = 12e-3},
                              in[3], FixedAccommodation{0.25, 0.0});
    Spectacles lens;
    if (!naked)
      lens = single_vision({.sphere_D = in[7], .cylinder_D = in[8], .axis_deg = in[9], .vertex_distance_m = 12e-3}, {});
    const TurnedEye turned(eye, naked ? nullptr : &lens, gaze_direction(in[4], in[5]));
    if (turned.status() != LensStatus::ok) continue;
    const Footprint f = turned.footprint(in[6]);
    const Ellipse e = Ellipse::image_of_disc(f.angular, eye.pupil_radius_m);
    numbers.insert(numbers.end(), in, in + 10);
    numbers.insert(numbers.end(), {f.angular(0, 0), f.angular(0, 1), f.angular(1, 0), f.angular(1, 1), e.semi_major,
                                   e.semi_minor, e.orientation_deg.value_or(1000.0)});
  }
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(numbers.data()),
            static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return out ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "fields") == 0) return print_fields();
  if (count == 3 && std::strcmp(words[1], "ellipses") == 0) return write_ellipses(words[2]);
  std::fputs("viewer_reference fields | ellipses FILE\n", stderr);
  return 2;
}
