#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/ellipse_table.h"
#include "app/option_values.h"
#include "app/several_documents.h"
#include "io/json/values.h"
#include "stages/ellipse_stage.h"

namespace sturm {

namespace {

/// What is asked where no document says more.
Json usual_query() {
  return {{"format", "sturm.ellipse/1"},
          {"eye", {{"pupil_diameter_mm", 4}}},
          {"targets", {{{"distance_m", 0.4}}, {{"distance_m", 1}}, {{"distance_m", 6}}, {{"distance_m", "inf"}}}},
          {"methods", {"conoid"}}};
}

/// The targets that the options name, each distance for each gaze; distances of the document where they name none.
void apply_targets(Json& document, const EllipseOptions& options) {
  Json distances = Json::array();
  for (const std::string& text : options.distances_m)
    distances.push_back(distance_json(distance_option(text, "--distance")));
  if (distances.empty() && document.is_object() && document.value("targets", Json()).is_array())
    for (const Json& target : document["targets"])
      if (target.is_object() && target.contains("distance_m")) distances.push_back(target["distance_m"]);
  std::vector<Json> targets{Json::object()};
  if (!options.gazes_deg.empty()) targets.clear();
  for (const std::string& text : options.gazes_deg) {
    const auto [azimuth, elevation] =
        pair_option(text, ',', "--gaze", "AZIMUTH,ELEVATION [deg], to the wearer's right and up");
    targets.push_back({{"gaze_deg", {azimuth, elevation}}});
  }
  document["targets"] = Json::array();
  for (Json target : targets)
    for (const Json& distance : distances) {
      target["distance_m"] = distance;
      document["targets"].push_back(target);
    }
}

Json asked_for(const CommonOptions& common, const EllipseOptions& options) {
  Json document = load_configuration(common, usual_query());
  if (!document.is_object()) return document;  // the reader says what is wrong
  if (!options.distances_m.empty() || !options.gazes_deg.empty()) apply_targets(document, options);
  if (!options.methods.empty()) document["methods"] = options.methods;
  return document;
}

}  // namespace

int ellipse_command(const CommonOptions& given, const EllipseOptions& options) {
  if (given.print_config) {
    const CommonOptions one = with_source(with_one_document(given, "--print-config"));
    return print_configuration(asked_for(one, options), one.file, options.output);
  }
  const AnswerKind kind = answer_kind(options.answer, options.output, given.files.size());
  const std::vector<std::string> files = files_of(given);
  const std::vector<std::string> names = document_names(files);
  std::vector<AnsweredQuery> answers;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const EllipseQuery query = read_ellipse_query(asked_for(with_file(given, files[i]), options), files[i]);
    answers.push_back({names[i], query, blur_ellipses(query)});
  }
  std::vector<std::string> outputs;
  if (kind == AnswerKind::Json) outputs = outputs_of(files, options.output, ".json", "--output");
  if (kind == AnswerKind::Csv)
    write_text(ellipse_csv(answers), options.output);
  else if (kind == AnswerKind::Table)
    write_text(ellipse_table(answers), options.output);
  else
    for (std::size_t i = 0; i < files.size(); ++i) write_result(answers[i].answer, outputs[i]);
  if (kind != AnswerKind::Json)
    for (const AnsweredQuery& one : answers)
      for (const std::string& note : one.query.notes) std::cerr << "note: " << note << "\n";
  return 0;
}

}  // namespace sturm
