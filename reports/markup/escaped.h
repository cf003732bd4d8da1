#pragma once
#include <string>
#include <string_view>

namespace sturm {

/// Both are XML; they differ in how a line break and an apostrophe are written.
enum class Dialect {
  Html,  ///< line breaks and tabs stay as they are; &#39;, which every version of HTML knows
  Xml    ///< line breaks and tabs are references, as bare ones in an attribute become spaces; &apos;
};

/// Text made safe for element content and quoted attributes; control characters become U+FFFD.
std::string escaped(std::string_view text, Dialect dialect = Dialect::Html);

}  // namespace sturm
