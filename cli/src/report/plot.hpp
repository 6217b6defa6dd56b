#pragma once

#include <string>

#include "report/data.hpp"

namespace vectrix::cli {

/// "off-Sun, deg"
std::string heading_of(const Report::Plot& plot);

/// The plot over its whole time as an SVG, for paper and for a browser without scripts. Of each curve two
/// samples of each pixel are drawn, the smallest and the largest. Colours are those of the style of the page.
std::string plot_svg(const Report::Plot& plot, const TimeAxis& time, const std::string& start);

/// The colour of a curve, limit or axis: the names of the style, which has eight.
std::string curve_class(std::size_t place);

}  // namespace vectrix::cli
