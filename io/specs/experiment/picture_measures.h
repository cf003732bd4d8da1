#pragma once
#include <array>

namespace sturm {

/// What an experiment measures of path-traced and predicted pictures.
enum class PictureMeasures {
  Metrics,  ///< the mean of all predictions against the mean of all path-traced pictures; gates are shown mutations
  Regions   ///< single predictions by region of the picture, and what they are worth in path tracing's time
};

inline constexpr std::array picture_measures{PictureMeasures::Metrics, PictureMeasures::Regions};

/// The list of experiments and of reports that pictures with these measures stand in.
constexpr const char* list_name(PictureMeasures measures) {
  return measures == PictureMeasures::Metrics ? "images" : "agreement";
}

}  // namespace sturm
