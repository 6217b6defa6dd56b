#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include <vectrix/space/files/text_kernel.hpp>

namespace vectrix::detail {

/// Reads the assignments of the data blocks, character by character.
class TextKernelParser {
 public:
  using Variables = std::map<std::string, TextKernel::Variable, std::less<>>;

  TextKernelParser(const std::string& place, std::string_view text) : place_(place), rest_(text) {}

  /// Throws BadInput with line and column.
  Variables read();

 private:
  void take_line_of_comment();
  void take_assignment(Variables& variables);
  /// True if there is data before the end of the block.
  bool skip_to_data();
  TextKernel::Value take_value();
  TextKernel::Value take_text();
  void take(std::size_t count);
  [[nodiscard]] bool at_line_start() const { return only_blanks_; }
  [[nodiscard]] std::string_view word(std::string_view ends) const;
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void fail(std::size_t line, std::size_t column, const std::string& reason) const;

  const std::string& place_;
  std::string_view rest_;
  std::size_t line_ = 1, column_ = 1;
  bool in_data_ = false, only_blanks_ = true;
};

}  // namespace vectrix::detail
