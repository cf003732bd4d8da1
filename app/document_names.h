#pragma once
#include <string>
#include <vector>

namespace sturm {

/// What people call a document: its file's name without folders and ending.
std::string document_name(const std::string& file);

/// The same for documents that stand side by side: those of one name get as many of their folders as tell them apart.
std::vector<std::string> document_names(const std::vector<std::string>& files);

}  // namespace sturm
