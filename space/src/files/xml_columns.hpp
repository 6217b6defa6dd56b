#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace vectrix::detail {

/// A number of a line of data as an element in XML: its keyword, its unit, and the element around it and its
/// neighbours; empty for the one of the line.
struct XmlColumn {
  std::string name, unit{}, group{};
};

/// A line of data: the element in attitudeState, and the columns, the epoch first.
struct XmlLine {
  std::string element;
  std::vector<XmlColumn> columns;
};

/// The line of an AEM whose metadata have these words, in capitals; empty if they do not have a keyword.
/// Nothing for types that are not read.
std::optional<XmlLine> attitude_line(const std::function<std::string(const char*)>& word,
                                     const std::string& version);
/// That of an OEM.
XmlLine orbit_line(bool has_acceleration);
/// The units of a covariance.
const char* covariance_unit(std::size_t row, std::size_t column);

}  // namespace vectrix::detail
