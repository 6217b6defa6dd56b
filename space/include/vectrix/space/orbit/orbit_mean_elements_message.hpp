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
#include <vectrix/space/files/ephemeris_metadata.hpp>
#include <vectrix/space/orbit/mean_elements.hpp>
#include <vectrix/space/orbit/two_line_elements.hpp>

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
///     MEAN_MOTION in (0, 17], BSTAR within 100, MEAN_MOTION_DOT within 2, MEAN_MOTION_DDOT within 6
/// text() gives the rest as it is written, also the derivatives of the mean motion, which SGP4 does not use
/// and some providers divide by 2 and by 6, and keywords that are not of the standard. One that is nearly of
/// the standard, so that it may be a slip, and one that is there twice are refused. The order is not checked.
class VECTRIX_EXPORT OrbitMeanElementsMessage {
 public:
  /// A message of elements, for SGP4. `more` are other keywords and their values: NORAD_CAT_ID,
  /// USER_DEFINED_X. Throws BadInput for what parse() would refuse.
  OrbitMeanElementsMessage(const MessageHeader& header, const std::string& object_name,
                           const std::string& object_id, const MeanElements& elements,
                           const std::vector<OtherKeyword>& more = {});
  /// The message of two-line elements, with the same digits: the title is the name of the object, 98067A its
  /// id 1998-067A. MEAN_MOTION_DOT and MEAN_MOTION_DDOT are, as in the messages of CelesTrak and Space-Track,
  /// the numbers of the lines: half of the derivative, and a sixth of the second one.
  OrbitMeanElementsMessage(const MessageHeader& header, const TwoLineElements& set);

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
  /// All keywords and values, also of what is not of the standard.
  [[nodiscard]] const std::map<std::string, std::string, std::less<>>& values() const { return values_; }
  /// The comments before a keyword, with CCSDS_OMM_VERS those of the header, with "" those behind the last
  /// one; null if there are none.
  [[nodiscard]] const std::vector<std::string>* comments(std::string_view keyword) const {
    const auto found = comments_.find(keyword);
    return found == comments_.end() ? nullptr : &found->second;
  }

  /// The message with another value of a keyword. Throws BadInput for one that parse() would refuse.
  [[nodiscard]] OrbitMeanElementsMessage with(std::string_view keyword, const std::string& value) const;

  /// The message in keyword-value notation, and in XML: each value as it was written, in the order of the
  /// standard, what is not of it at the end.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] std::string xml() const;
  /// In XML if the name ends in .xml. Throws BadInput if the file cannot be written.
  void write(const std::filesystem::path& file) const;
  /// Several in one file; in XML they are a combined message, NDM.
  static void write(const std::filesystem::path& file, const std::vector<OrbitMeanElementsMessage>& messages);
  static std::string text_of(const std::vector<OrbitMeanElementsMessage>& messages, bool is_xml);

 private:
  friend class detail::OrbitMeanElementsReader;

  explicit OrbitMeanElementsMessage(const MeanElements& elements) : elements_(elements) {}

  [[nodiscard]] std::string xml_element() const;

  MeanElements elements_;
  std::optional<std::int64_t> catalogue_number_;
  std::map<std::string, std::string, std::less<>> values_;
  std::map<std::string, std::vector<std::string>, std::less<>> comments_;
};

}  // namespace vectrix
