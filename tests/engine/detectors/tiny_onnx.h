#pragma once

#include <gable/grammar/random.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace gable {

/// Writes ONNX models (opset 11) of a handful of nodes, byte by byte, for tests of what reads them.
class TinyOnnx {
 public:
  /// A size of -1 is open.
  void add_input(const std::string& name, const std::vector<int64_t>& dims) {
    add_bytes(11, value_info(name, dims), &graph_);
  }
  void add_output(const std::string& name, const std::vector<int64_t>& dims) {
    add_bytes(12, value_info(name, dims), &graph_);
  }

  void add_weights(const std::string& name, const std::vector<int64_t>& dims,
                   const std::vector<float>& values) {
    std::string tensor;
    for (const int64_t size : dims) add_varint(1, static_cast<uint64_t>(size), &tensor);
    add_varint(2, 1, &tensor);  // floats
    add_bytes(8, name, &tensor);
    std::string raw(values.size() * sizeof(float), '\0');
    std::memcpy(raw.data(), values.data(), raw.size());
    add_bytes(9, raw, &tensor);
    add_bytes(5, tensor, &graph_);
  }

  /// By name; one value is an integer, more are a list.
  using Integers = std::vector<std::pair<std::string, std::vector<int64_t>>>;
  void add_node(const std::string& op, const std::vector<std::string>& inputs,
                const std::string& output, const Integers& attributes = {}) {
    std::string node;
    for (const std::string& input : inputs) add_bytes(1, input, &node);
    add_bytes(2, output, &node);
    add_bytes(3, "make " + output, &node);
    add_bytes(4, op, &node);
    for (const auto& [name, values] : attributes) {
      const bool list = values.size() > 1;
      std::string attribute;
      add_bytes(1, name, &attribute);
      for (const int64_t value : values) {
        add_varint(list ? 8 : 3, static_cast<uint64_t>(value), &attribute);
      }
      add_varint(20, list ? 7 : 2, &attribute);
      add_bytes(5, attribute, &node);
    }
    add_bytes(1, node, &graph_);
  }

  /// With `checksum` in the metadata, where one is given.
  std::string bytes(const std::string& checksum = "") const {
    std::string opset, model;
    const std::string graph = graph_bytes();
    add_varint(2, 11, &opset);
    add_varint(1, 6, &model);  // version of the format
    add_bytes(7, graph, &model);
    add_bytes(8, opset, &model);
    if (!checksum.empty()) {
      std::string entry;
      add_bytes(1, "graph_crc32", &entry);
      add_bytes(2, checksum, &entry);
      add_bytes(14, entry, &model);
    }
    return model;
  }

  std::string graph_bytes() const {
    std::string graph = graph_;
    add_bytes(2, "tiny", &graph);
    return graph;
  }

 private:
  static void add_varint(uint64_t value, std::string* out) {
    for (; value >= 0x80; value >>= 7) out->push_back(static_cast<char>(value | 0x80));
    out->push_back(static_cast<char>(value));
  }
  static void add_varint(uint64_t field, uint64_t value, std::string* out) {
    add_varint(field << 3, out);
    add_varint(value, out);
  }
  static void add_bytes(uint64_t field, const std::string& bytes, std::string* out) {
    add_varint(field << 3 | 2, out);
    add_varint(bytes.size(), out);
    *out += bytes;
  }
  static std::string value_info(const std::string& name, const std::vector<int64_t>& dims) {
    std::string shape, tensor, type, info;
    for (const int64_t size : dims) {
      std::string dimension;
      if (size < 0) {
        add_bytes(2, "n", &dimension);
      } else {
        add_varint(1, static_cast<uint64_t>(size), &dimension);
      }
      add_bytes(1, dimension, &shape);
    }
    add_varint(1, 1, &tensor);  // floats
    add_bytes(2, shape, &tensor);
    add_bytes(1, tensor, &type);
    add_bytes(1, name, &info);
    add_bytes(2, type, &info);
    return info;
  }

  std::string graph_;
};

/// The weights of a tiny network: every output is a linear map of the channels' means (or of a
/// pixel's channels) with its own weights, small enough for channels in [0, 255].
struct TinyWeights {
  int outputs = 0;
  int channels = 0;
  std::vector<float> values;  ///< outputs x channels

  TinyWeights(int num_outputs, int num_channels, uint64_t seed)
      : outputs(num_outputs), channels(num_channels) {
    Random random(seed);
    for (int i = 0; i < outputs * channels; ++i) {
      values.push_back(static_cast<float>(random.uniform(-0.01, 0.01)));
    }
  }
  double apply(int output, const std::vector<double>& x) const {
    double sum = 0.0;
    for (int c = 0; c < channels; ++c) sum += 1.0 * values[output * channels + c] * x[c];
    return sum;
  }
};

/// A network with the interface of one of the detectors and closed forms for its answers:
/// probabilities are the softmax, other bins the tanh of a linear map of the channels' means; maps
/// are the sigmoid of a linear map of each pixel's channels.
inline constexpr uint64_t kTinySeed = 40;

namespace internal {

inline void add_crop(int channels, TinyOnnx* net) {
  net->add_input("crop", {-1, channels, 64, 64});
  net->add_node("GlobalAveragePool", {"crop"}, "pooled");
  net->add_node("Flatten", {"pooled"}, "means", {{"axis", {1}}});
}

inline void add_of_means(const std::string& op, const std::string& output,
                         const TinyWeights& weights, TinyOnnx* net) {
  net->add_weights(output + " weights", {weights.outputs, weights.channels}, weights.values);
  net->add_weights(output + " bias", {weights.outputs}, std::vector<float>(weights.outputs, 0.0f));
  net->add_node("Gemm", {"means", output + " weights", output + " bias"}, output + " logits",
                {{"transB", {1}}});
  net->add_node(op, {output + " logits"}, output,
                op == "Softmax" ? TinyOnnx::Integers{{"axis", {1}}} : TinyOnnx::Integers{});
}

}  // namespace internal

inline TinyOnnx tiny_house(int maps = 23, const char* foundation = "foundation") {
  TinyOnnx net;
  internal::add_crop(4, &net);
  internal::add_of_means("Softmax", foundation, TinyWeights(6, 4, kTinySeed), &net);
  const TinyWeights weights(maps, 4, kTinySeed + 1);
  net.add_weights("maps weights", {maps, 4, 1, 1}, weights.values);
  net.add_node("Conv", {"crop", "maps weights"}, "maps logits", {{"kernel_shape", {1, 1}}});
  net.add_node("Sigmoid", {"maps logits"}, "maps");
  net.add_output(foundation, {-1, 6});
  net.add_output("maps", {-1, maps, 64, 64});
  return net;
}

inline std::string tiny_house_net(int maps = 23, const char* foundation = "foundation") {
  return tiny_house(maps, foundation).bytes();
}

inline std::string tiny_roof_net() {
  TinyOnnx net;
  internal::add_crop(5, &net);
  uint64_t seed = kTinySeed + 2;
  for (const char* output : {"roof_i", "roof_l", "roof_u"}) {
    internal::add_of_means("Softmax", output, TinyWeights(3, 5, seed++), &net);
    net.add_output(output, {-1, 3});
  }
  return net.bytes();
}

inline std::string tiny_azimuth_net() {
  TinyOnnx net;
  internal::add_crop(4, &net);
  internal::add_of_means("Softmax", "probabilities", TinyWeights(8, 4, kTinySeed + 5), &net);
  internal::add_of_means("Tanh", "directions", TinyWeights(16, 4, kTinySeed + 6), &net);
  net.add_node("Concat", {"probabilities", "directions"}, "bins", {{"axis", {1}}});
  net.add_output("bins", {-1, 24});
  return net.bytes();
}

}  // namespace gable
