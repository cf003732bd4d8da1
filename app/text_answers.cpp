#include "app/text_answers.h"

#include <algorithm>
#include <optional>

#include "io/files/error.h"
#include "io/files/plain_file.h"

namespace sturm {

namespace {

std::optional<AnswerKind> kind_by_ending(const std::string& output) {
  if (has_suffix(output, ".csv")) return AnswerKind::Csv;
  if (has_suffix(output, ".json")) return AnswerKind::Json;
  return std::nullopt;
}

/// Files that no answer in text is.
bool is_other_file(const std::string& output) {
  constexpr const char* endings[] = {".png", ".jpg", ".jpeg", ".svg",  ".pdf",  ".exr", ".hdr", ".pfm",
                                     ".mp4", ".tif", ".tiff", ".html", ".xlsx", ".xls", ".ods", ".docx"};
  return std::ranges::any_of(endings, [&](const char* ending) { return has_suffix(output, ending); });
}

const char* name_for(AnswerKind kind) {
  switch (kind) {
    case AnswerKind::Table:
      return "a name that ends in .txt for a table";
    case AnswerKind::Csv:
      return "a name that ends in .csv, which spreadsheets read";
    case AnswerKind::Json:
      break;
  }
  return "a name that ends in .json";
}

[[noreturn]] void refuse(const std::string& output, const char* option, const std::string& expected) {
  throw InputError("", option, "\"" + output + "\"", expected);
}

}  // namespace

AnswerKind answer_kind(const AnswerOptions& options, const std::string& output, std::size_t documents) {
  const bool asked = options.table || options.csv || options.json;
  if (!asked && is_other_file(output))
    refuse(output, "--output", "a name that ends in .csv, .json or .txt; sturm plot draws pictures");
  const bool usually_table = documents == 0 || (documents > 1 && output.empty()) || has_suffix(output, ".txt");
  const AnswerKind usual = usually_table ? AnswerKind::Table : AnswerKind::Json;
  const AnswerKind kind = options.table  ? AnswerKind::Table
                          : options.csv  ? AnswerKind::Csv
                          : options.json ? AnswerKind::Json
                                         : kind_by_ending(output).value_or(usual);
  require_answer_name(output, kind);
  return kind;
}

void require_answer_name(const std::string& output, AnswerKind kind, const char* option) {
  if (is_other_file(output) || kind_by_ending(output).value_or(kind) != kind) refuse(output, option, name_for(kind));
}

}  // namespace sturm
