#pragma once
#include <map>
#include <string>
#include <vector>

namespace sturm {

/// The EXR channels of a layer of LayeredImage, in the order of the image's channels: "" with 3 → R G B, "variance"
/// with 3 → variance.R …, "normal" with 3 → normal.X …, "depth" with 1 → depth.Z, any other with 1 → .Y, with 2 → .X
/// .Y, with 4 → .R .G .B .A. Empty where there is no such layer.
std::vector<std::string> exr_channel_names(const std::string& layer, int channels);

/// The layers that a file's channels form, each with its channels (as the file has them) in order. A layer is what
/// stands before the last dot of its channels; dots at the beginning count for nothing. R, G, B, A, X, Y and Z may also
/// be lower-case letters, and the colours words ("red"); where a file has several spellings of one channel, the capital
/// letter counts. What forms no known group becomes a 1-channel layer of its full name.
std::map<std::string, std::vector<std::string>> layers_of_channels(const std::vector<std::string>& channels);

/// What a channel is within its layer: "R" of ".R", "rgb.r" and "Combined.Red"; other names without their layer.
std::string channel_role(const std::string& channel);

/// The layer that a channel stands in: "" of "R" and ".R", "ViewLayer.Combined" of "ViewLayer.Combined.R".
std::string channel_layer(const std::string& channel);

}  // namespace sturm
