#include "parameter_reader.hpp"

#include <algorithm>

#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {
namespace {

/// Reads line by line. Each keyword goes to the part that it is of.
class ParameterReader {
 public:
  ParameterReader(KvnReader& reader, const MessageKind& kind)
      : reader_(reader),
        kind_(kind),
        read_{read_version(reader, kind), {}, KvnEntries(reader.place(), "the message"), {}, {}},
        header_(reader.place(), "the message") {}

  ReadParameters read() {
    while (reader_.next()) {
      if (reader_.is_comment()) {
        comments_.push_back(reader_.comment());
      } else if (!reader_.has_keyword() && delimiter()) {
        continue;
      } else {
        add(reader_.keyword());
      }
    }
    if (open_) throw BadInput(read_.blocks.back().place + ": there is no " + word() + "_STOP");
    if (read_.blocks.empty()) throw BadInput(reader_.place() + ": there are no data");
    append_comments(read_.blocks.back().comments);
    fill_header(header_, read_.header);
    read_object(read_.metadata_entries, read_.metadata);
    for (const ReadBlock& block : read_.blocks) check(block);
    return std::move(read_);
  }

 private:
  [[nodiscard]] const std::string& version() const { return read_.header.version; }
  [[nodiscard]] std::string word() const { return std::string{read_.blocks.back().kind->word}; }
  void append_comments(std::vector<std::string>& to) {
    to.insert(to.end(), comments_.begin(), comments_.end());
    comments_.clear();
  }
  ReadBlock& begin_block(const MessageBlock& kind) {
    const std::string on = "the " + std::string{kind.name} + " from line " + text(reader_.line()) + " on";
    read_.blocks.push_back({&kind, KvnEntries(reader_.place(), on), {}, {}, reader_.place() + ", " + on});
    return read_.blocks.back();
  }

  /// <word>_START or <word>_STOP.
  bool delimiter() {
    for (const MessageBlock& block : kind_.blocks) {
      if (!block.is_delimited(version())) continue;
      if (reader_.is(std::string{block.word} + "_START")) {
        if (open_) reader_.fail("expected " + word() + "_STOP");
        append_comments(begin_block(block).comments);
        return open_ = true;
      }
      if (reader_.is(std::string{block.word} + "_STOP")) {
        if (!open_ || read_.blocks.back().kind != &block)
          reader_.fail(open_ ? "expected " + word() + "_STOP"
                             : "there is no " + std::string{block.word} + "_START before it");
        append_comments(read_.blocks.back().comments);
        open_ = false;
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] const MessageKeyword* known(MessagePart part, const KvnLine& line) const {
    return known_keyword(kind_, part, version(), reader_.place(), line);
  }

  void add(KvnLine line) {
    if (open_) {
      ReadBlock& block = read_.blocks.back();
      const MessageKeyword* keyword = known(block.kind->part, line);
      return add(block, std::move(line), keyword);
    }
    if (read_.blocks.empty()) {
      if (!has_metadata_ && known(MessagePart::header, line)) {
        append_comments(read_.header.comments);
        return header_.add(std::move(line));
      }
      if (known(MessagePart::metadata, line)) {
        has_metadata_ = true;
        append_comments(read_.metadata.comments);
        read_.metadata_lines.push_back({line.keyword, line.value});
        return read_.metadata_entries.add(std::move(line));
      }
    }
    for (const MessageBlock& block : kind_.blocks) {
      const MessageKeyword* keyword = known_in(block, line);
      if (!keyword) continue;
      ReadBlock& its = block_for(block, line);
      return add(its, std::move(line), keyword);
    }
    add_other(std::move(line));
  }
  /// A keyword that is of a block without delimiters.
  [[nodiscard]] const MessageKeyword* known_in(const MessageBlock& block, const KvnLine& line) const {
    const MessageKeyword* keyword = known(block.part, line);
    if (keyword && block.is_delimited(version()))
      refuse(reader_.place(), line, "the keyword has its place behind " + std::string{block.word} + "_START");
    return keyword;
  }
  ReadBlock& block_for(const MessageBlock& kind, const KvnLine& line) {
    if (line.keyword == kind.first) return begin_block(kind);
    const auto last = std::find_if(read_.blocks.rbegin(), read_.blocks.rend(),
                                   [&](const ReadBlock& block) { return block.kind == &kind; });
    if (last != read_.blocks.rend()) return *last;
    if (!kind.first.empty())
      refuse(reader_.place(), line,
             "the " + std::string{kind.name} + " begins with " + std::string{kind.first});
    return begin_block(kind);
  }
  void add(ReadBlock& block, KvnLine line, const MessageKeyword* keyword) {
    append_comments(block.comments);
    if (!keyword) require_other(line);
    const bool repeats = keyword && keyword->may_repeat && block.entries.find(line.keyword);
    block.lines.push_back(line);
    if (!repeats) block.entries.add(std::move(line));
  }
  void require_other(const KvnLine& line) const {
    if (const std::string fault = other_fault(kind_, line.keyword); !fault.empty())
      refuse(reader_.place(), line, fault);
  }
  /// Into the part that the line stands in.
  void add_other(KvnLine line) {
    if (!read_.blocks.empty()) return add(read_.blocks.back(), std::move(line), nullptr);
    require_other(line);
    append_comments(has_metadata_ ? read_.metadata.comments : read_.header.comments);
    (has_metadata_ ? read_.metadata.others : read_.header.others).push_back({line.keyword, line.value});
    if (has_metadata_) read_.metadata_lines.push_back({line.keyword, line.value});
    (has_metadata_ ? read_.metadata_entries : header_).add(std::move(line));
  }

  void check(const ReadBlock& block) const {
    for (const KvnLine& line : block.lines) {
      const MessageKeyword* keyword = known(block.kind->part, line);
      if (!keyword) continue;
      if (keyword->value == ValueKind::number || keyword->value == ValueKind::amount) {
        const double value = block.entries.number(line, keyword->unit);
        if (value < 0.0 && keyword->value == ValueKind::amount) block.entries.fail(line, "it is negative");
      }
      if (keyword->value == ValueKind::epoch)
        static_cast<void>(block.entries.epoch(line, read_.metadata.time_system));
      if (line.value.empty()) block.entries.fail(line, "it is empty");
    }
    for (const MessageKeyword& keyword : kind_.keywords) {
      if (keyword.part == block.kind->part && keyword.is_required && version() >= keyword.since &&
          version() <= keyword.until)
        static_cast<void>(block.entries.line(keyword.name));
    }
  }

  KvnReader& reader_;
  const MessageKind& kind_;
  ReadParameters read_;
  KvnEntries header_;
  std::vector<std::string> comments_{};  // since the last line that is none
  bool has_metadata_ = false, open_ = false;
};

std::vector<OtherKeyword> values_of(const std::vector<KvnLine>& lines) {
  std::vector<OtherKeyword> values;
  values.reserve(lines.size());
  for (const KvnLine& line : lines) values.push_back({line.keyword, line.value});
  return values;
}

}  // namespace

double ReadBlock::number(const MessageKind& message, std::string_view keyword, int shift) const {
  const auto known = std::find_if(
      message.keywords.begin(), message.keywords.end(),
      [&](const MessageKeyword& each) { return each.name == keyword && each.part == kind->part; });
  return entries.number(entries.line(keyword), known->unit, shift);
}

const ReadBlock* ReadParameters::find(MessagePart part) const {
  const auto found = std::find_if(blocks.begin(), blocks.end(),
                                  [&](const ReadBlock& block) { return block.kind->part == part; });
  return found == blocks.end() ? nullptr : &*found;
}

ParameterContent ReadParameters::content() const {
  ParameterContent content{header, metadata, metadata_lines, {}};
  for (const ReadBlock& block : blocks)
    content.blocks.push_back({block.kind->name, block.comments, values_of(block.lines)});
  return content;
}

ReadParameters read_parameters(KvnReader& reader, const MessageKind& kind) {
  return ParameterReader(reader, kind).read();
}

}  // namespace vectrix::detail
