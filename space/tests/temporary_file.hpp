#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vectrix/frames/errors.hpp>

namespace vectrix {

/// Where nothing else of the tests is: the name has those of the test and of the process.
inline std::filesystem::path temporary_path(const std::string& ending = "") {
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::temp_directory_path() / (std::string{"vectrix_"} + test->test_suite_name() + "_" +
                                                   test->name() + "_" + std::to_string(::getpid()) + ending);
}

/// A file with the given content. It exists as long as the object.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& content) : path_(temporary_path()) {
    std::ofstream(path_, std::ios::binary) << content;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() { std::filesystem::remove(path_); }

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The text of the BadInput that the call throws, with the file's path replaced by `name`.
template <class Function>
std::string complaint(Function function, const std::filesystem::path& file = {},
                      const std::string& name = "FILE") {
  try {
    function();
  } catch (const BadInput& error) {
    std::string text = error.what();
    if (const auto at = text.find(file.string()); !file.empty() && at != std::string::npos) {
      text.replace(at, file.string().size(), name);
    }
    return text;
  }
  return "nothing was thrown";
}

}  // namespace vectrix
