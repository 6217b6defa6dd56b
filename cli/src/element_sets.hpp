#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

namespace vectrix::cli {

/// Mean elements of SGP4, and of which satellite.
struct ElementSet {
  MeanElements elements;
  std::string number;      // of the catalogue: "25544"; empty if the file has none
  std::string designator;  // of the launch, as written: "98067A", "1998-067A"

  [[nodiscard]] const std::string& name() const { return number.empty() ? designator : number; }
};

/// Which satellite of several is meant, by its number or designator, and how to state it.
struct StatedSatellite {
  std::string value{};
  std::string word = "--satellite NUMBER";
};

/// The sets of a file of two-line elements, or of orbit mean-elements messages. Throws BadInput as these do.
std::vector<ElementSet> read_two_lines(const std::filesystem::path& file);
std::vector<ElementSet> read_mean_elements(const std::filesystem::path& file);

/// Those of one satellite. Throws BadInput, with their names, if the file has several and none is stated, and
/// if it does not have the one that is.
std::vector<ElementSet> of_satellite(const std::vector<ElementSet>& sets, const std::filesystem::path& file,
                                     const StatedSatellite& satellite);

}  // namespace vectrix::cli
