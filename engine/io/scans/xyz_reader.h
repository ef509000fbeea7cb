#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// What the columns behind x y z of a text file of points are.
enum class XyzColumns {
  kNormals,  ///< columns 4 to 6 are a normal
  kUnknown,  ///< columns 4 to 6 are a normal where all of them have unit length to 1e-2
};

/// Reads rows of x y z and further columns, separated by blanks, tabs, commas or semicolons; the
/// first row may name the columns, lines that start with # or // are comments. Further columns that
/// are no normals are not read. Errors as `read_scan_file`; also where the rows have different
/// numbers of columns. `path` is for messages.
ScanFile read_xyz(std::string_view bytes, const std::string& path, XyzColumns columns);

/// Reads a PWN file, of either kind: the number of points, their coordinates, then as many normals;
/// or, where the first line has more than one number, rows of x y z nx ny nz. Errors as
/// `read_scan_file`.
ScanFile read_pwn(std::string_view bytes, const std::string& path);

}  // namespace gable
