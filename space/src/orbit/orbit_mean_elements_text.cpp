#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/exact_text.hpp>

#include "../files/ephemeris_writer.hpp"
#include "../files/kvn.hpp"
#include "../files/message_kinds.hpp"
#include "../files/text_file.hpp"
#include "../files/xml_writer.hpp"
#include "mean_motion.hpp"

namespace vectrix {
namespace {

constexpr const detail::MessageKind& omm_kind = detail::orbit_mean_elements;

/// The parts of the message in the order of the standard, each with its last keyword.
struct MessagePlace {
  std::string_view element, last;
};
constexpr MessagePlace places[] = {{"header", "MESSAGE_ID"},  {"metadata", "MEAN_ELEMENT_THEORY"},
                                   {"meanElements", "GM"},    {"spacecraftParameters", "DRAG_COEFF"},
                                   {"tleParameters", "AGOM"}, {"covarianceMatrix", "CZ_DOT_Z_DOT"}};

/// The shortest number of which `quantity_of` makes the same as `wanted`; `near` is this number, rounded. If
/// there is none, the nearest.
template <class QuantityOf> std::string shortest(double near, double wanted, const QuantityOf& quantity_of) {
  constexpr int most_digits = 17;
  char buffer[40];
  std::string text;
  for (int digits = 1; digits <= most_digits; ++digits) {
    text.assign(buffer,
                std::to_chars(buffer, std::end(buffer), near, std::chars_format::general, digits).ptr);
    if (quantity_of(*detail::parse_number(text)) == wanted) return text;
  }
  for (const double other : {std::nextafter(near, -HUGE_VAL), std::nextafter(near, HUGE_VAL)}) {
    if (quantity_of(other) == wanted) return {buffer, std::to_chars(buffer, std::end(buffer), other).ptr};
  }
  return text;
}

std::string in_degrees(const Quantity<si::angle>& angle) {
  return shortest(angle.in(si::degree), angle.value(),
                  [](double degrees) { return convert<si::angle>(degrees * si::degree).value(); });
}

/// The date of two lines has 8 decimals of a day, 6 of a second: what is nearer to a text than a day's
/// fraction is rounded has that text.
std::string date_of(const Epoch& epoch) {
  constexpr double of_rounding = 2e-11;  // s
  const std::string text{epoch.utc(6)};
  if (std::abs((Epoch::from_utc(text) - epoch).value()) <= of_rounding) return text;
  return exact_text(epoch, static_cast<const TimeScale&>(scale::utc));
}

/// The designator of a launch as a message has it: 98067A is 1998-067A.
std::string international(const std::string& designator) {
  constexpr std::size_t year = 2, number = 3;
  const bool has_digits =
      designator.size() > year + number && std::all_of(designator.begin(), designator.begin() + year + number,
                                                       [](char c) { return c >= '0' && c <= '9'; });
  if (!has_digits) return designator;
  return (designator.substr(0, year) < "57" ? "20" : "19") + designator.substr(0, year) + "-" +
         designator.substr(year);
}

std::string keywords_of(const MessageHeader& header, const std::string& object_name,
                        const std::string& object_id, const MeanElements& elements,
                        const std::vector<OtherKeyword>& more) {
  const std::string place = omm_kind.name;
  detail::require_header(header, omm_kind);
  detail::require_text(place, "OBJECT_NAME", object_name);
  detail::require_text(place, "OBJECT_ID", object_id);
  std::string out;
  detail::write_header(out, header, omm_kind);
  const double revolutions = elements.mean_motion.value() / detail::mean_motion(1.0).value();
  const auto motion = [](double number) { return detail::mean_motion(number).value(); };
  const auto drag = [](double number) { return (number * bstar_unit).value(); };
  const std::pair<const char*, std::string> entries[] = {
      {"OBJECT_NAME", object_name},
      {"OBJECT_ID", object_id},
      {"CENTER_NAME", "EARTH"},
      {"REF_FRAME", "TEME"},
      {"TIME_SYSTEM", "UTC"},
      {"MEAN_ELEMENT_THEORY", "SGP4"},
      {"EPOCH", date_of(elements.epoch)},
      {"MEAN_MOTION", shortest(revolutions, elements.mean_motion.value(), motion)},
      {"ECCENTRICITY",
       shortest(elements.eccentricity, elements.eccentricity, [](double number) { return number; })},
      {"INCLINATION", in_degrees(elements.inclination)},
      {"RA_OF_ASC_NODE", in_degrees(elements.ascending_node)},
      {"ARG_OF_PERICENTER", in_degrees(elements.argument_of_perigee)},
      {"MEAN_ANOMALY", in_degrees(elements.mean_anomaly.angle)},
      {"BSTAR", shortest(elements.bstar.value() / bstar_unit.value(), elements.bstar.value(), drag)}};
  for (const auto& [keyword, value] : entries) detail::write_line(out, keyword, value);
  for (const auto& [keyword, value] : more) {
    if (!detail::is_keyword(keyword))
      throw BadInput(place + ": '" + detail::excerpt(keyword) + "': a keyword is of A-Z, 0-9 and _");
    detail::require_text(place, keyword.c_str(), value);
    detail::write_line(out, keyword, value);
  }
  return out;
}

/// What two lines have besides the elements.
std::vector<OtherKeyword> more_of(const TwoLineElements& set) {
  const auto rate = detail::mean_motion(1.0) / (1.0 * si::day);
  const auto second_rate = rate / (1.0 * si::day);
  const auto rounded = [](double number) {  // to the digits that two lines have
    constexpr int digits = 8;
    char buffer[40];
    return std::string{
        buffer, std::to_chars(buffer, std::end(buffer), number, std::chars_format::general, digits).ptr};
  };
  std::vector<OtherKeyword> more{{"EPHEMERIS_TYPE", "0"}};
  if (set.classification() != ' ')
    more.push_back({"CLASSIFICATION_TYPE", std::string(1, set.classification())});
  more.push_back({"NORAD_CAT_ID", detail::text(set.catalogue_number())});
  more.push_back({"ELEMENT_SET_NO", detail::text(set.element_set_number())});
  more.push_back({"REV_AT_EPOCH", detail::text(set.revolution_number())});
  more.push_back({"MEAN_MOTION_DOT", rounded(0.5 * set.mean_motion_rate().value() /
                                             convert<si::angular_acceleration>(rate).value())});
  more.push_back(
      {"MEAN_MOTION_DDOT", rounded(set.mean_motion_second_rate().value() /
                                   (6.0 * convert<TwoLineElements::SecondRate::unit>(second_rate).value()))});
  return more;
}

}  // namespace

OrbitMeanElementsMessage::OrbitMeanElementsMessage(const MessageHeader& header,
                                                   const std::string& object_name,
                                                   const std::string& object_id, const MeanElements& elements,
                                                   const std::vector<OtherKeyword>& more)
    : OrbitMeanElementsMessage(parse(keywords_of(header, object_name, object_id, elements, more))) {}

OrbitMeanElementsMessage::OrbitMeanElementsMessage(const MessageHeader& header, const TwoLineElements& set)
    : OrbitMeanElementsMessage(header, set.title(), international(set.designator()), set.mean_elements(),
                               more_of(set)) {}

namespace {

/// km of "7000 [km]", written as XML's reader joins the two; empty for any other text.
std::string_view unit_of(std::string_view value) {
  const auto begin = value.rfind(" [");
  if (begin == std::string_view::npos || begin == 0 || !value.ends_with(']') || value[begin - 1] == ' ')
    return {};
  const std::string_view unit = value.substr(begin + 2, value.size() - begin - 3);
  const bool is_plain =
      detail::trimmed(unit) == unit && unit.find_first_of("[]<>&\"'") == std::string_view::npos;
  return is_plain ? unit : std::string_view{};
}

/// The keywords and values of a message in the order of the standard, by parts; others are of none.
template <class Write> void in_order(const OrbitMeanElementsMessage& message, const Write& write) {
  std::vector<std::string_view> known;
  const MessagePlace* place = places;
  for (const detail::MessageKeyword& keyword : omm_kind.keywords) {
    known.push_back(keyword.name);
    if (message.text(keyword.name)) write(place->element, keyword.name);
    if (place != std::end(places) && keyword.name == place->last) ++place;
  }
  for (const auto& [keyword, value] : message.values()) {
    if (keyword != omm_kind.version_keyword && std::find(known.begin(), known.end(), keyword) == known.end())
      write(std::string_view{}, keyword);
  }
}

}  // namespace

OrbitMeanElementsMessage OrbitMeanElementsMessage::with(std::string_view keyword,
                                                        const std::string& value) const {
  detail::require_text(omm_kind.name, std::string{keyword}.c_str(), value);
  OrbitMeanElementsMessage changed = *this;
  changed.values_[std::string{keyword}] = value;
  return parse(changed.text());
}

std::string OrbitMeanElementsMessage::text() const {
  std::string out;
  detail::write_line(out, omm_kind.version_keyword, *text(omm_kind.version_keyword));
  if (const auto* lines = comments(omm_kind.version_keyword)) detail::write_comments(out, *lines);
  std::string_view before = places[0].element;
  in_order(*this, [&](std::string_view part, std::string_view keyword) {
    if (part != before) out += '\n';
    before = part;
    if (const auto* lines = comments(keyword)) detail::write_comments(out, *lines);
    detail::write_line(out, keyword, *text(keyword));
  });
  if (const auto* lines = comments("")) detail::write_comments(out, *lines);
  return out;
}

std::string OrbitMeanElementsMessage::xml_element() const {
  std::string out = "<omm id=\"" + std::string{omm_kind.version_keyword} + "\" version=\"" +
                    *text(omm_kind.version_keyword) + "\">\n";
  constexpr std::string_view user_defined = "USER_DEFINED_";
  std::string_view open;
  const auto begin = [&](std::string_view part) {
    if (part == open) return;
    if (!open.empty()) out.append("</").append(open).append(">\n");
    if (open == "header") out += "<body><segment>\n";
    if (open == "metadata") out += "<data>\n";
    if (!part.empty()) out.append("<").append(part).append(">\n");
    open = part;
  };
  begin("header");
  if (const auto* lines = comments(omm_kind.version_keyword))
    for (const std::string& comment : *lines) out += detail::xml_comment(omm_kind.name, comment);
  in_order(*this, [&](std::string_view part, std::string_view keyword) {
    begin(part.empty() && keyword.starts_with(user_defined) ? "userDefinedParameters" : part);
    if (const auto* lines = comments(keyword))
      for (const std::string& comment : *lines) out += detail::xml_comment(omm_kind.name, comment);
    const std::string& value_text = *text(keyword);
    const auto unit =
        part == "header" || part == "metadata" || part.empty() ? std::string_view{} : unit_of(value_text);
    if (open == "userDefinedParameters") {
      out += detail::xml_leaf("USER_DEFINED", value_text,
                              " parameter=\"" + std::string{keyword.substr(user_defined.size())} + "\"");
    } else if (unit.empty()) {
      out += detail::xml_leaf(keyword, value_text);
    } else {
      const auto value = std::string_view{value_text}.substr(0, value_text.size() - unit.size() - 3);
      out += detail::xml_leaf(keyword, value, " units=\"" + std::string{unit} + "\"");
    }
  });
  begin("");
  if (const auto* lines = comments(""))
    for (const std::string& comment : *lines) out += detail::xml_comment(omm_kind.name, comment);
  return out + "</data>\n</segment></body>\n</omm>\n";
}

namespace {

constexpr const char* xml_start = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";

}  // namespace

std::string OrbitMeanElementsMessage::xml() const {
  return xml_start + xml_element();
}

void OrbitMeanElementsMessage::write(const std::filesystem::path& file) const {
  write(file, {*this});
}

void OrbitMeanElementsMessage::write(const std::filesystem::path& file,
                                     const std::vector<OrbitMeanElementsMessage>& messages) {
  detail::write_file(std::string{omm_kind.name} + " " + file.string(), file,
                     text_of(messages, file.extension() == ".xml"));
}

std::string OrbitMeanElementsMessage::text_of(const std::vector<OrbitMeanElementsMessage>& messages,
                                              bool is_xml) {
  if (messages.empty()) throw BadInput(std::string{omm_kind.name} + ": there are no messages to be written");
  std::string out;
  if (!is_xml) {
    for (const OrbitMeanElementsMessage& message : messages)
      out += (out.empty() ? "" : "\n") + message.text();
    return out;
  }
  for (const OrbitMeanElementsMessage& message : messages) out += message.xml_element();
  return xml_start + (messages.size() == 1 ? out : "<ndm>\n" + out + "</ndm>\n");
}

}  // namespace vectrix
