#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace sturm {

/// Text of unknown origin (names in files, names of files) as a terminal, JSON and XML can show it: valid UTF-8 on one
/// line. Bytes that belong to no character become U+FFFD, one for each run that Unicode calls an ill-formed
/// subsequence; control characters become \n, \t, \r or \u001b and the like.
std::string readable(std::string_view text);

/// The same cut to at most `characters`, "…" included; never within a character or an escape.
std::string readable(std::string_view text, std::size_t characters);

/// Valid UTF-8 as `readable` makes it, but line ends stay: a message of several lines.
std::string readable_lines(std::string_view text);

/// The same with all control characters as they are.
std::string valid_utf8(std::string_view text);

}  // namespace sturm
