#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>

#include "../time/date.hpp"
#include "kvn.hpp"

namespace vectrix::detail {

/// The epoch of a text. Calls fail(reason), which throws, if it is none.
template <class Fail> Epoch epoch_of(EpochReader& reader, std::string_view text, const Fail& fail) {
  constexpr std::size_t longest = 40;
  if (text.size() > longest) fail("too long for an epoch");
  try {
    return reader.read(text);
  } catch (const BadInput& error) {
    fail(error.what());
    throw;
  }
}

/// The lines `keyword = value` of a message, or of a part of it, each keyword once. Every error is a BadInput
/// with the place.
class KvnEntries {
 public:
  /// `what` names them in messages: "the message from line 1 on".
  KvnEntries(std::string place, std::string what) : place_(std::move(place)), what_(std::move(what)) {}

  /// Refuses a keyword that is there.
  void add(KvnLine line);

  [[nodiscard]] const std::map<std::string, KvnLine, std::less<>>& all() const { return lines_; }
  /// Null if there is none.
  [[nodiscard]] const KvnLine* find(std::string_view keyword) const;
  /// Refuses a message without it.
  [[nodiscard]] const KvnLine& line(std::string_view keyword) const;
  /// The same, and it has a value.
  [[nodiscard]] const KvnLine& filled(std::string_view keyword) const;

  /// The finite number times 10^shift, with this unit or without one.
  [[nodiscard]] double number(const KvnLine& line, std::string_view unit, int shift = 0) const;
  /// The number, which is not negative.
  [[nodiscard]] std::int64_t whole(const KvnLine& line) const;
  [[nodiscard]] Epoch epoch(const KvnLine& line, const TimeScale& scale) const;

  [[noreturn]] void fail(const KvnLine& line, const std::string& reason) const {
    refuse(place_, line, reason);
  }

 private:
  std::string place_, what_;
  std::map<std::string, KvnLine, std::less<>> lines_;
};

}  // namespace vectrix::detail
