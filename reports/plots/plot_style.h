#pragma once
#include <array>
#include <string>

namespace sturm {

/// Colours that people with any kind of colour vision can tell apart, and that differ in lightness: Okabe and Ito,
/// Color Universal Design (2008). The first is for what matters most.
inline constexpr std::array<const char*, 7> plot_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                         "#e69f00", "#56b4e9", "#000000"};

inline const char* plot_colour(std::size_t number) {
  return plot_colours[number % plot_colours.size()];
}

/// Axes on the left and below, thin grid lines, numbers outside.
inline constexpr const char* plot_axes = R"(
set border 3 lc rgb '#444444' lw 1
set tics nomirror out
set grid ytics lc rgb '#e4e4e4' lw 1 lt 1
)";

/// `text` as a string of gnuplot's: quoted, and nothing in it means anything.
std::string plot_string(const std::string& text);

/// A named block of data.
std::string data_block(const std::string& name, const std::string& rows);

/// A distance as people say it: "40 cm", "2.5 m", "far away".
std::string distance_words(double distance_m);

}  // namespace sturm
