#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/orbit/mean_elements.hpp>

namespace vectrix {
namespace detail {

class OrbitMeanElementsReader;

}  // namespace detail

/// One orbit mean-elements message (OMM, CCSDS 502.0-B, versions 2.0 and 3.0), in keyword-value notation or
/// XML: what two-line elements contain, with more digits, and catalogue numbers of any size. Sgp4 takes both,
/// so the message must say that it is for SGP4:
///     CENTER_NAME EARTH, REF_FRAME TEME, TIME_SYSTEM UTC, MEAN_ELEMENT_THEORY SGP4 or SGP/SGP4
///     if there, EPHEMERIS_TYPE 0 or 2, or 3 in version 2.0 (SDP4), and GM 398600.8 km^3/s^2 (WGS-72)
///     MEAN_MOTION in rev/day, angles in deg, BSTAR per Earth radius: units may be written, and are checked
/// text() gives the rest as it is written, also the derivatives of the mean motion, which SGP4 does not use
/// and some providers divide by 2 and by 6, and keywords that are not of the standard. One that is nearly of
/// the standard, so that it may be a slip, and one that is there twice are refused. The order is not checked.
class VECTRIX_EXPORT OrbitMeanElementsMessage {
 public:
  /// Of one message. The end of the text ends its last line. Throws BadInput with line, column, keyword and
  /// what was found there, or the keyword that is missing.
  static OrbitMeanElementsMessage parse(std::string_view text);
  /// All messages of a file, each from its CCSDS_OMM_VERS on, or all of an XML document of such messages.
  /// Throws BadInput with file, line, column and what was found there; also if the file cannot be read or has
  /// no message. A last line without a line end is refused, for it may have been cut within its number.
  static std::vector<OrbitMeanElementsMessage> read(const std::filesystem::path& file);

  /// OBJECT_NAME and OBJECT_ID, as written; may be empty.
  [[nodiscard]] const std::string& object_name() const { return *text("OBJECT_NAME"); }
  [[nodiscard]] const std::string& object_id() const { return *text("OBJECT_ID"); }
  /// NORAD_CAT_ID, if there is one.
  [[nodiscard]] const std::optional<std::int64_t>& catalogue_number() const { return catalogue_number_; }
  [[nodiscard]] const Epoch& epoch() const { return elements_.epoch; }
  [[nodiscard]] const MeanElements& mean_elements() const { return elements_; }
  /// The value of a keyword as it is written, with its unit; null if the message does not have it.
  [[nodiscard]] const std::string* text(std::string_view keyword) const {
    const auto found = values_.find(keyword);
    return found == values_.end() ? nullptr : &found->second;
  }

 private:
  friend class detail::OrbitMeanElementsReader;

  explicit OrbitMeanElementsMessage(const MeanElements& elements) : elements_(elements) {}

  MeanElements elements_;
  std::optional<std::int64_t> catalogue_number_;
  std::map<std::string, std::string, std::less<>> values_;
};

}  // namespace vectrix
