#include "experiments/sections.h"

#include <array>

#include "experiments/bench/section.h"
#include "experiments/depth_psf/section.h"
#include "experiments/design_study/section.h"
#include "experiments/lens_study/section.h"
#include "experiments/samplings/section.h"
#include "experiments/sin2_study/section.h"
#include "experiments/standard/ellipse_section.h"
#include "experiments/standard/picture_section.h"
#include "experiments/standard/psf_section.h"
#include "experiments/standard/reference_section.h"

namespace sturm {

std::span<const ExperimentSection> experiment_sections() {
  static constexpr std::array sections = {
      ExperimentSection{"reference", nullptr, nullptr, prepared_reference},
      ExperimentSection{"ellipses", "sin2_sentence", nullptr, prepared_ellipses},
      ExperimentSection{"psfs", nullptr, nullptr, prepared_psfs},
      ExperimentSection{"pictures", nullptr, nullptr, prepared_pictures},
      ExperimentSection{"depth_psf_study", nullptr, nullptr, prepared_depth_psf_study},
      ExperimentSection{"lens_study", "lens_sentence", "lens_study.csv", prepared_lens_study},
      ExperimentSection{"sin2_study", "sin2_study_sentence", "sin2_study.csv", prepared_sin2_study},
      ExperimentSection{"design_study", "design_sentence", "design_study.csv", prepared_design_study},
      ExperimentSection{"sampling_study", nullptr, nullptr, prepared_sampling_study},
      ExperimentSection{"bench", "bench_sentence", nullptr, prepared_bench},
  };
  return sections;
}

}  // namespace sturm
