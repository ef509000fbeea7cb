#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gable {

/// An input or output of a network as an ONNX file declares it.
struct OnnxTensor {
  std::string name;
  std::vector<int64_t> dims;  ///< -1: any
};

/// What a network takes and gives; the names of its weights are no inputs.
struct OnnxSignature {
  std::vector<OnnxTensor> inputs;
  std::vector<OnnxTensor> outputs;
};

/// The key of the model's metadata under which a network carries the CRC-32 (as of zlib) of its
/// graph's bytes, eight lower-case hexadecimal digits.
inline constexpr char kOnnxChecksum[] = "graph_crc32";

/// Reads the signature of an ONNX model (a protobuf message, onnx.proto of ONNX 1.x) from a file's
/// bytes without loading it. Nothing where the bytes are no such model or a damaged one: any field
/// that ends beyond its message, hence any cut of the file; weights of another size than their
/// shape; no graph; a checksum, where the model has one, that does not hold. OpenCV's reader may
/// crash on such files. Never throws.
std::optional<OnnxSignature> onnx_signature(std::string_view bytes);

}  // namespace gable
