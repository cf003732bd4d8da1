// The figures of scripts/bench --peer that need the pictures: error of each against a reference, and how the two
// renderers agree.
//   peer_pictures REFERENCE.exr --ours A.exr B.exr ... --theirs C.exr D.exr ...
// JSON on stdout.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/picture_error.h"
#include "io/images/exr.h"

namespace sturm::bench {
namespace {

Image main_layer(const std::string& path) {
  return read_exr(path).layers.at("");
}

std::vector<Image> main_layers(const std::vector<std::string>& paths) {
  std::vector<Image> pictures;
  for (const std::string& path : paths) pictures.push_back(main_layer(path));
  return pictures;
}

nlohmann::ordered_json errors(const std::vector<Image>& pictures, const Image& reference) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Image& picture : pictures) list.push_back(trimmed_relative_error(picture, reference));
  return list;
}

int run(const std::string& reference_path, const std::vector<std::string>& our_paths,
        const std::vector<std::string>& their_paths) {
  const Image reference = main_layer(reference_path);
  const std::vector<Image> ours = main_layers(our_paths), theirs = main_layers(their_paths);
  nlohmann::ordered_json report = {
      {"trimmed_relative_mse", {{"ours", errors(ours, reference)}, {"theirs", errors(theirs, reference)}}}};
  if (ours.size() > 1 && theirs.size() > 1) {
    const Agreement a = agreement(ours, theirs);
    report["agreement"] = {{"mean_ratio", a.mean_ratio}, {"mean_ratio_standard_error", a.standard_error},
                           {"blocks", a.blocks},         {"rms_z", a.rms_z},
                           {"largest_z", a.largest_z},   {"largest_z_expected_0_01", a.largest_z_expected_0_01}};
  }
  std::printf("%s\n", report.dump(2).c_str());
  return 0;
}

}  // namespace
}  // namespace sturm::bench

int main(int argc, char** argv) {
  std::string reference;
  std::vector<std::string> ours, theirs;
  CLI::App app("Errors and agreement of two renderers' pictures of one view");
  app.add_option("reference", reference, "converged picture")->required();
  app.add_option("--ours", ours, "our pictures, independent seeds")->required();
  app.add_option("--theirs", theirs, "the other renderer's pictures");
  CLI11_PARSE(app, argc, argv);
  try {
    return sturm::bench::run(reference, ours, theirs);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "peer_pictures: %s\n", error.what());
    return 3;
  }
}
