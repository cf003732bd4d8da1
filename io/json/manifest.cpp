#include "io/json/manifest.h"

#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/files/build_info.h"
#include "io/files/machine.h"
#include "io/files/sha256.h"
#include "io/json/json_text.h"

namespace sturm {

std::string cpu_model() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with("model name"))
      if (const auto colon = line.find(": "); colon != std::string::npos) return line.substr(colon + 2);
  return "unknown";
}

std::string instruction_set() {
#if defined(__x86_64__)
  std::string text = "x86-64";
#else
  std::string text = "generic";
#endif
#ifdef __AVX2__
  text += " avx2";
#endif
#ifdef __FMA__
  text += " fma";
#endif
#ifdef __AVX512F__
  text += " avx512f";
#endif
  return text;
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

std::string spec_hash(const Json& resolved_spec) {
  return sha256(json_text(resolved_spec));
}

Json provenance(const RunFacts& run, const Json& resolved_spec) {
  Json inputs = Json::array();
  for (const std::string& file : run.input_files) inputs.push_back({{"file", file}, {"sha256", sha256_of_file(file)}});
  const BuildInfo& build = build_info();
  return {{"version", build.version},
          {"commit", build.commit},
          {"compiler", build.compiler},
          {"build_type", build.build_type},
          {"flags", build.flags},
          {"instruction_set", instruction_set()},
          {"cpu", cpu_model()},
          {"threads", run.threads},
          {"seed", run.seed},
          {"spec_hash", spec_hash(resolved_spec)},
          {"started_utc", run.started_utc},
          {"seconds", run.seconds},
          {"peak_memory_bytes", peak_memory_bytes()},
          {"inputs", std::move(inputs)}};
}

Json manifest(const RunFacts& run, const Json& resolved_spec, const Json& counters,
              const std::vector<std::string>& notes) {
  return {{"format", "sturm.manifest/1"},
          {"provenance", provenance(run, resolved_spec)},
          {"spec", resolved_spec},
          {"counters", counters},
          {"notes", notes}};
}

}  // namespace sturm
