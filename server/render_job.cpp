#include "server/render_job.h"

#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/metrics/flip.h"
#include "compare/metrics/rmse.h"
#include "compare/metrics/similarity_maps.h"
#include "compare/metrics/ssim.h"
#include "io/files/readable_text.h"
#include "io/images/tone_map.h"
#include "reports/markup/false_colour.h"
#include "reports/markup/pictures.h"
#include "stages/picture_view.h"
#include "stages/render_stage.h"
#include "stages/stopwatch.h"

namespace sturm {

namespace {

/// Nobody waits for the picture any more.
struct Ended : std::exception {
  const char* what() const noexcept override { return "the rendering was ended"; }
};

constexpr int window_of_ssim_px = 2 * SimilarityMaps::margin + 1;

Json comparison(const Image& page, const Image& native, const LayeredImage& picture) {
  if (std::min(page.width, page.height) < window_of_ssim_px) return nullptr;
  const Flip difference =
      flip(page, native, view_of(picture).pixels_per_degree.value_or(flip_default_pixels_per_degree));
  return {{"ssim", ssim(page, native).mean},
          {"flip", difference.mean},
          {"rmse_display", rmse(page, native)},
          {"flip_map", data_uri(sequential_false_colour(difference.map, {1.0, 0.0}))}};
}

Json rendered(const RenderRequest& request, const ProgressFunction& progress) {
  const Stopwatch watch;
  const RenderOutput output = render_view(request.spec, progress);
  const Image shown = to_display(output.shown(), 1.0);
  std::vector<std::string> notes;
  for (const std::string& note : output.notes) notes.push_back(readable(note));
  return {
      {"picture", data_uri(shown)},
      {"seconds", watch.seconds()},
      {"notes", notes},
      {"comparison", request.page_picture ? comparison(*request.page_picture, shown, output.image) : Json(nullptr)}};
}

}  // namespace

RenderJob::RenderJob(RenderRequest request) {
  outcome_ = std::async(std::launch::async, [this, asked = std::move(request)]() -> Json {
    try {
      return rendered(asked, [this](double fraction) {
        if (ended_) throw Ended();
        progress_ = fraction;
      });
    } catch (const std::exception& error) {
      return {{"error", readable_lines(error.what())}};
    }
  });
}

RenderJob::~RenderJob() {
  ended_ = true;
  if (outcome_.valid()) outcome_.wait();
}

}  // namespace sturm
