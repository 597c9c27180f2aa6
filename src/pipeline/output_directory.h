#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace nearwall::pipeline {

/// The folder of the results of one case. Files are written aside, in a hidden folder within it, and moved to their
/// names together by `publish`; what is not published is removed. Files of other names are never touched.
class OutputDirectory {
 public:
  /// Makes the folder if it is not there.
  /// \param name      of the case: its results are NAME.*, NAME-*, report.json and report.html
  /// \param is_forced write even where the folder holds other things
  /// \throws InputError  if the folder holds anything but results of this case, or another run is writing to it;
  /// IoError
  OutputDirectory(std::filesystem::path directory, std::string name, bool is_forced);
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  const std::filesystem::path& path() const { return directory_; }

  /// Where to write a file, or a folder, of this name until it is published.
  std::filesystem::path aside(const std::string& file);

  /// Names of the files asked for so far.
  std::vector<std::string> planned() const { return files_; }

  /// The same for a file that is not to be published, or for finding one that was written aside before.
  std::filesystem::path scratch(const std::string& file);

  /// Removes the results of earlier runs and moves all files that were written aside to their names, in the order in
  /// which they were asked for. \returns their names. \throws IoError
  std::vector<std::string> publish();

 private:
  std::vector<std::filesystem::path> foreign_files() const;
  bool is_result(const std::string& file) const;

  /// Removes the folder if it was made here and is empty, and lets other runs in.
  void give_back();
  /// Keeps other runs out until the end of this object or process.
  void lock();

  std::filesystem::path directory_;
  std::string name_;
  std::filesystem::path aside_;
  std::vector<std::string> files_;
  bool is_new_ = false;
  int descriptor_ = -1;  ///< of the folder, which it locks
};

}  // namespace nearwall::pipeline
