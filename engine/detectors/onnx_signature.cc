#include <gable/engine/detectors/onnx_signature.h>

#include <array>
#include <cstdio>
#include <set>

namespace gable {
namespace {

// Numbers of fields, by message of onnx.proto.
namespace model_field {
enum { kGraph = 7, kMetadata = 14 };
}
namespace graph_field {
enum { kInitializer = 5, kInput = 11, kOutput = 12 };
}
namespace initializer_field {
enum { kDims = 1, kType = 2, kName = 8, kRaw = 9 };
}
namespace metadata_field {
enum { kKey = 1, kValue = 2 };
}
namespace value_field {
enum { kName = 1, kType = 2 };
}
namespace type_field {
enum { kTensor = 1 };
}
namespace tensor_field {
enum { kShape = 2 };
}
namespace shape_field {
enum { kDimension = 1 };
}
namespace dimension_field {
enum { kValue = 1 };
}

bool read_varint(std::string_view* bytes, uint64_t* value) {
  *value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    if (bytes->empty()) return false;
    const auto byte = static_cast<unsigned char>(bytes->front());
    bytes->remove_prefix(1);
    *value |= static_cast<uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return true;
  }
  return false;
}

// All of `bytes`, one varint after the other.
bool read_varints(std::string_view bytes, std::vector<uint64_t>* values) {
  values->clear();
  while (!bytes.empty()) {
    values->push_back(0);
    if (!read_varint(&bytes, &values->back())) return false;
  }
  return true;
}

// The fields of one protobuf message, one after the other. After the last one, or at a field that
// is damaged, `next` is false; `sound` tells which.
class Fields {
 public:
  explicit Fields(std::string_view message) : rest_(message) {}

  bool next() {
    constexpr uint64_t kVarint = 0, kEightBytes = 1, kBytes = 2, kFourBytes = 5;
    if (rest_.empty() || !sound_) return false;
    uint64_t key = 0;
    if (!read_varint(&rest_, &key)) return sound_ = false;
    number_ = key >> 3;
    bytes_ = {};
    value_ = 0;
    is_bytes_ = (key & 7) == kBytes;
    uint64_t length = 0;
    switch (key & 7) {
      case kVarint:
        return sound_ = number_ > 0 && read_varint(&rest_, &value_);
      case kEightBytes:
        length = 8;
        break;
      case kFourBytes:
        length = 4;
        break;
      case kBytes:
        if (!read_varint(&rest_, &length)) return sound_ = false;
        break;
      default:
        return sound_ = false;
    }
    if (number_ == 0 || length > rest_.size()) return sound_ = false;
    bytes_ = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return true;
  }

  bool is_bytes() const { return is_bytes_; }
  bool sound() const { return sound_; }
  uint64_t number() const { return number_; }
  uint64_t value() const { return value_; }
  std::string_view bytes() const { return bytes_; }

 private:
  std::string_view rest_;
  std::string_view bytes_;
  uint64_t number_ = 0;
  uint64_t value_ = 0;
  bool is_bytes_ = false;
  bool sound_ = true;
};

// The only field of a message that has the given number; empty where there is none.
std::string_view field(std::string_view message, uint64_t number) {
  std::string_view found;
  Fields fields(message);
  while (fields.next()) {
    if (fields.number() == number) found = fields.bytes();
  }
  return found;
}

OnnxTensor tensor_of(std::string_view value_info) {
  OnnxTensor tensor;
  tensor.name = std::string(field(value_info, value_field::kName));
  const std::string_view type = field(value_info, value_field::kType);
  Fields shape(field(field(type, type_field::kTensor), tensor_field::kShape));
  while (shape.next()) {
    if (shape.number() != shape_field::kDimension) continue;
    int64_t size = -1;
    Fields dimension(shape.bytes());
    while (dimension.next()) {
      if (dimension.number() == dimension_field::kValue) {
        size = static_cast<int64_t>(dimension.value());
      }
    }
    tensor.dims.push_back(size);
  }
  return tensor;
}

// Bytes of one value of an ONNX element type; 0 for those that are not checked.
size_t element_size(uint64_t type) {
  constexpr uint64_t kFloat = 1, kInt32 = 6, kInt64 = 7, kDouble = 11;
  if (type == kFloat || type == kInt32) return 4;
  return type == kInt64 || type == kDouble ? 8 : 0;
}

// Whether a tensor's raw bytes, where it has any, are as many as its shape says.
bool is_sound_tensor(std::string_view tensor) {
  constexpr uint64_t kMost = uint64_t{1} << 32;
  uint64_t count = 1, type = 0;
  std::string_view raw;
  Fields fields(tensor);
  while (fields.next()) {
    if (fields.number() == initializer_field::kDims) {
      // A list of sizes in one field, or one field for each.
      std::vector<uint64_t> sizes = {fields.value()};
      if (fields.is_bytes() && !read_varints(fields.bytes(), &sizes)) return false;
      for (const uint64_t size : sizes) {
        if (size > kMost || (count *= size) > kMost) return false;
      }
    } else if (fields.number() == initializer_field::kType) {
      type = fields.value();
    } else if (fields.number() == initializer_field::kRaw) {
      raw = fields.bytes();
    }
  }
  const size_t size = element_size(type);
  return fields.sound() && (raw.empty() || size == 0 || raw.size() == count * size);
}

std::string crc32_text(std::string_view bytes) {
  uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1u ? 0xedb88320u : 0u);
  }
  std::array<char, 9> text{};
  std::snprintf(text.data(), text.size(), "%08x", static_cast<unsigned>(~crc));
  return text.data();
}

}  // namespace

std::optional<OnnxSignature> onnx_signature(std::string_view bytes) {
  std::string_view graph, checksum;
  Fields model(bytes);
  while (model.next()) {
    if (model.number() == model_field::kGraph) graph = model.bytes();
    if (model.number() == model_field::kMetadata &&
        field(model.bytes(), metadata_field::kKey) == kOnnxChecksum) {
      checksum = field(model.bytes(), metadata_field::kValue);
    }
  }
  if (!model.sound() || graph.empty()) return std::nullopt;
  if (!checksum.empty() && checksum != crc32_text(graph)) return std::nullopt;

  OnnxSignature signature;
  std::set<std::string_view> weights;
  Fields fields(graph);
  while (fields.next()) {
    if (fields.number() == graph_field::kInitializer) {
      if (!is_sound_tensor(fields.bytes())) return std::nullopt;
      weights.insert(field(fields.bytes(), initializer_field::kName));
    } else if (fields.number() == graph_field::kInput) {
      signature.inputs.push_back(tensor_of(fields.bytes()));
    } else if (fields.number() == graph_field::kOutput) {
      signature.outputs.push_back(tensor_of(fields.bytes()));
    }
  }
  if (!fields.sound()) return std::nullopt;
  std::erase_if(signature.inputs,
                [&](const OnnxTensor& input) { return weights.contains(input.name); });
  return signature;
}

}  // namespace gable
