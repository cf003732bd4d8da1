#include "compare/findings/prediction_reasons.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "io/files/formatted_text.h"

namespace sturm {

namespace {

struct Place {
  std::string name;
  double share, pixels;
};

/// The parts of the picture with the most of something (at least a tenth, at most three), the most first.
std::vector<Place> worst_places(const PredictionFinding& prediction, Number CauseShares::*share) {
  std::vector<Place> places;
  double pixels = 0.0;
  for (const CauseShares& cause : prediction.causes) {
    const Number& of_all = cause.*share;
    if (!of_all || !cause.pixels) continue;
    const auto size = static_cast<double>(*cause.pixels);
    pixels += size;
    places.push_back({cause.name, *of_all, size});
  }
  for (Place& place : places) place.pixels /= pixels;
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.share > b.share; });
  std::erase_if(places, [](const Place& p) { return p.share < 0.1; });
  if (places.size() > 3) places.erase(places.begin() + 3, places.end());
  return places;
}

/// Two digits, and three of a hundred.
std::string percent_of(double share) {
  return formatted(share < 0.995 ? "%.2g" : "%.0f", 100.0 * share);
}

std::string by_place(const PredictionFinding& prediction, Number CauseShares::*share) {
  std::string list;
  for (const Place& p : worst_places(prediction, share))
    list += formatted("%s%.0f %% %s (%s %% of the pixels)", list.empty() ? "" : ", ", 100.0 * p.share,
                      cause_in_words(p.name).c_str(), percent_of(p.pixels).c_str());
  return list;
}

std::string on_similarity(const PictureFinding& view, const PredictionFinding& prediction) {
  const Number ssim = prediction.whole().ssim.value_or(Estimate{}).value;
  const auto& [total, reference, noise, method] = prediction.similarity_loss;
  const std::optional<std::uint64_t>&paths = view.samples_per_pixel, &sharp = view.sharp_samples_per_pixel;
  if (!ssim || !reference || !noise || !method || !paths || !sharp) return "";
  if (*ssim >= similarity_bar) return formatted("SSIM %.4f reaches %.2f.", *ssim, similarity_bar);
  return formatted(
             "SSIM %.4f misses %.2f. Of the %.4f that are missing to 1, %.4f are noise of the reference (%.0f paths "
             "per pixel), %.4f noise "
             "of the "
             "prediction (sharp view of %.0f), %.4f the method",
             *ssim, similarity_bar, 1.0 - *ssim, *reference, static_cast<double>(*paths), *noise,
             static_cast<double>(*sharp), *method) +
         (*ssim + *reference >= similarity_bar ? "; without the reference's noise the bar is reached" : "") +
         ". By place: " + by_place(prediction, &CauseShares::similarity_loss) + ".";
}

std::string on_time(const PredictionFinding& prediction) {
  const Number &faster = prediction.times_faster, &cost = prediction.cost_in_paths,
               &paths = prediction.samples_of_equal_error, &needed = prediction.rmse_needed,
               &error = prediction.squared_error.total, &noise = prediction.squared_error.prediction_noise;
  if (!faster || !cost || !paths || !error || !noise) return "";
  const std::string start = plain_number(*faster, 3) + " × faster than path tracing to the same error (" +
                            plain_number(*paths, 3) + " paths per pixel)";
  if (*faster >= speed_bar) return start + formatted(" reaches %.0f.", speed_bar);
  return start + formatted(" misses %.0f. The prediction takes the time of ", speed_bar) + plain_number(*cost, 3) +
         " paths per pixel" +
         (needed ? formatted(
                       ", so %.0f × needed the RMSE %.2g that path tracing has after %.0f times as many; it has %.2g",
                       speed_bar, *needed, speed_bar, std::sqrt(std::max(0.0, *error)))
                 : "") +
         formatted(". Of its squared error %.0f %% are noise of the prediction. By place: ",
                   100.0 * std::clamp(*noise / *error, 0.0, 1.0)) +
         by_place(prediction, &CauseShares::squared_error) + ".";
}

}  // namespace

std::string cause_in_words(const std::string& name) {
  static const std::map<std::string, std::string> words = {
      {"lamp_rims", "in the blur of lamps' rims"},
      {"specular", "on mirrors, glass and metals, painted with what the pupil's centre sees in them"},
      {"occlusion_edges", "at edges of depth"},
      {"in_focus", "elsewhere in focus, where blur averages no noise"},
      {"blurred", "elsewhere in blur"}};
  const auto found = words.find(name);
  return found != words.end() ? found->second : name;
}

std::vector<std::string> prediction_reasons(const PictureFinding& view, const PredictionFinding& prediction) {
  std::vector<std::string> reasons;
  for (const std::string& sentence : {on_similarity(view, prediction), on_time(prediction)})
    if (!sentence.empty()) reasons.push_back(sentence);
  return reasons;
}

}  // namespace sturm
