#pragma once
#include <span>
#include <string_view>

#include "compare/findings/measurement.h"

namespace sturm {

/// A statistic that is the largest or smallest of measurements: those of one quantity and model.
struct StatisticRule {
  enum class Per { Report, Model };  ///< one statistic, or one for each model, named "NAME/MODEL"

  const char* name;
  const char* section;
  const char* quantity;
  const char* model;  ///< null: of all models
  Extreme::Of of = Extreme::Of::Largest;
  bool with_error = false;  ///< the standard error of the measurement that decided becomes the statistic's
  Per per = Per::Report;
};

/// Adds the statistics of the rules, without a case where no measurement is meant.
void add_statistics(std::span<const StatisticRule> rules, const Measurements& measurements, Statistics& out);

/// Adds those measurements that are statistics by themselves.
void add_statistics_by_themselves(const Measurements& measurements, Statistics& out);

/// What a statistic is about: the section, and the model ("": any).
struct StatisticSubject {
  std::string section, model;
};

/// Of the statistic of that name; empty where no rule and no measurement makes it.
StatisticSubject subject_of(std::string_view statistic, std::span<const StatisticRule> rules,
                            const Measurements& measurements);

}  // namespace sturm
