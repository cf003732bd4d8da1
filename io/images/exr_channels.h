#pragma once
#include <map>
#include <string>
#include <vector>

namespace sturm {

/// The EXR channels of a layer of LayeredImage, in the order of the image's channels: "" with 3 → R G B, "variance"
/// with 3 → variance.R …, "normal" with 3 → normal.X …, "depth" with 1 → depth.Z, any other with 1 → .Y, with 2 → .X
/// .Y, with 4 → .R .G .B .A. Empty where there is no such layer.
std::vector<std::string> exr_channel_names(const std::string& layer, int channels);

/// The layers that a file's channels form, each with its channels in order. What forms no known group becomes a
/// 1-channel layer of its full name.
std::map<std::string, std::vector<std::string>> layers_of_channels(const std::vector<std::string>& channels);

}  // namespace sturm
