// Any file is an XML document of messages or is refused. The text of each message in keyword-value notation
// reads back as the same text; so does the XML of an ephemeris and of mean elements.
#include <vectrix/space/files/navigation_data_message.hpp>

#include "input_file.hpp"

namespace {

template <class Message> void require_reads_back(const std::vector<Message>& messages) {
  for (const Message& message : messages) {
    const std::string text = message.text();
    if (Message::parse(text).text() != text) std::abort();
  }
}

template <class Message> void require_xml_reads_back(const std::vector<Message>& messages) {
  for (const Message& message : messages) {
    if (Message::parse(message.xml()).text() != message.text()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto message = fuzz::accepted([&] { return NavigationDataMessage::read(file.path()); });
  if (!message) return 0;
  require_reads_back(message->attitude_ephemerides);
  require_xml_reads_back(message->attitude_ephemerides);
  require_xml_reads_back(message->orbit_ephemerides);
  require_reads_back(message->attitude_parameters);
  require_reads_back(message->orbit_ephemerides);
  require_reads_back(message->orbit_parameters);
  require_reads_back(message->orbit_mean_elements);
  require_xml_reads_back(message->orbit_mean_elements);
  return 0;
}
