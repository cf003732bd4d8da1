#include "experiments/run/steps.h"

#include <cstdio>
#include <utility>

#include "experiments/run/progress.h"

namespace sturm {

Json Steps::operator()(const std::string& name, const std::string& label,
                       const std::function<Json(const ProgressFunction&)>& make) {
  const RunFolder::Part part = folder_.part(name, [&] {
    Progress progress(label, 0.0, "", quiet_);
    Json value = make([&](double fraction) { progress.update(fraction); });
    progress.update(1.0);
    return Json{{"value", std::move(value)}, {"seconds", progress.seconds()}};
  });
  if (part.reused && !quiet_) std::fprintf(stderr, "%s: taken from the interrupted run\n", label.c_str());
  seconds_ += part.value.at("seconds").get<double>();
  return part.value.at("value");
}

double Steps::lap() {
  return std::exchange(seconds_, 0.0);
}

}  // namespace sturm
