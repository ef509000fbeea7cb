#pragma once

#include <gable/engine/scan.h>

#include <span>
#include <string>

namespace gable {

/// Writes a scan as binary little-endian PLY: points as double, normals as float where the scan has
/// some, facets as lists of int, and an int property `shape` per element: its shape, or -1. The
/// order of points and facets is that of the scan; the scan's own labels are not written.
/// `shape_of` has one value per element. Throws Error (kCannotWrite).
void write_labelled_ply(const std::string& path, const Scan& scan, std::span<const int> shape_of);

/// The same with the scan's own labels, each an int property of its name, in place of `shape`: a
/// scan as it is. Names must be words without blanks.
void write_scan_ply(const std::string& path, const Scan& scan);

}  // namespace gable
