#pragma once

#include <string>

class GDALDataset;

namespace gable {

/// A file that GDAL writes into memory, so that it reaches the disk whole or not at all.
class MemoryFile {
 public:
  /// `extension` with its dot; GDAL's drivers look at it.
  explicit MemoryFile(const std::string& extension);
  ~MemoryFile();
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// The name for GDAL.
  const std::string& name() const { return name_; }

  /// Closes the dataset that was written under name() and puts its bytes on disk, atomically.
  /// Throws Error (kCannotWrite), or kInternal where GDAL could not write into memory.
  void close_and_write(GDALDataset* dataset, const std::string& path);

 private:
  std::string name_;
};

}  // namespace gable
