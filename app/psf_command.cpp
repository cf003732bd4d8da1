#include <algorithm>
#include <filesystem>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands.h"
#include "app/configuration.h"
#include "app/option_values.h"
#include "app/psf_table.h"
#include "app/several_documents.h"
#include "io/files/error.h"
#include "io/files/plain_file.h"
#include "io/json/values.h"
#include "stages/image_files.h"
#include "stages/psf_pictures.h"

namespace sturm {

namespace {

/// The document that the options stand for.
Json asked_for(const CommonOptions& options, const PsfOptions& asked) {
  Json document = load_configuration(
      options,
      {{"format", "sturm.psf/1"}, {"eye", {{"pupil_diameter_mm", 4}}}, {"lights", {{{"wavelength_nm", 555}}}}});
  if (!asked.distances_m.empty() && document.is_object()) {
    document.erase("defocus_D");
    document["distances_m"] = Json::array();
    for (const std::string& text : asked.distances_m)
      document["distances_m"].push_back(distance_json(distance_option(text, "--distance")));
  }
  return document;
}

/// The sturm.psf_result/1 of one document; its pictures are written.
Json answer_point_spreads(const PsfSpec& spec, const std::string& file, const std::string& images) {
  const PointSpreads spreads = point_spreads(spec, file);
  if (!images.empty()) {
    const std::filesystem::path exr(images);
    write_exr_parts(exr, psf_parts(spec, spreads));
    write_png(std::filesystem::path(exr).replace_extension(".png"), psf_sheet(spec, spreads), 1.0);
  }
  return psf_result(spec, spreads);
}

/// The pictures' files of all documents, "" where there are none.
std::vector<std::string> images_of(const CommonOptions& given, const std::string& images) {
  if (!images.empty() && !has_suffix(images, ".exr"))
    throw InputError("", "--images", "\"" + images + "\"", "a name that ends in .exr");
  if (!images.empty() && !given.files.empty()) return outputs_of(given.files, images, ".exr", "--images");
  return std::vector<std::string>(std::max<std::size_t>(1, given.files.size()), images);
}

}  // namespace

int psf_command(const CommonOptions& given, const PsfOptions& asked) {
  const std::vector<std::string> images = images_of(given, asked.images);
  if (given.print_config) {
    const CommonOptions one = with_source(with_one_document(given, "--print-config"));
    return print_configuration(asked_for(one, asked), one.file, asked.output);
  }
  const AnswerKind kind = answer_kind(asked.answer, asked.output, given.files.size());
  const std::vector<std::string> files = files_of(given);
  std::vector<PsfSpec> specs;
  for (const std::string& file : files) specs.push_back(read_psf_spec(asked_for(with_file(given, file), asked), file));
  const std::vector<std::string> outputs =
      kind == AnswerKind::Json ? outputs_of(files, asked.output, ".json", "--output") : std::vector{asked.output};
  for (const auto* written : {&outputs, &images})
    for (const std::string& file : *written)
      if (!file.empty()) require_writable(file);
  const std::vector<std::string> names = document_names(files);
  std::vector<NamedSpreads> answers;
  for (std::size_t i = 0; i < files.size(); ++i) {
    answers.push_back({names[i], answer_point_spreads(specs[i], files[i], images[i])});
    if (kind == AnswerKind::Json) write_result(answers.back().result, outputs[i]);
  }
  if (kind == AnswerKind::Json) return 0;
  write_text(kind == AnswerKind::Csv ? psf_csv(answers) : psf_table(answers), asked.output);
  for (const NamedSpreads& one : answers)
    for (const Json& note : one.result["notes"]) std::cerr << "note: " << note.get<std::string>() << "\n";
  return 0;
}

}  // namespace sturm
