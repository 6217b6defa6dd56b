#include <vectrix/space/files/navigation_data_message.hpp>

#include <vectrix/frames/errors.hpp>

#include "message_readers.hpp"
#include "text_file.hpp"
#include "xml_document.hpp"
#include "xml_messages.hpp"

namespace vectrix {
namespace {

NavigationDataMessage read_ndm(const std::string& place, std::string_view text) {
  if (!detail::is_xml(text)) throw BadInput(place + ": it is not XML");
  detail::XmlMessages xml = detail::read_xml(place, text);
  NavigationDataMessage all;
  all.comments = std::move(xml.comments);
  for (const detail::XmlMessage& message : xml.messages) {
    detail::KvnReader reader(place, message.text, message.origins);
    if (message.text.empty()) {
      all.unread.push_back({message.element, message.position.line});
    } else if (message.element == "aem") {
      all.attitude_ephemerides.push_back(detail::read_aem(reader));
    } else if (message.element == "apm") {
      all.attitude_parameters.push_back(detail::read_apm(reader));
    } else if (message.element == "oem") {
      all.orbit_ephemerides.push_back(detail::read_oem(reader));
    } else if (message.element == "opm") {
      all.orbit_parameters.push_back(detail::read_opm(reader));
    } else {
      for (auto& elements : detail::read_omm(reader)) all.orbit_mean_elements.push_back(std::move(elements));
    }
  }
  return all;
}

constexpr const char* ndm_name = "navigation data message";

}  // namespace

NavigationDataMessage NavigationDataMessage::parse(std::string_view text) {
  return read_ndm(ndm_name, text);
}

NavigationDataMessage NavigationDataMessage::read(const std::filesystem::path& file) {
  const std::string place = std::string{ndm_name} + " " + file.string();
  const auto bytes = detail::read_bytes(file);
  if (!bytes) throw BadInput(place + ": cannot be read");
  return read_ndm(place, *bytes);
}

}  // namespace vectrix
