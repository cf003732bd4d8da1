#include "app/prescription_option.h"

#include <nlohmann/json.hpp>

#include "io/files/error.h"
#include "io/specs/eye_spec.h"
#include "io/specs/prescription_notation.h"

namespace sturm {

void apply_prescription(Json& document, const std::string& text, const std::string& file) {
  read_notation(text, {"", "--rx"});  // what is wrong with the text is a matter of the option
  if (!document.is_object()) Source{file, ""}.fail(document, "an object");
  for (const char* maker : {"single_vision", "progressive"})
    if (const auto made = document.find(maker); made != document.end() && made->is_object()) {
      (*made)["prescription"] = text;
      return;
    }
  if (document.value("format", Json()) == "sturm.eye/1") {
    document["prescription"] = text;
    return;
  }
  const auto eye = document.find("eye");
  if (eye == document.end())
    throw InputError("", "--rx", "\"" + text + "\"",
                     "a document with an \"eye\", or a single-vision or progressive lens: " + file + " has none");
  *eye = eye_object(*eye, {file, "/eye"});
  if (!eye->is_object()) Source{file, "/eye"}.fail(*eye, "an eye");
  (*eye)["prescription"] = text;
}

}  // namespace sturm
