#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "io/images/image.h"
#include "lensmodel/ellipse.h"
#include "reports/markup/html.h"

namespace sturm {

/// A display-referred picture (1 or 3 channels, 0…1) as a "data:image/png;base64,…" address.
std::string data_uri(const Image& display);

/// A display-referred picture under its title.
Html picture_html(const Image& display, const std::string& title);

/// RFC 4648 base64 with padding.
std::string base64(const std::vector<unsigned char>& bytes);

/// The main layer of an EXR file; throws InputError where it has none.
Image main_layer(const std::filesystem::path& file);

/// luma() as an image of one channel.
Image luma_image(const Image& image);

/// Means over `factor`×`factor` blocks (the last ones may be smaller).
Image shrunk(const Image& image, int factor);

/// An <ellipse> for a picture with y down of an ellipse whose orientation has y up (wearer frame): it is turned by
/// −orientation. `pixels_per_unit` converts the ellipse's unit; (centre_x, centre_y) in pixels.
Html svg_ellipse(const Ellipse& ellipse, double pixels_per_unit, double centre_x, double centre_y,
                 const std::string& css_class);

/// The longest of 1, 2, 5 × 10ⁿ that is not above `longest` > 0.
double round_length_below(double longest);

/// The smallest of 1, 2, 5 × 10ⁿ that is not below `shortest` > 0.
double round_length_above(double shortest);

enum class ColourMap { Sequential, Diverging };

struct ColourTick {
  double position;  ///< 0 (left end) … 1 (right end)
  std::string label;
};

/// A horizontal colour bar as an <svg> with labels below it; `title` says what the colours mean.
/// Its gradient has an id, so a page can hold one bar of each map.
Html colour_bar_svg(ColourMap map, const std::vector<ColourTick>& ticks, const std::string& title);

}  // namespace sturm
