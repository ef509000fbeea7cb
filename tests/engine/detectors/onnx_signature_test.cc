#include <gable/engine/detectors/onnx_signature.h>
#include <gtest/gtest.h>

#include "engine/detectors/tiny_onnx.h"

namespace gable {
namespace {

TEST(OnnxSignature, NamesInputsAndOutputsWithTheirSizes) {
  const auto signature = onnx_signature(tiny_house_net());
  ASSERT_TRUE(signature);
  ASSERT_EQ(signature->inputs.size(), 1u);
  EXPECT_EQ(signature->inputs[0].name, "crop");
  EXPECT_EQ(signature->inputs[0].dims, (std::vector<int64_t>{-1, 4, 64, 64}));
  ASSERT_EQ(signature->outputs.size(), 2u);
  EXPECT_EQ(signature->outputs[0].name, "foundation");
  EXPECT_EQ(signature->outputs[0].dims, (std::vector<int64_t>{-1, 6}));
  EXPECT_EQ(signature->outputs[1].name, "maps");
  EXPECT_EQ(signature->outputs[1].dims, (std::vector<int64_t>{-1, 23, 64, 64}));
}

TEST(OnnxSignature, WeightsThatAreListedAmongTheInputsAreNone) {
  TinyOnnx net = tiny_house();
  net.add_input("maps weights", {23, 4, 1, 1});
  const auto signature = onnx_signature(net.bytes());
  ASSERT_TRUE(signature);
  ASSERT_EQ(signature->inputs.size(), 1u);
  EXPECT_EQ(signature->inputs[0].name, "crop");
}

TEST(OnnxSignature, AChecksumMustHold) {
  EXPECT_FALSE(onnx_signature(tiny_house().bytes("00000000")));
  EXPECT_FALSE(onnx_signature(tiny_house().bytes("no number")));
}

TEST(OnnxSignature, OtherBytesHaveNone) {
  EXPECT_FALSE(onnx_signature(""));
  EXPECT_FALSE(onnx_signature("P5 64 64 255"));
  EXPECT_FALSE(onnx_signature(std::string(200, '\xff')));
  EXPECT_FALSE(onnx_signature(std::string(200, '\0')));
}

TEST(OnnxSignature, NoDamageEndsAnywhereButInAnAnswer) {
  const std::string whole = tiny_roof_net();
  Random random(2);
  int answers = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = whole;
    for (int k = random.integer(1, 8); k > 0; --k) {
      bytes[static_cast<size_t>(random.integer(0, static_cast<int>(whole.size()) - 1))] =
          static_cast<char>(random.integer(0, 255));
    }
    answers += onnx_signature(bytes).has_value();
  }
  EXPECT_GT(answers, 0);
  EXPECT_LT(answers, 3000);
}

}  // namespace
}  // namespace gable
