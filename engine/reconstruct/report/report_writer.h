#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/reconstruct/report/house_entry.h>
#include <gable/residuals/height_image.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace gable {

/// How a report is written.
struct ReportOptions {
  int panel_size = 320;         ///< edge of each of a picture's four views, pixels, [64, 2048]
  double residual_range = 1.0;  ///< residual of the strongest colours, metres, (0, 100]
};

/// Empty if the options are in range; otherwise names the violated bound.
std::string check(const ReportOptions& options);

/// Writes a report into a folder: index.html and one picture per building below houses/. Nothing
/// shows under its final name before `finish`; without `finish` the folder is left as it was.
class ReportWriter {
 public:
  /// Makes the folder. Throws Error (kCannotWrite) where that, or writing into it, is impossible.
  explicit ReportWriter(const std::string& folder, const ReportOptions& options = {});
  ~ReportWriter();
  ReportWriter(const ReportWriter&) = delete;
  ReportWriter& operator=(const ReportWriter&) = delete;

  /// Draws a building. `index` is its place in the report, different for every building; calls may
  /// come from several threads in any order. Throws Error (kCannotWrite).
  void add(size_t index, const Building& building, const HeightImage& image);

  /// Moves the pictures to their place and writes the page. Throws Error (kCannotWrite).
  void finish();

 private:
  const std::string folder_;
  const ReportOptions options_;
  std::string staging_;               ///< pictures until `finish`; empty afterwards
  std::vector<std::string> created_;  ///< folders made, outermost first
  std::mutex mutex_;
  std::vector<HouseEntry> entries_;
};

/// Name of a building's picture: its index and those characters of its id that are safe in a file
/// name and a link.
std::string picture_name(size_t index, const std::string& id);

}  // namespace gable
