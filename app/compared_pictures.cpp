#include "app/compared_pictures.h"

#include <algorithm>

#include "io/files/error.h"
#include "io/files/readable_text.h"

namespace sturm {

namespace {

constexpr int smallest_side = 11;  // the window of SSIM

std::string size_text(const Image& image) {
  return std::to_string(image.width) + " × " + std::to_string(image.height) + " pixels";
}

/// Which layer is asked for of each file; none where a file has no layers and one name is given for all.
class Layers {
 public:
  explicit Layers(const CompareOptions& options) : names_(options.layers) {
    if (names_.size() > 2) throw InputError("", "--layer", "\"" + names_[2] + "\"", "at most two layers");
    if (names_.size() == 1 && !has_layers(options.test) && !has_layers(options.reference))
      throw InputError(options.test, "--layer", "\"" + names_[0] + "\"", "an EXR file; no other has layers");
  }

  std::optional<std::string> of(const std::string& path, bool is_test) const {
    if (names_.empty() || (names_.size() == 1 && !has_layers(path))) return std::nullopt;
    return names_[names_.size() == 1 || is_test ? 0 : 1];
  }

 private:
  std::vector<std::string> names_;
};

class Reading {
 public:
  explicit Reading(const CompareOptions& options) : options_(options), layers_(options) {}

  ComparedPictures run() {
    result_.test = read(options_.test, true);
    result_.reference = read(options_.reference, false);
    for (std::size_t i = 0; i < options_.noise.size(); ++i)
      result_.seeds.push_back(std::move(read(options_.noise[i], i == 0).picture.layers.at("")));
    require_one_size();
    note_two_kinds();
    return std::move(result_);
  }

 private:
  PictureFile read(const std::string& path, bool is_test) {
    PictureFile file = read_picture_file(path, layers_.of(path, is_test));
    Image& image = file.picture.layers.at("");
    require_finite_pixels(image, path);
    if (image.channels > 3) {
      image = without_alpha(image);
      file.notes.emplace_back("alpha is left out");
    }
    decode(image, file);
    for (const std::string& note : file.notes) add_note(path, note);
    return file;
  }

  void decode(Image& image, PictureFile& file) const {
    make_linear(file);
    if (file.values == PixelValues::Linear) return;
    const auto exposure = static_cast<float>(options_.exposure);
    for (float& value : image.pixels) value /= exposure;
    file.notes.push_back("display-referred (" + std::to_string(file.bits) + " bits, " +
                         (file.colours.gamma ? "a power): linear light has its values decoded"
                                             : "sRGB): display space has its values, linear light has them decoded") +
                         (options_.exposure == 1.0 ? "" : " and divided by the exposure"));
  }

  void add_note(const std::string& path, const std::string& note) {
    const std::string text = readable(path) + ": " + note;
    if (std::find(result_.notes.begin(), result_.notes.end(), text) == result_.notes.end())
      result_.notes.push_back(text);
  }

  void require_one_size() const {
    const Image &test = result_.test.image(), &reference = result_.reference.image();
    if (std::min(test.width, test.height) < smallest_side)
      throw InputError(options_.test, "", size_text(test), "at least 11 × 11 pixels for SSIM");
    const auto require_same = [&](const Image& image, const std::string& path) {
      if (image.width != reference.width || image.height != reference.height)
        throw InputError(path, "", size_text(image), "the size of " + options_.reference + ", " + size_text(reference));
    };
    require_same(test, options_.test);
    for (std::size_t i = 0; i < result_.seeds.size(); ++i) require_same(result_.seeds[i], options_.noise[i]);
  }

  /// One picture in linear light and one for a display can be compared, but not beyond what a display shows.
  void note_two_kinds() {
    const PixelValues test = result_.test.values, reference = result_.reference.values;
    if (test == PixelValues::Display && reference == PixelValues::Display && options_.exposure != 1.0)
      throw InputError(options_.test, "--exposure", "two display-referred pictures, which have been exposed",
                       "a picture in linear light");
    if (test == reference) return;
    add_note(test == PixelValues::Display ? options_.test : options_.reference,
             "the other picture is linear; this one ends at white, so differences above it count in linear light");
  }

  const CompareOptions& options_;
  Layers layers_;
  ComparedPictures result_;
};

}  // namespace

ComparedPictures read_compared_pictures(const CompareOptions& options) {
  return Reading(options).run();
}

}  // namespace sturm
