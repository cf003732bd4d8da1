#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/named_documents.h"
#include "app/option_values.h"
#include "app/several_documents.h"
#include "app/text_answers.h"
#include "experiments/figures/wearer_table.h"
#include "io/files/atomic_file.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/json/schema.h"
#include "lensmodel/units.h"

namespace sturm {

int wearers_command(const WearersOptions& options) {
  require_answer_name(options.output, AnswerKind::Csv);
  WearerQuestion question;
  for (const std::string& text : options.distances_m)
    question.distances_m.push_back(distance_option(text, "--distance"));
  if (options.age || options.amplitude_D) question.amplitude_D = amplitude_option(options.age, options.amplitude_D);
  question.clear_D = options.clear_D;
  question.reach_deg = options.reach_deg;
  question.step_deg = options.step_deg;
  const std::vector<std::string> names = document_names(options.lenses);
  if (has_suffix(options.table, ".json"))
    throw InputError(options.table, "", "a JSON document", "a table of prescriptions (CSV)");
  std::vector<TriedDesign> designs;
  for (const std::string& file : options.lenses) {
    require_document(file, {"lenses"}, "a file");
    const Json document = load_json(file);
    if (format_of(document, file) != "spectacles")
      Source{file, "/format"}.fail(document.at("format"), "\"sturm.spectacles/1\"");
    validate(document, "spectacles", file);
    designs.push_back({names[designs.size()], file, document});
  }
  const auto wearers = read_prescription_table(options.table, metres_per_millimetre * options.vertex_mm);
  if (!options.output.empty()) require_writable(options.output);
  const std::string csv = wearer_csv(wearer_table(wearers, designs, question), options.clear_D);
  if (options.output.empty())
    std::cout << csv;
  else
    write_file_atomically(options.output, csv);
  return 0;
}

}  // namespace sturm
