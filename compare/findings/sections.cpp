#include "compare/findings/sections.h"

#include <array>

#include "compare/findings/bench.h"
#include "compare/findings/depth_psf_study.h"
#include "compare/findings/design_study.h"
#include "compare/findings/ellipse_numbers.h"
#include "compare/findings/gate_power.h"
#include "compare/findings/lens_study.h"
#include "compare/findings/must_fail.h"
#include "compare/findings/picture_numbers.h"
#include "compare/findings/psf_numbers.h"
#include "compare/findings/reference.h"
#include "compare/findings/sampling_study.h"
#include "compare/findings/sin2_study.h"

namespace sturm {

std::span<const FindingSection> finding_sections() {
  static const std::array sections = {
      FindingSection{"reference", measure_reference, {}},
      FindingSection{"ellipses", measure_ellipses, ellipse_rules(), true},
      FindingSection{"psfs", measure_psfs, psf_rules(), true},
      FindingSection{"pictures", measure_pictures, picture_rules()},
      FindingSection{"depth_psf_study", measure_depth_psf_study, {}},
      FindingSection{"lens_study", measure_lens_study, lens_study_rules()},
      FindingSection{"sin2_study", measure_sin2_study, sin2_study_rules()},
      FindingSection{"design_study", measure_design_study, design_study_rules()},
      FindingSection{"sampling_study", measure_sampling_study, sampling_study_rules()},
      FindingSection{"bench", measure_bench, {}},
      FindingSection{"must_fail", measure_must_fail, must_fail_rules()},
      FindingSection{"gate_power", measure_gate_power, gate_power_rules()},
  };
  return sections;
}

Measurements measurements_of(const Json& report, std::span<const FindingSection> sections) {
  Measurements all;
  for (const FindingSection& section : sections) section.measure(report, all);
  return all;
}

StatisticSubject subject_of(std::string_view statistic, const Measurements& measurements,
                            std::span<const FindingSection> sections) {
  for (const FindingSection& section : sections)
    if (StatisticSubject subject = subject_of(statistic, section.rules, {}); !subject.section.empty()) return subject;
  return subject_of(statistic, {}, measurements);
}

}  // namespace sturm
