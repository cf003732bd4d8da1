#include "experiments/figures/lens_plots.h"

#include "experiments/figures/gaze_figures.h"
#include "experiments/figures/lens_maps.h"
#include "reports/plots/lens_map.h"

namespace sturm {

namespace {

constexpr double corridor_limit_D = 0.5;

/// Pairs of maps one above the other.
class Pairs {
 public:
  void add(const std::vector<LensMap>& pair, const std::string& name) {
    mean_.push_back(pair[0]);
    cylinder_.push_back(pair[1]);
    for (LensMap* map : {&mean_.back(), &cylinder_.back()}) map->title = name + "\\n" + map->title;
  }

  Plot plot(std::optional<double> range) const {
    std::vector<LensMap> maps = mean_;
    maps.insert(maps.end(), cylinder_.begin(), cylinder_.end());
    return lens_map_plot(maps, {2, range});
  }

 private:
  std::vector<LensMap> mean_, cylinder_;
};

void add_differences(Pairs& pairs, const std::vector<NamedLens>& lenses, double rotation_center_m) {
  for (std::size_t i = 1; i < lenses.size(); ++i)
    pairs.add(as_worn_difference(lenses[0].lens, lenses[i].lens, rotation_center_m),
              lenses[i].name + " less " + lenses[0].name);
}

}  // namespace

Plot power_plot(const std::vector<NamedLens>& lenses, double rotation_center_m, bool with_differences,
                std::optional<double> range) {
  Pairs pairs;
  for (const NamedLens& lens : lenses) pairs.add(as_worn_maps(lens.lens, lens.nominal, rotation_center_m), lens.name);
  if (with_differences) add_differences(pairs, lenses, rotation_center_m);
  return pairs.plot(range);
}

Plot difference_plot(const std::vector<NamedLens>& lenses, double rotation_center_m, std::optional<double> range) {
  Pairs pairs;
  add_differences(pairs, lenses, rotation_center_m);
  return pairs.plot(range);
}

Plot defocus_plot(const std::vector<NamedLens>& lenses, double rotation_center_m,
                  const std::vector<double>& distances_m, double amplitude_D, std::optional<double> range) {
  std::vector<LensMap> maps;
  for (const double distance : distances_m)
    for (const NamedLens& lens : lenses) {
      maps.push_back(defocus_map(lens.lens, lens.nominal.moved_towards_eye(lens.lens.vertex_distance_m),
                                 rotation_center_m, distance, amplitude_D));
      maps.back().title = lens.name + "\\n" + maps.back().title;
    }
  return lens_map_plot(maps, {distances_m.size(), range});
}

std::vector<CorridorProfile> corridor_profiles(const std::vector<NamedLens>& lenses, double rotation_center_m) {
  std::vector<CorridorProfile> profiles;
  for (const NamedLens& lens : lenses)
    profiles.push_back(corridor_profile(lens.lens, lens.nominal, rotation_center_m, lens.name, corridor_limit_D));
  return profiles;
}

Plot fields_plot(const std::vector<NamedEye>& eyes, const std::vector<double>& distances_m, double clear_D,
                 std::optional<double> range_arcmin) {
  std::vector<EllipseField> fields;
  for (const NamedEye& eye : eyes)
    for (const double distance : distances_m)
      fields.push_back(ellipse_field(eye.worn, eye.name, distance, {}, clear_D));
  return ellipse_field_plot(fields, range_arcmin);
}

}  // namespace sturm
