#include "xml_messages.hpp"

#include <algorithm>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "covariance_keyword.hpp"
#include "message_kinds.hpp"
#include "text_file.hpp"
#include "xml_columns.hpp"
#include "xml_document.hpp"
#include "xml_text.hpp"

namespace vectrix::detail {
namespace {

using pugi::xml_node;

/// An element that holds the keywords of a part. `word` gives the lines around them, from version 2.0 on.
struct XmlContainer {
  std::string_view name, word{};
};
constexpr XmlContainer attitude_containers[] = {{"quaternionState", "QUAT"},
                                                {"quaternion"},
                                                {"quaternionRate"},
                                                {"quaternionDot"},
                                                {"eulerElementsThree"},
                                                {"eulerElementsSpin"},
                                                {"rotationAngles"},
                                                {"rotationRates"},
                                                {"eulerAngleState", "EULER"},
                                                {"angularVelocity", "ANGVEL"},
                                                {"spin", "SPIN"},
                                                {"spinNutation", "SPIN"},
                                                {"spinNutationMom", "SPIN"},
                                                {"spacecraftParameters"},
                                                {"inertia", "INERTIA"},
                                                {"maneuverParameters", "MAN"}};
constexpr XmlContainer orbit_containers[] = {
    {"stateVector"},          {"keplerianElements"}, {"meanElements"},       {"tleParameters"},
    {"spacecraftParameters"}, {"covarianceMatrix"},  {"maneuverParameters"}, {"userDefinedParameters"}};

/// Reads one message.
class XmlMessageReader : XmlText {
 public:
  XmlMessageReader(const XmlDocument& document, xml_node message, const MessageKind& kind)
      : XmlText(document),
        element_(XmlDocument::name(message)),
        version_(document.attribute(message, "version")) {
    const std::string keyword = kind.version_keyword, id = document.attribute(message, "id");
    if (!id.empty() && id != keyword)
      document.fail(message, "its id is '" + excerpt(id) + "', not " + keyword);
    put_keyword(keyword, document.position(message), {version_, document.position(message)});
    if (!kind.has(version_)) return;  // it is refused by what it says
    document.require_elements(message);
    for (const xml_node part : message.children()) {
      if (XmlDocument::name(part) == "header") {
        document.require_elements(part);
        for (const xml_node entry : part.children()) put_entry(entry);
      } else if (XmlDocument::name(part) == "body") {
        put_body(part);
      } else {
        document.fail(part, "expected header or body");
      }
    }
  }

  XmlMessage message(const TextPosition& position) && {
    return {std::move(element_), position, std::move(text_), std::move(origins_)};
  }

 private:
  void put_body(xml_node body) {
    document_.require_elements(body);
    for (const xml_node segment : body.children()) {
      if (XmlDocument::name(segment) != "segment") document_.fail(segment, "expected segment");
      document_.require_elements(segment);
      const xml_node metadata = segment.first_child(), data = metadata.next_sibling();
      if (!metadata || XmlDocument::name(metadata) != "metadata")
        document_.fail(segment, "expected metadata in it");
      if (!data || XmlDocument::name(data) != "data")
        document_.fail(segment, "expected data behind the metadata");
      if (const xml_node more = data.next_sibling())
        document_.fail(more, "expected no more than metadata and data");
      document_.require_elements(metadata);
      document_.require_elements(data);
      put_segment(segment, metadata, data);
    }
  }
  [[nodiscard]] bool is_ephemeris() const { return element_ == "aem" || element_ == "oem"; }
  void put_segment(xml_node segment, xml_node metadata, xml_node data) {
    if (is_ephemeris()) put_word("META_START", segment);
    for (const xml_node entry : metadata.children()) put_entry(entry);
    if (is_ephemeris()) put_word("META_STOP", data);
    if (element_ == "aem") {
      put_attitudes(metadata, data);
    } else if (element_ == "oem") {
      put_orbit(data);
    } else {
      put_parameters(data);
    }
  }

  void put_parameters(xml_node data) {
    for (const xml_node entry : data.children()) {
      const auto* container = container_of(entry);
      if (!container) {
        put_entry(entry);
        continue;
      }
      document_.require_elements(entry);
      const bool is_delimited = element_ == "apm" && !has_direction(version_) && !container->word.empty();
      if (is_delimited) put_word(std::string{container->word} + "_START", entry);
      put_parameters_of(entry);
      if (is_delimited) put_word(std::string{container->word} + "_STOP", entry);
    }
  }
  /// Of a container, and of those in it, which have no others.
  void put_parameters_of(xml_node container) {
    for (const xml_node entry : container.children()) {
      if (!container_of(entry)) {
        put_entry(entry);
        continue;
      }
      document_.require_elements(entry);
      for (const xml_node inner : entry.children()) put_entry(inner);
    }
  }
  [[nodiscard]] const XmlContainer* container_of(xml_node entry) const {
    const std::string_view name = XmlDocument::name(entry);
    const auto find = [&](const auto& containers) -> const XmlContainer* {
      const auto* const found = std::find_if(std::begin(containers), std::end(containers),
                                             [&](const XmlContainer& each) { return each.name == name; });
      return found == std::end(containers) ? nullptr : found;
    };
    return element_ == "apm" ? find(attitude_containers) : find(orbit_containers);
  }

  void put_attitudes(xml_node metadata, xml_node data) {
    const auto word = [&](const char* keyword) {
      const auto found = XmlDocument::children(metadata, keyword);
      return found.empty() ? std::string{} : upper_case(document_.value(found.front()).text);
    };
    const auto line = attitude_line(word, version_);
    put_word("DATA_START", data);
    for (const xml_node state : data.children()) {
      if (XmlDocument::name(state) == "COMMENT") {
        put_comment(state);
      } else if (XmlDocument::name(state) != "attitudeState") {
        document_.fail(state, "expected attitudeState");
      } else if (line) {
        put_line(state, line->columns);
      }
    }
    put_word("DATA_STOP", data);
  }

  void put_orbit(xml_node data) {
    bool has_covariance = false;
    for (const xml_node entry : data.children()) {
      const std::string_view name = XmlDocument::name(entry);
      if (name == "COMMENT") {
        put_comment(entry);
      } else if (name == "stateVector" && !has_covariance) {
        put_line(entry, orbit_line(!XmlDocument::children(entry, "X_DDOT").empty()).columns);
      } else if (name == "covarianceMatrix") {
        if (!std::exchange(has_covariance, true)) put_word("COVARIANCE_START", entry);
        put_covariance(entry);
      } else {
        document_.fail(
            entry, has_covariance ? "expected covarianceMatrix" : "expected stateVector or covarianceMatrix");
      }
    }
    if (has_covariance) put_word("COVARIANCE_STOP", data);
  }
  void put_covariance(xml_node matrix) {
    document_.require_elements(matrix);
    for (const char* keyword : {"COMMENT", "EPOCH", "COV_REF_FRAME"}) {
      for (const xml_node entry : XmlDocument::children(matrix, keyword)) put_entry(entry);
    }
    for (const xml_node entry : matrix.children()) {
      const std::string_view name = XmlDocument::name(entry);
      if (name != "COMMENT" && name != "EPOCH" && name != "COV_REF_FRAME" && !is_covariance_keyword(name))
        document_.fail(entry, "it is not of a covariance");
    }
    for (std::size_t row = 0; row < state_components.size(); ++row) {
      for (std::size_t column = 0; column <= row; ++column) {
        const std::string keyword = covariance_keyword(row, column);
        const auto found = XmlDocument::children(matrix, keyword);
        if (found.empty()) document_.fail(matrix, "there is no " + keyword);
        if (found.size() > 1) document_.fail(found.front(), "it is there twice");
        put_number(found.front(), {keyword, covariance_unit(row, column)}, column == row ? "\n" : " ");
      }
    }
  }

  std::string element_, version_;
};

XmlMessage read_message_element(const XmlDocument& document, xml_node message) {
  const std::string name{XmlDocument::name(message)};
  const MessageKind* kind = kind_of_element(name);
  if (!kind) return {name, document.position(message)};
  return XmlMessageReader(document, message, *kind).message(document.position(message));
}

}  // namespace

std::vector<XmlMessage> messages_in_xml(const std::string& place, std::string_view text,
                                        const std::string& element) {
  XmlMessages all = read_xml(place, text);
  if (all.messages.empty()) throw BadInput(place + ": there is no message");
  for (const XmlMessage& message : all.messages) {
    if (message.element != element)
      throw BadInput(place + ", line " + detail::text(message.position.line) + ", column " +
                     detail::text(message.position.column) + ": <" + excerpt(message.element) +
                     ">: expected <" + element + ">" +
                     (all.is_combined ? "; NavigationDataMessage reads every kind" : ""));
  }
  return std::move(all.messages);
}

XmlMessages read_xml(const std::string& place, std::string_view text) {
  const XmlDocument document(place, text);
  XmlMessages all;
  all.is_combined = XmlDocument::name(document.root()) == "ndm";
  if (!all.is_combined) {
    all.messages.push_back(read_message_element(document, document.root()));
    return all;
  }
  document.require_elements(document.root());
  for (const xml_node child : document.root().children()) {
    const std::string_view name = XmlDocument::name(child);
    if (name == "COMMENT") {
      all.comments.push_back(document.value(child).text);
    } else if (name == "MESSAGE_ID") {
      all.comments.push_back("MESSAGE_ID " + document.value(child).text);
    } else {
      all.messages.push_back(read_message_element(document, child));
    }
  }
  return all;
}

}  // namespace vectrix::detail
