#include "experiments/samplings/sampling_study.h"

#include <cmath>

#include "compare/images/paired_bias.h"
#include "compare/statistics/jackknife.h"
#include "experiments/run/replicates.h"
#include "pathtrace/cameras/general_camera.h"
#include "stages/image_files.h"
#include "stages/plan/camera_pose.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

constexpr double exposure = 1.0;
constexpr std::uint64_t reference_stream =
    0x5245464552454e43ull;  // the reference shares no numbers with what is compared with it

/// E[r²] over that of a uniform disc (docs/theory.md#53-pupil-sampling).
double mean_square_radius(const PupilSamplingSpec& spec) {
  if (spec.kind == PupilSampling::UniformPolar) return 2.0 / 3.0;
  if (spec.kind == PupilSampling::Rings) return (spec.rings + 1.0) / spec.rings;
  return 1.0;
}

RenderSettings settings_of(const SamplingStudySpec& study) {
  RenderSettings settings;
  settings.samples_per_pixel = static_cast<int>(study.samples_per_pixel);
  settings.max_bounces = study.max_bounces;
  return settings;
}

/// RMS deviation of one picture's pixels, all channels together, from the scatter between the replicates.
double noise_of(const Replicates& replicates) {
  const Image variance = replicates.variance_of_mean();
  double sum = 0.0;
  for (const float v : variance.pixels) sum += v;
  return std::sqrt(sum / static_cast<double>(variance.pixels.size()) * static_cast<double>(replicates.images.size()));
}

/// Of noise_of, by the jackknife over the pictures.
double noise_error_of(const Replicates& replicates) {
  std::vector<double> left_out;
  for (std::size_t k = 0; k < replicates.images.size(); ++k) {
    Replicates others = replicates;
    others.images.erase(others.images.begin() + static_cast<std::ptrdiff_t>(k));
    left_out.push_back(noise_of(others));
  }
  return jackknife_standard_error(left_out);
}

double mean_radiance(const Image& image) {
  double sum = 0.0;
  for (const float v : image.pixels) sum += v;
  return sum / static_cast<double>(image.pixels.size());
}

/// The pictures of one configuration, sampling and sampler, by the camera that knows every spread over the pupil.
Replicates sampled(const Scene& scene, const SamplingStudySpec& study, const SamplingConfiguration& configuration,
                   const PupilSamplingSpec& sampling, Sequence sampler, std::uint64_t seed) {
  ViewOptions options;
  options.pupil = PupilSampler(sampling, 0.0);
  const GeneralCamera camera(camera_pose(study.camera), configuration.eye, configuration.ray_model, std::move(options));
  RenderSettings settings = settings_of(study);
  settings.sequence = sampler;
  Replicates replicates;
  for (int r = 0; r < study.replicates; ++r) {
    settings.seed = replicate_seed(seed, r);
    replicates.images.push_back(render(scene, camera, settings).radiance);
  }
  return replicates;
}

}  // namespace

std::vector<SamplingEntry> sampling_entries(const SamplingStudySpec& study, std::size_t index, const Scene& scene,
                                            std::uint64_t seed, const std::filesystem::path& folder,
                                            const ProgressFunction& progress) {
  const SamplingConfiguration& configuration = study.configurations[index];
  const std::uint64_t own_seed = replicate_seed(seed, static_cast<int>(index));
  const Replicates reference =
      render_replicates(scene, camera_pose(study.camera), configuration.eye, configuration.ray_model,
                        settings_of(study), own_seed ^ reference_stream, study.replicates, [](double) {});
  const double brightness = mean_radiance(reference.mean());
  std::vector<SamplingEntry> entries;
  const double steps = static_cast<double>(study.samplings.size() * study.samplers.size()) + 1.0;
  for (std::size_t s = 0; s < study.samplers.size(); ++s)
    for (const PupilSamplingSpec& sampling : study.samplings) {
      progress((static_cast<double>(entries.size()) + 1.0) / steps);
      const Stopwatch watch;
      const Replicates pictures = sampled(scene, study, configuration, sampling, study.samplers[s],
                                          replicate_seed(own_seed, static_cast<int>(entries.size()) + 1));
      const double seconds = watch.seconds();
      const PairedBias bias = paired_bias(pictures.images, reference.images);
      const std::string file =
          "samplings/" + configuration.id + "_" + name_of(sampling.kind) + "_" + name_of(study.samplers[s]);
      write_picture(folder / file, pictures.mean(), exposure);
      entries.push_back({.configuration = configuration.id,
                         .note = configuration.note,
                         .ray_model = configuration.ray_model,
                         .sampling = sampling.kind,
                         .sampler = study.samplers[s],
                         .aspect_ratio = static_cast<double>(study.camera.width) / study.camera.height,
                         .pupil_rms_ratio = std::sqrt(mean_square_radius(sampling)),
                         .mean_radiance = brightness,
                         .noise = noise_of(pictures),
                         .noise_standard_error = noise_error_of(pictures),
                         .mean_square_bias = bias.mean_square,
                         .mean_square_bias_standard_error = bias.standard_error,
                         .z = bias.z,
                         .seconds = seconds,
                         .files = {file + ".exr", file + ".png"}});
    }
  return entries;
}

SamplingConditions conditions_of(const SamplingStudySpec& study) {
  return {.scene = study.scene_name,
          .pupil_mm = 2e3 * study.configurations.front().eye.pupil_radius_m,
          .samples_per_pixel = static_cast<std::int64_t>(study.samples_per_pixel),
          .replicates = study.replicates};
}

}  // namespace sturm
