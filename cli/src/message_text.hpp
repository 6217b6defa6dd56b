#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "table_text.hpp"
#include "word.hpp"

namespace vectrix::cli {

/// What a message says besides its data.
struct MessageText {
  MessageHeader header;
  EphemerisMetadata metadata;
  std::vector<std::string> comments;  // between the data lines
};

/// What is given of a message that is to be written; what is empty is taken from the message that was read.
struct GivenText {
  std::string object_name{}, object_id{}, originator{}, creation_date{};
};

/// Throws BadInput for a text that holds a line break or another control character.
void require_one_line(const char* option, const std::string& text);

/// The text of a message to be written. If none was read, all must be given, and what else is needed:
/// BadInput, as for texts of several lines.
MessageText message_text(const GivenText& given, const std::optional<MessageText>& read,
                         const TimeScale& scale, const std::string& file, const Words& also_needed);

/// The name that was given, or that of the message. Throws BadInput if there is none.
std::string object_name(const GivenText& given, const std::optional<MessageText>& read,
                        const std::string& file);
/// The times of the metadata, for data from the first to the last time. Throws BadInput if none of them is
/// useable.
void set_times(EphemerisMetadata& metadata, const Epoch& first, const Epoch& last, const std::string& file);

/// The text of the message, in XML for a file whose name ends in .xml. Throws BadInput if it cannot be read.
template <class Message>
std::string text_that_reads_back(const Message& message, const std::filesystem::path& out) {
  std::string text = ending_of(out) == ".xml" ? message.xml() : message.text();
  try {
    static_cast<void>(Message::parse(text));
  } catch (const BadInput& error) {
    throw BadInput(std::string("what would be written cannot be read, ") + error.what());
  }
  return text;
}

}  // namespace vectrix::cli
