#pragma once

#include <string>
#include <vector>

namespace gable {

/// A folder whose new files appear together, when all of them are complete: they are written into a
/// hidden folder inside it, and `commit` moves them out. Without `commit` nothing is left behind,
/// not even folders that had to be made.
class StagedFolder {
 public:
  /// Makes the folder where it is missing, so that one that cannot be written is known before any
  /// work is done. Throws Error (kCannotWrite).
  explicit StagedFolder(const std::string& folder);
  ~StagedFolder();
  StagedFolder(const StagedFolder&) = delete;
  StagedFolder& operator=(const StagedFolder&) = delete;

  /// The hidden folder that files are written into.
  const std::string& staging() const { return staging_; }
  /// Where the file that will have a name is written.
  std::string path(const std::string& name) const;

  /// Gives all files their places; those of the same names are replaced. Throws Error
  /// (kCannotWrite).
  void commit();

 private:
  void fail(const std::string& reason) const;

  std::string folder_;
  std::string staging_;
  std::vector<std::string> made_;  ///< folders that were missing, outermost first
};

}  // namespace gable
