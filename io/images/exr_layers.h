#pragma once
// Used by the EXR readers only: it brings OpenEXR's headers with it.
#include <optional>
#include <string>
#include <vector>

#include "io/images/exr_reader.h"

namespace sturm {

/// A layer of an EXR file.
struct ExrLayer {
  enum class Kind { Colours, Luminance, LuminanceAndChroma, Other };

  std::string name;  ///< unique in the file; "" is the main layer
  Kind kind = Kind::Other;
  int part = 0;
  std::vector<std::string> channels;  ///< as the file has them, in order; of luminance and chroma only Y
};

/// All layers. In a file of several parts a layer has its part's name before its own ("diffuse", "diffuse.indirect"),
/// unless it says so itself; R, G and B of a part without a name, or named rgba, are the main layer.
std::vector<ExrLayer> layers_of(const ExrReader& file);

/// The layer that `wanted` means (its name, or the first or last parts of one picture's name: "Combined" for
/// "ViewLayer.Combined"; in whatever case), or without it the one picture that there is. Throws InputError with a list
/// of the layers where there is none or a choice.
const ExrLayer& chosen_layer(const std::vector<ExrLayer>& layers, const std::optional<std::string>& wanted,
                             const std::string& file);

/// The layer of distances: "depth" or "Z", else the first of one channel with one of these words last in its name, in
/// whatever case ("ViewLayer.Depth"); null where there is none.
const ExrLayer* depth_layer_of(const std::vector<ExrLayer>& layers);

}  // namespace sturm
