#pragma once
#include <string>
#include <string_view>

#include "reports/markup/html.h"

namespace sturm {

/// What stands where there is nothing to show: a dash.
Html absent_html();

/// The text, or absent_html() when it is empty.
Html text_or_dash(std::string_view text);

/// A word of the program's own language: the id of a gate, a model, a file. absent_html() within it when it is empty.
Html code_html(std::string_view text);

/// A remark behind or below a value.
Html small_html(const Html& remark);

/// A space and the unit (plain text) of what stands before it; nothing without a unit.
Html unit_html(std::string_view unit);

/// A word that says how something went, marked as good or bad.
Html mark_html(bool good, const Html& word);

/// A term of a list of facts with what is known of it; nothing where that is empty or absent_html(). `name` is plain
/// text.
Html fact(std::string_view name, const Html& known);

/// The list itself.
Html fact_list(const Html& facts);

/// A link to a file of the run folder. Whatever is in the name is part of the path: no other scheme, query or fragment.
Html file_link(std::string_view path);

/// Letters, digits and hyphens made of any text, for an id attribute; different texts may collide.
std::string slug(std::string_view text);

/// A part that starts folded unless `open`.
Html folded(const Html& summary, const Html& inner, bool open = false);

/// What is shown where a picture is missing.
Html missing_html(const Html& why);

}  // namespace sturm
