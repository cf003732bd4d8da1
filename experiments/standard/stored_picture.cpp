#include "experiments/standard/stored_picture.h"

#include "stages/image_files.h"

namespace sturm {

PictureFiles stored_picture(const std::filesystem::path& run_folder, const std::string& name, const Image& linear) {
  const std::string stem = "images/" + name;
  write_picture(run_folder / stem, linear, metrics_exposure);
  return {stem + ".exr", stem + ".png"};
}

}  // namespace sturm
