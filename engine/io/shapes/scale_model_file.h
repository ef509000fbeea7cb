#pragma once

#include <gable/engine/scales/scale_model.h>

#include <string>
#include <string_view>

namespace gable {

/// The file of a scale model, extension .scales. All numbers are little-endian:
///
///   the line "gable scales 1\n" (format and version)
///   uint16 length of the name, the name, float64 gamma, uint8 number of labels, uint16 trees
///   per tree its nodes in preorder: uint8 feature and float32 threshold of a test, or uint8 255
///     and one byte per label of a leaf (-log P in steps of kLeafCostStep)
///   uint32 CRC-32 (ISO 3309) of all bytes before it
///
/// What is written is read back equal. The model must be sound. Throws Error (kCannotWrite).
void write_scale_model(const ScaleModel& model, const std::string& path);

/// Throws Error where the file cannot be read (kNoInput) or is foreign, of another version, cut
/// short or damaged (kBadInput).
ScaleModel read_scale_model(const std::string& path);

/// The bytes of a file, and a model from bytes; `path` is for messages.
std::string scale_model_bytes(const ScaleModel& model);
ScaleModel scale_model_from_bytes(std::string_view bytes, const std::string& path);

}  // namespace gable
