#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vectrix::cli {

/// Attributes of a group or a dataset of HDF5: names and texts.
using Hdf5Words = std::vector<std::pair<std::string, std::string>>;

/// Writes a file of HDF5. Datasets are compressed (shuffle, deflate), all of the file has checksums,
/// and it has no times of its own: the same content makes the same bytes. Groups are made as paths name them.
/// All throw BadInput if the file cannot be written.
class Hdf5Writer {
 public:
  explicit Hdf5Writer(const std::filesystem::path& file);
  ~Hdf5Writer();

  void add_words(const std::string& path, const Hdf5Words& words);
  void add_number(const std::string& path, const std::string& name, double value);  // an attribute
  /// One dimension, or with more than one column two.
  void add(const std::string& path, const std::vector<double>& numbers, std::size_t columns = 1);
  void add(const std::string& path, const std::vector<std::int64_t>& numbers);
  void add(const std::string& path, const std::vector<std::string>& texts, std::size_t columns = 1);
  /// Another name for what is there.
  void link(const std::string& path, const std::string& there);
  /// What is not closed may not be whole; nothing can be added any more.
  void close();

 private:
  class Content;
  std::unique_ptr<Content> content_;
};

/// A file as Hdf5Writer makes it. All throw BadInput with the names of the file and of the dataset: for what
/// is not there, is of another kind or size or holds NaN or infinity, and for bytes that are damaged. What is
/// read is at most a thousand times as large as the file.
class Hdf5Reader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& file);
  ~Hdf5Reader();

  [[nodiscard]] bool has(const std::string& path) const;
  [[nodiscard]] std::string word(const std::string& path, const std::string& name) const;
  [[nodiscard]] double number(const std::string& path, const std::string& name) const;  // an attribute
  [[nodiscard]] std::vector<double> numbers(const std::string& path, std::size_t columns = 1) const;
  [[nodiscard]] std::vector<std::int64_t> whole_numbers(const std::string& path) const;
  [[nodiscard]] std::vector<std::string> texts(const std::string& path, std::size_t columns = 1) const;
  [[noreturn]] void refuse(const std::string& path, const std::string& why) const;

 private:
  class Content;
  std::unique_ptr<Content> content_;
};

}  // namespace vectrix::cli
