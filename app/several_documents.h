#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/commands.h"

namespace sturm {

/// What people call a document: its file's name without folders and ending.
std::string document_name(const std::string& file);

/// The same for documents that stand side by side: those of one name get as many of their folders as tell them apart.
std::vector<std::string> document_names(const std::vector<std::string>& files);

/// The options with the one document that was given, or with none. Throws InputError, which says that `what` is for one
/// document, where there are several.
CommonOptions with_one_document(const CommonOptions& options, const std::string& what);

/// The files that were given, or `command_line_source` alone. Throws InputError where there is nothing to answer.
std::vector<std::string> files_of(const CommonOptions& given);

/// The options with one of their files.
CommonOptions with_file(const CommonOptions& given, const std::string& file);

/// The file of each document's output: NAME`ending` in `output`, the value of `option`, where that is a folder, which
/// is made if it is not there; or `output` with the document's name in place of {name}. One document may have an output
/// of any name; "" stays "". Throws InputError where several would have one file.
std::vector<std::string> outputs_of(const std::vector<std::string>& documents, const std::string& output,
                                    const std::string& ending, const std::string& option);

/// Calls `answer` with the options and the output of each document. With several, all of them are read first. Throws
/// InputError. Returns the exit status.
int for_each_document(const CommonOptions& options, const std::string& output, const std::string& ending,
                      const std::function<int(const CommonOptions&, const std::string&)>& answer);

}  // namespace sturm
