#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "../files/ephemeris_reader.hpp"
#include "../files/message_kinds.hpp"
#include "../files/message_readers.hpp"
#include "../files/text_file.hpp"
#include "mean_motion.hpp"

namespace vectrix {
namespace {

using detail::KvnLine;

constexpr std::string_view version_keyword = "CCSDS_OMM_VERS";
constexpr const detail::MessageKind& omm = detail::orbit_mean_elements;

bool of_the_standard(std::string_view keyword) {
  return std::any_of(omm.keywords.begin(), omm.keywords.end(),
                     [&](const auto& known) { return known.name == keyword; });
}

// Its comments stand together, behind the version.
bool is_of_the_header(std::string_view keyword) {
  return keyword == "CLASSIFICATION" || keyword == "CREATION_DATE" || keyword == "ORIGINATOR" ||
         keyword == "MESSAGE_ID";
}

}  // namespace

namespace detail {

/// The lines of one message. Every error is a BadInput with the place.
class OrbitMeanElementsReader {
 public:
  OrbitMeanElementsReader(const std::string& place, KvnLine version)
      : version_(std::move(version)),
        entries_(place, "the message from line " + detail::text(version_.line) + " on") {
    if (!omm.has(version_.value)) fail(version_, "the versions are " + omm.list());
  }

  void add_comment(std::string comment) { pending_.push_back(std::move(comment)); }

  void add(KvnLine line) {
    if (!of_the_standard(line.keyword)) {
      if (const std::string fault = other_fault(omm, line.keyword); !fault.empty()) fail(line, fault);
    }
    if (!pending_.empty()) {
      auto& comments =
          comments_[is_of_the_header(line.keyword) ? std::string{version_keyword} : line.keyword];
      comments.insert(comments.end(), pending_.begin(), pending_.end());
      pending_.clear();
    }
    entries_.add(std::move(line));
  }

  OrbitMeanElementsMessage message() const {
    require("CENTER_NAME", {"EARTH"});
    require("REF_FRAME", {"TEME"});
    require("TIME_SYSTEM", {"UTC"});
    require("MEAN_ELEMENT_THEORY", {"SGP4", "SGP/SGP4"});
    if (const KvnLine* type = entries_.find("EPHEMERIS_TYPE");
        type && type->value != "0" && type->value != "2" && !(type->value == "3" && version_.value == "2.0"))
      fail(*type, "the elements are of another theory than SGP4");
    if (const KvnLine* axis = entries_.find("SEMI_MAJOR_AXIS"))
      fail(*axis, "the elements of SGP4 have MEAN_MOTION instead");
    constexpr double wgs72 = 398600.8;
    if (const KvnLine* gm = entries_.find("GM"); gm && entries_.number(*gm, "km**3/s**2") != wgs72)
      fail(*gm, "SGP4 has 398600.8 km^3/s^2, of WGS-72");

    const KvnLine& motion = entries_.line("MEAN_MOTION");
    const double revolutions = entries_.number(motion, "rev/day");
    if (!(revolutions > 0.0 && revolutions <= detail::fastest_mean_motion))
      fail(motion, "not in (0, " + detail::text(detail::fastest_mean_motion) + "] rev/day");
    const KvnLine& ellipse = entries_.line("ECCENTRICITY");
    const double e = entries_.number(ellipse, "");
    if (!(e >= 0.0 && e < 1.0)) fail(ellipse, "not in [0, 1)");
    OrbitMeanElementsMessage message(
        {entries_.epoch(entries_.line("EPOCH"), scale::utc), detail::mean_motion(revolutions), e,
         degrees("INCLINATION", 180.0), degrees("RA_OF_ASC_NODE", 360.0), degrees("ARG_OF_PERICENTER", 360.0),
         MeanAnomaly(degrees("MEAN_ANOMALY", 360.0)),
         within(entries_.line("BSTAR"), "1/ER", detail::largest_bstar) * bstar_unit});
    // As published, or the derivatives themselves.
    if (const KvnLine* rate = entries_.find("MEAN_MOTION_DOT"))
      static_cast<void>(within(*rate, "rev/day**2", 2.0 * detail::largest_half_rate));
    if (const KvnLine* rate = entries_.find("MEAN_MOTION_DDOT"))
      static_cast<void>(within(*rate, "rev/day**3", 6.0 * detail::largest_sixth_of_second_rate));
    for (const char* keyword : {"OBJECT_NAME", "OBJECT_ID"}) static_cast<void>(entries_.line(keyword));
    if (const KvnLine* catalogue = entries_.find("NORAD_CAT_ID"))
      message.catalogue_number_ = entries_.whole(*catalogue);
    for (const auto& [keyword, entry] : entries_.all()) message.values_.emplace(keyword, entry.value);
    message.values_.emplace(version_keyword, version_.value);
    message.comments_ = comments_;
    if (!pending_.empty()) message.comments_.emplace("", pending_);
    return message;
  }

 private:
  [[noreturn]] void fail(const KvnLine& line, const std::string& reason) const {
    entries_.fail(line, reason);
  }

  void require(const char* keyword, std::initializer_list<std::string_view> allowed) const {
    const KvnLine& given = entries_.line(keyword);
    if (std::find(allowed.begin(), allowed.end(), detail::upper_case(given.value)) == allowed.end())
      fail(given, "it must be " + std::string{*allowed.begin()} + " for the elements of SGP4");
  }
  [[nodiscard]] double within(const KvnLine& given, const std::string& unit, double most) const {
    const double value = entries_.number(given, unit);
    if (!(std::abs(value) <= most))
      fail(given, "not in [-" + detail::text(most) + ", " + detail::text(most) + "] " + unit);
    return value;
  }
  [[nodiscard]] Quantity<si::angle> degrees(const char* keyword, double most) const {
    const KvnLine& given = entries_.line(keyword);
    const double value = entries_.number(given, "deg");
    if (!(value >= 0.0 && value <= most)) fail(given, "not in [0, " + detail::text(most) + "] deg");
    return convert<si::angle>(value * si::degree);
  }

  KvnLine version_;
  KvnEntries entries_;
  std::vector<std::string> pending_;  // comments before the next keyword
  std::map<std::string, std::vector<std::string>, std::less<>> comments_;
};

}  // namespace detail

namespace {

using detail::OrbitMeanElementsReader;

std::vector<OrbitMeanElementsMessage> joined(std::vector<std::vector<OrbitMeanElementsMessage>> lists) {
  std::vector<OrbitMeanElementsMessage> all;
  for (auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

std::vector<OrbitMeanElementsMessage> detail::read_omm(detail::KvnReader& lines) {
  std::vector<OrbitMeanElementsMessage> all;
  std::optional<OrbitMeanElementsReader> reader;
  std::vector<std::string> before;  // comments before the first message
  while (lines.next()) {
    if (lines.is_comment()) {
      if (reader) {
        reader->add_comment(lines.comment());
      } else {
        before.push_back(lines.comment());
      }
      continue;
    }
    detail::KvnLine line = lines.keyword();
    if (line.keyword == version_keyword) {
      if (reader) all.push_back(reader->message());
      reader.emplace(lines.place(), std::move(line));
      for (std::string& comment : std::exchange(before, {})) reader->add_comment(std::move(comment));
    } else if (reader) {
      reader->add(std::move(line));
    } else {
      detail::refuse(lines.place(), line, "a message begins with " + std::string{version_keyword});
    }
  }
  if (!reader) throw BadInput(lines.place() + ": there is no message");
  all.push_back(reader->message());
  return all;
}

OrbitMeanElementsMessage OrbitMeanElementsMessage::parse(std::string_view text) {
  return detail::single(omm.name, joined(detail::read_messages(omm.name, text, true, omm, detail::read_omm)));
}

std::vector<OrbitMeanElementsMessage> OrbitMeanElementsMessage::read(const std::filesystem::path& file) {
  return joined(detail::read_messages(file, omm, detail::read_omm));
}

}  // namespace vectrix
