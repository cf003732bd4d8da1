#include "app/command_examples.h"

#include <map>
#include <vector>

namespace sturm {

namespace {

const std::map<std::string, std::vector<const char*>>& examples() {
  static const std::map<std::string, std::vector<const char*>> all{
      {"run", {"run validation --out report", "run image_agreement --threads 1 --resume"}},
      {"ellipse",
       {"ellipse --rx \"-3.25 -1.75 x 160\" --vertex 12 --pupil 5 --age 52 --distance 0.4,1,6,inf",
        "ellipse --rx \"-3.25 -1.75 x 160\" --lens glasses --gaze 0,0 --gaze 20,-10 --distance 1 --csv",
        "ellipse query.json --pupil 6", "ellipse one.json two.json --csv -o both.csv"}},
      {"lens",
       {"lens --rx \"-3.25 -1.75 x 160\" --index 1.6 --map map.svg",
        "lens progressive_regular --azimuth-deg 0 --elevation-deg -40:40:10 --table",
        "lens progressive_regular progressive_wide_near --map maps.pdf --corridor corridors.svg --range 3"}},
      {"plot",
       {"plot blur --rx \"-2.00 -1.50 x 30\" --pupil 4 --age 58 -o blur.svg", "plot mtf hofer_5 --psf rays -o mtf.png",
        "plot power progressive_regular progressive_wide_far --range 2 -o power.pdf"}},
      {"wearers", {"wearers table.csv progressive_regular glasses --distance inf,0.4 -o seen.csv"}},
      {"validate-camera",
       {"validate-camera check --write --pupil 6 --focus 1", "render check/view.json -o check/picture.exr",
        "validate-camera check --junit check.xml"}},
      {"blurfield",
       {"blurfield --rx \"+1.00 -0.75 x 90\" --lens progressive_regular -o field.exr --layers layers.svg",
        "blurfield kakimoto_fig12 -o field.exr"}},
      {"psf",
       {"psf --rx \"-1.00 -0.50 x 30\" --pupil 3 --distance 1,inf",
        "psf --eye hofer_5 --distance 0.5,inf --images psf.exr -o psf.csv"}},
      {"wavefront",
       {"wavefront spots.csv --pupil-mm 4 --pixel-um 7.4 --lenslet-mm 0.3 -o eye.json --report fit.json",
        "wavefront --random --seed 7 --pupil-mm 6 -o random.json", "wavefront eye.json --pupil-mm 3 -o smaller.json"}},
      {"render",
       {"render cornell --rx \"-3.25 -1.75 x 160\" --pupil 5 -o seen.png",
        "render desk --rx \"-3.25 -1.75 x 160\" --lens glasses --samples 256 -o corrected.exr",
        "render desk street --samples 16 -o seen_{name}.png"}},
      {"serve", {"serve desk", "serve view.json --port 8017"}},
      {"view", {"view desk --rx \"-2.00 -1.50 x 30\" -o desk.html"}},
      {"see",
       {"see photo.png --depth depth.png --rx \"-2.00 -1.50 x 30\" --hfov-deg 60 -o seen.png",
        "see photo.png --distance-m 6 --eye hofer_5 --vfov-deg 2 --print-config > seen.json",
        "see seen.json --pupil 3 -o seen.png"}},
      {"bench", {"bench rendering --out bench", "bench error_vs_time --resume"}},
      {"stress", {"stress --cases 1000 -o stress.json", "stress --case 4695"}},
      {"compare",
       {"compare seen.png photo.png --bound flip=0.4",
        "compare --suite pairs --bound flip=0.1 --junit suite.xml --markdown summary.md"}},
      {"compare-runs", {"compare-runs before after --gate"}},
      {"plan-samples", {"plan-samples --difference 0.001 --sigma 4"}},
      {"gate", {"gate after/report.json --junit junit.xml --markdown summary.md"}},
      {"report", {"report after -o page.html"}},
      {"validate", {"validate query.json seen.json"}},
      {"schema", {"schema", "schema eye > eye.schema.json"}},
      {"init", {"init view", "init experiment my_eyes"}},
      {"doctor", {"doctor"}},
      {"completion", {"completion bash > sturm.bash"}},
      {"man", {"man ellipse | man -l -", "man --folder pages"}},
  };
  return all;
}

}  // namespace

std::string command_examples(const std::string& command) {
  std::string text = "Examples:";
  for (const char* line : examples().at(command)) text += "\n  sturm " + std::string(line);
  return text;
}

}  // namespace sturm
