#pragma once
#include <cstddef>
#include <string>

namespace sturm {

/// What an answer is written as.
enum class AnswerKind {
  Table,  ///< for people
  Csv,
  Json
};

/// --table, --csv and --json of a command; at most one of them.
struct AnswerOptions {
  bool table = false, csv = false, json = false;
};

/// What the options ask for, else what the ending of the output's name says (.txt is a table), else JSON; but a table
/// for a line without documents, and for several of them on standard output. Throws InputError where the ending is that
/// of another kind.
AnswerKind answer_kind(const AnswerOptions& options, const std::string& output, std::size_t documents);

/// Throws InputError where the name of --output (or of `option`) has the ending of anything but this kind of answer.
/// Names with an ending that means nothing, or with none, suit every kind.
void require_answer_name(const std::string& output, AnswerKind kind, const char* option = "--output");

}  // namespace sturm
