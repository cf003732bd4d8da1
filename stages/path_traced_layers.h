#pragma once
#include <map>
#include <string>

#include "io/json/json.h"
#include "io/specs/render_spec.h"
#include "pathtrace/film/render.h"

namespace sturm {

/// Whether a picture may have fewer samples than samples_per_pixel; its manifest then has a section "sampling".
bool may_stop_early(const RenderSpec& spec);

/// That section: samples spent, kept and saved, tiles that converged, the rule that ended it.
Json sampling_json(const PassSummary& passes, const RenderSpec& spec);

/// What a manifest says about a picture that a budget of time has ended.
std::string interruption_note(const PassSummary& passes, const RenderSpec& spec);

/// What a manifest says about a denoised layer.
extern const char* const denoised_note;

/// The layers of one eye's picture, with "denoised" where the document asks for it.
std::map<std::string, Image> path_traced_layers(RenderResult result, const RenderSpec& spec);

}  // namespace sturm
