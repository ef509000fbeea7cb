#pragma once

#include <gable/engine/house_answer.h>

#include <string>

namespace gable {

/// Writes the annotated buildings of a raster, one a line, coordinates rounded to 0.05 m. Throws
/// Error (kCannotWrite).
void write_annotations(const std::string& path, const AnnotatedTile& tile);

/// Reads them. Throws Error: kNoInput where the file cannot be opened; kBadInput, naming the
/// building, where it is not what `write_annotations` writes.
AnnotatedTile read_annotations(const std::string& path);

}  // namespace gable
