#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/trusted.hpp>
#include <vectrix/space/files/ephemeris_metadata.hpp>

namespace vectrix {

/// A block of a parameter message as it is written: keywords and values in their order, with units in
/// brackets, if they have one.
struct VECTRIX_EXPORT ParameterBlock {
  std::string name;
  std::vector<std::string> comments{};
  std::vector<OtherKeyword> entries{};

  /// The value of a keyword, the first one if it is there twice; null if the block does not have it.
  [[nodiscard]] const std::string* text(std::string_view keyword) const;
  /// The number of a keyword, in the unit that the standard has for it. Throws BadInput that names the block
  /// if it does not have the keyword, or the value is no number.
  [[nodiscard]] double number(std::string_view keyword) const;
};

namespace detail {

struct MessageKind;

/// A parameter message without the meaning of its blocks.
struct ParameterContent {
  MessageHeader header;
  EphemerisMetadata metadata;
  std::vector<OtherKeyword> metadata_entries;
  std::vector<ParameterBlock> blocks;
};

}  // namespace detail

/// What orbit and attitude parameter messages have in common: a header, metadata, and blocks of keywords for
/// one epoch. Everything is kept as it is written, also keywords that are not of the standard.
class VECTRIX_EXPORT ParameterMessage {
 public:
  [[nodiscard]] const MessageHeader& header() const { return content_.header; }
  /// Without times and interpolation.
  [[nodiscard]] const EphemerisMetadata& metadata() const { return content_.metadata; }
  [[nodiscard]] const Epoch& epoch() const { return epoch_; }
  /// In the order of the message; manoeuvres, and in version 2.0 of attitudes all others, as often as they
  /// are there.
  [[nodiscard]] const std::vector<ParameterBlock>& blocks() const { return content_.blocks; }
  /// Those with this name.
  [[nodiscard]] std::vector<ParameterBlock> blocks(std::string_view name) const;

  /// The message as text: the same values, letter by letter. A comment stands before its block.
  [[nodiscard]] std::string text() const;
  /// Throws BadInput if the file cannot be written.
  void write(const std::filesystem::path& file) const;

 protected:
  ParameterMessage(detail::Trusted, const detail::MessageKind& kind, detail::ParameterContent content,
                   const Epoch& epoch)
      : kind_(&kind), content_(std::move(content)), epoch_(epoch) {}

 private:
  const detail::MessageKind* kind_;
  detail::ParameterContent content_;
  Epoch epoch_;
};

}  // namespace vectrix
