#include <vectrix/space/files/parameter_message.hpp>

#include <algorithm>

#include <vectrix/frames/errors.hpp>

#include "ephemeris_writer.hpp"
#include "shifted_number.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

void write_entries(std::string& out, const std::vector<OtherKeyword>& entries) {
  for (const OtherKeyword& entry : entries) detail::write_line(out, entry.keyword, entry.value);
}

void write_block(std::string& out, const detail::MessageKind& kind, const std::string& version,
                 const ParameterBlock& block) {
  const auto known = std::find_if(kind.blocks.begin(), kind.blocks.end(),
                                  [&](const detail::MessageBlock& each) { return each.name == block.name; });
  const bool is_delimited = known->is_delimited(version);
  out.append("\n");
  if (is_delimited) out.append(known->word).append("_START\n");
  detail::write_comments(out, block.comments);
  write_entries(out, block.entries);
  if (is_delimited) out.append(known->word).append("_STOP\n");
}

}  // namespace

const std::string* ParameterBlock::text(std::string_view keyword) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const OtherKeyword& entry) { return entry.keyword == keyword; });
  return found == entries.end() ? nullptr : &found->value;
}

double ParameterBlock::number(std::string_view keyword) const {
  const std::string* written = text(keyword);
  if (!written) throw BadInput("the " + name + ": there is no " + std::string{keyword});
  const std::string_view number = detail::trimmed(std::string_view{*written}.substr(0, written->find('[')));
  const auto value = detail::parse_shifted(number, 0);
  if (!value)
    throw BadInput("the " + name + ", " + std::string{keyword} + ": '" + detail::excerpt(*written) +
                   "': " + detail::number_fault(number, 0));
  return *value;
}

std::vector<ParameterBlock> ParameterMessage::blocks(std::string_view name) const {
  std::vector<ParameterBlock> found;
  std::copy_if(blocks().begin(), blocks().end(), std::back_inserter(found),
               [&](const ParameterBlock& block) { return block.name == name; });
  return found;
}

std::string ParameterMessage::text() const {
  std::string out;
  detail::write_header(out, header(), *kind_);
  out.append("\n");
  detail::write_comments(out, metadata().comments);
  write_entries(out, content_.metadata_entries);
  for (const ParameterBlock& block : blocks()) write_block(out, *kind_, header().version, block);
  return out;
}

void ParameterMessage::write(const std::filesystem::path& file) const {
  detail::write_file(std::string{kind_->name} + " " + file.string(), file, text());
}

}  // namespace vectrix
