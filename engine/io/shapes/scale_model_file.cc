#include <gable/engine/error.h>
#include <gable/engine/io/atomic_file.h>
#include <gable/engine/io/readable.h>
#include <gable/engine/io/shapes/scale_model_file.h>
#include <glog/logging.h>

#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <type_traits>
#include <vector>

namespace gable {
namespace {

constexpr std::string_view kFormat = "gable scales ";
constexpr std::string_view kHeader = "gable scales 1\n";
constexpr uint8_t kLeaf = 255;

uint32_t crc32(std::string_view bytes) {
  uint32_t crc = ~0u;
  for (const char c : bytes) {
    crc ^= static_cast<uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (crc & 1 ? 0xEDB88320u : 0u);
  }
  return ~crc;
}

template <typename Number>
using Bits = std::conditional_t<
    sizeof(Number) == 8, uint64_t,
    std::conditional_t<sizeof(Number) == 4, uint32_t,
                       std::conditional_t<sizeof(Number) == 2, uint16_t, uint8_t>>>;

template <typename Number>
void append(Number number, std::string* bytes) {
  const auto bits = std::bit_cast<Bits<Number>>(number);
  for (size_t i = 0; i < sizeof(bits); ++i) {
    bytes->push_back(static_cast<char>(static_cast<uint64_t>(bits) >> (8 * i)));
  }
}

// Reads numbers off the front of what is left of a file.
class Bytes {
 public:
  Bytes(std::string_view left, const std::string& path) : left_(left), path_(path) {}

  template <typename Number>
  Number number() {
    const std::string_view bytes = take(sizeof(Number));
    uint64_t bits = 0;
    for (size_t i = 0; i < bytes.size(); ++i) {
      bits |= static_cast<uint64_t>(static_cast<uint8_t>(bytes[i])) << (8 * i);
    }
    return std::bit_cast<Number>(static_cast<Bits<Number>>(bits));
  }

  std::string_view take(size_t count) {
    if (count > left_.size()) fail();
    const std::string_view out = left_.substr(0, count);
    left_.remove_prefix(count);
    return out;
  }

  bool empty() const { return left_.empty(); }

  [[noreturn]] void fail() const {
    throw Error(ExitCode::kBadInput,
                path_ + ": is damaged or cut short; copy the model again or train it anew");
  }

 private:
  std::string_view left_;
  const std::string& path_;
};

void read_tree(Bytes* bytes, int* num_leaves, Forest* forest) {
  forest->roots.push_back(static_cast<int>(forest->nodes.size()));
  std::vector<size_t> tests;  // whose right children are still to come
  while (true) {
    const auto feature = bytes->number<uint8_t>();
    if (feature != kLeaf) {
      tests.push_back(forest->nodes.size());
      forest->nodes.push_back({bytes->number<float>(), feature, 0});
      continue;
    }
    const std::string_view costs = bytes->take(forest->num_labels);
    forest->leaf_costs.insert(forest->leaf_costs.end(), costs.begin(), costs.end());
    forest->nodes.push_back({0.0f, -1, (*num_leaves)++});
    if (tests.empty()) return;
    forest->nodes[tests.back()].next = static_cast<int32_t>(forest->nodes.size());
    tests.pop_back();
  }
}

}  // namespace

std::string scale_model_bytes(const ScaleModel& model) {
  CHECK(check(model).empty()) << check(model);
  const Forest& forest = model.forest;
  std::string bytes(kHeader);
  append(static_cast<uint16_t>(model.name.size()), &bytes);
  bytes += model.name;
  append(model.gamma, &bytes);
  append(static_cast<uint8_t>(forest.num_labels), &bytes);
  append(static_cast<uint16_t>(forest.roots.size()), &bytes);
  // A sound forest holds its nodes and leaves in the order of the file.
  auto costs = forest.leaf_costs.begin();
  for (const ForestNode& node : forest.nodes) {
    if (node.feature >= 0) {
      append(static_cast<uint8_t>(node.feature), &bytes);
      append(node.threshold, &bytes);
    } else {
      append(kLeaf, &bytes);
      bytes.append(costs, costs + forest.num_labels);
      costs += forest.num_labels;
    }
  }
  append(crc32(bytes), &bytes);
  return bytes;
}

ScaleModel scale_model_from_bytes(std::string_view bytes, const std::string& path) {
  if (!bytes.starts_with(kFormat)) {
    throw Error(ExitCode::kBadInput,
                path + ": is not a scale model; give a file that gable shapes train wrote");
  }
  if (!bytes.starts_with(kHeader)) {
    // A header that is cut short is damage, not another version.
    if (bytes.size() < kHeader.size()) Bytes(bytes, path).fail();
    throw Error(ExitCode::kBadInput,
                path + ": is a scale model of another version; train it anew with this program");
  }
  if (bytes.size() < kHeader.size() + sizeof(uint32_t)) Bytes(bytes, path).fail();
  const std::string_view body = bytes.substr(0, bytes.size() - sizeof(uint32_t));
  Bytes left(body.substr(kHeader.size()), path);
  if (Bytes(bytes.substr(body.size()), path).number<uint32_t>() != crc32(body)) left.fail();
  ScaleModel model;
  model.name = left.take(left.number<uint16_t>());
  model.gamma = left.number<double>();
  model.forest.num_labels = left.number<uint8_t>();
  const int num_trees = left.number<uint16_t>();
  int num_leaves = 0;
  for (int tree = 0; tree < num_trees; ++tree) read_tree(&left, &num_leaves, &model.forest);
  if (!left.empty() || !check(model).empty()) left.fail();
  return model;
}

void write_scale_model(const ScaleModel& model, const std::string& path) {
  write_file_atomically(path, scale_model_bytes(model));
}

ScaleModel read_scale_model(const std::string& path) {
  require_readable(path);
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  return scale_model_from_bytes(bytes, path);
}

}  // namespace gable
