#include "io/json/schema_violation.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace sturm {

std::optional<Violation> first_violation(const Json& document, const Json& schema) {
  using Adapter = valijson::adapters::NlohmannJsonAdapter;
  valijson::Schema parsed;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(schema), parsed);
  valijson::Validator validator(valijson::Validator::kStrongTypes);
  // Almost every document is valid, and without a place for errors valijson stops at the first one.
  if (validator.validate(parsed, Adapter(document), nullptr)) return std::nullopt;
  valijson::ValidationResults results;
  validator.validate(parsed, Adapter(document), &results);
  valijson::ValidationResults::Error error;
  results.popError(error);  // the innermost violation comes before the objects that it invalidates

  Violation violation;
  for (std::size_t i = 1; i < error.context.size(); ++i)  // "<root>", "[key]", "[0]", …
    violation.path.push_back(error.context[i].substr(1, error.context[i].size() - 2));
  constexpr std::string_view missing = "Missing required property '";
  if (error.description.starts_with(missing))
    violation.missing = error.description.substr(missing.size(), error.description.rfind('\'') - missing.size());
  return violation;
}

}  // namespace sturm
