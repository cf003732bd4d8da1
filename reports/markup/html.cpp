#include "reports/markup/html.h"

#include "reports/markup/escaped.h"

namespace sturm {

namespace {

/// "<tag attributes", still open.
std::string start_of(std::string_view tag, const Attributes& attributes) {
  std::string markup = "<";
  markup.append(tag);
  for (const Attribute& attribute : attributes)
    markup.append(" ").append(attribute.name).append("=\"").append(escaped(attribute.value)).append("\"");
  return markup;
}

std::string whole(std::string_view tag, const Attributes& attributes, const Html& inner) {
  return start_of(tag, attributes).append(">").append(inner.markup()).append("</").append(tag).append(">");
}

}  // namespace

Html text(std::string_view text) {
  return Html::trusted(escaped(text));
}

Html element(std::string_view tag, const Attributes& attributes, const Html& inner) {
  return Html::trusted(whole(tag, attributes, inner) + "\n");
}

Html element(std::string_view tag, const Html& inner) {
  return element(tag, {}, inner);
}

Html inline_element(std::string_view tag, const Attributes& attributes, const Html& inner) {
  return Html::trusted(whole(tag, attributes, inner));
}

Html inline_element(std::string_view tag, const Html& inner) {
  return inline_element(tag, {}, inner);
}

Html empty_element(std::string_view tag, const Attributes& attributes) {
  return Html::trusted(start_of(tag, attributes) + "/>");
}

void add_item(Html& list, const Html& item, const Html& separator) {
  if (!list.empty()) list += separator;
  list += item;
}

}  // namespace sturm
