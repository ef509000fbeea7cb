#pragma once

#include <gable/engine/io/scans/scan_file.h>

#include <string>
#include <string_view>

namespace gable {

/// Says that a file is damaged: throws Error (kBadInput) "PATH: PROBLEM; REMEDY".
[[noreturn]] void refuse_scan(const std::string& path, const std::string& problem,
                              std::string_view remedy = "the file is damaged, export it again");

/// The last step of every reader: takes what a file says and makes it a Scan. Points with
/// coordinates that are not finite or beyond 1e12 m go, and with them the facets that use them;
/// facets with fewer than three corners go too; normals become unit, or zero where they are
/// shorter than 1e-6 or not finite; negative labels become -1. Normals and labels stay aligned.
///
/// `raw.normals` has one per point or none. A list in `raw.labels` has one value per facet where
/// there are facets, else per point. Throws Error (kBadInput) where a corner is no point of the
/// file, or no usable point is left.
ScanFile finish_scan(Scan raw, const std::string& path);

}  // namespace gable
