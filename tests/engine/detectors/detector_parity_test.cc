#include <gable/engine/detectors/detector_nets.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>
#include <string>

#include "engine/npy.h"

namespace gable {
namespace {

constexpr double kTolerance = 1e-4;
constexpr size_t kBatches[] = {1, 5, 32};
constexpr size_t kMapStride = 97;

// The shipped networks against what PyTorch said of the same crops, as training/detectors/
// write_parity.py writes it. Without networks or references the tests are skipped.
class DetectorParity : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path source(GABLE_SOURCE_DIR);
    models_ = (source / "models/detectors").string();
    references_ = (source / "tests/engine/detectors/parity_").string();
    for (const char* net : {kHouseNet, kRoofNet, kAzimuthNet}) {
      if (!std::filesystem::exists(std::filesystem::path(models_) / net)) {
        GTEST_SKIP() << "no network " << net << " in " << models_;
      }
    }
    for (const char* name :
         {"house_input", "house_foundation", "house_maps", "roof_input", "roof_roof_i",
          "roof_roof_l", "roof_roof_u", "azimuth_input", "azimuth_bins"}) {
      const std::string file = references_ + name + ".npy";
      if (!std::filesystem::exists(file)) GTEST_SKIP() << "no reference " << file;
    }
  }

  // n x channels x 64 x 64 bytes.
  NpyArray<uint8_t> input(const std::string& net, size_t channels) const {
    NpyArray<uint8_t> array = read_npy<uint8_t>(references_ + net + "_input.npy", "|u1");
    EXPECT_EQ(array.shape, (std::vector<size_t>{array.shape[0], channels, kCropSize, kCropSize}));
    return array;
  }

  // n x values.
  NpyArray<float> output(const std::string& name, size_t crops, size_t values) const {
    NpyArray<float> array = read_npy<float>(references_ + name + ".npy", "<f4");
    EXPECT_EQ(array.shape, (std::vector<size_t>{crops, values}));
    return array;
  }

  std::string models_, references_;
};

// The first four channels of every input.
std::vector<HouseCrop> crops_of(const NpyArray<uint8_t>& inputs) {
  std::vector<HouseCrop> crops(inputs.shape[0]);
  for (size_t i = 0; i < crops.size(); ++i) {
    std::copy_n(inputs.row(i), crops[i].channels.size(), crops[i].channels.begin());
  }
  return crops;
}

// Asks about batches of each size, the questions over and over until every one was in every size of
// batch, and calls check(number of the question, answer).
template <typename Question, typename Ask, typename Check>
void in_all_batches(const std::vector<Question>& questions, Ask ask, Check check) {
  for (const size_t size : kBatches) {
    for (size_t first = 0; first < questions.size(); first += size) {
      std::vector<Question> batch;
      for (size_t i = first; i < first + size; ++i)
        batch.push_back(questions[i % questions.size()]);
      const auto answers = ask(std::span<const Question>(batch));
      ASSERT_EQ(answers.size(), size);
      for (size_t i = 0; i < size; ++i) check((first + i) % questions.size(), answers[i]);
    }
  }
}

// The largest difference that was met.
class Worst {
 public:
  template <typename Values>
  void add(const Values& values, const float* expected, size_t stride = 1) {
    for (size_t k = 0; k * stride < values.size(); ++k) {
      const double difference = std::abs(1.0 * values[k * stride] - expected[k]);
      if (!(difference <= worst_)) worst_ = difference;  // also where it is no number
    }
  }
  double value() const { return worst_; }

 private:
  double worst_ = 0.0;
};

TEST_F(DetectorParity, FoundationsAndMapsAreThoseOfTheTrainingAtEveryBatchSize) {
  const std::vector<HouseCrop> crops = crops_of(input("house", kCropChannels));
  const NpyArray<float> foundation = output("house_foundation", crops.size(), kNumFoundations);
  const NpyArray<float> maps =
      output("house_maps", crops.size(), (kNumCropMaps * kCropPixels - 1) / kMapStride + 1);
  DetectorNets nets(models_);
  Worst worst;
  in_all_batches(
      crops, [&](std::span<const HouseCrop> some) { return nets.look(some); },
      [&](size_t i, const CropAnswer& answer) {
        worst.add(answer.foundation, foundation.row(i));
        worst.add(answer.maps, maps.row(i), kMapStride);
      });
  EXPECT_LT(worst.value(), kTolerance);
}

TEST_F(DetectorParity, RoofTypesAreThoseOfTheTrainingAtEveryBatchSize) {
  const NpyArray<uint8_t> inputs = input("roof", kCropChannels + 1);
  const std::vector<HouseCrop> crops = crops_of(inputs);
  std::vector<RoofQuestion> questions(crops.size());
  for (size_t i = 0; i < crops.size(); ++i) {
    questions[i].crop = &crops[i];
    const uint8_t* mask = inputs.row(i) + kCropChannels * kCropPixels;
    for (size_t pixel = 0; pixel < kCropPixels; ++pixel) {
      ASSERT_TRUE(mask[pixel] == 0 || mask[pixel] == 255);
      if (mask[pixel]) {
        questions[i].pixels.set(static_cast<int>(pixel / kCropSize),
                                static_cast<int>(pixel % kCropSize));
      }
    }
  }
  const NpyArray<float> component = output("roof_roof_i", crops.size(), kNumRoofTypes);
  const NpyArray<float> l_polygon = output("roof_roof_l", crops.size(), kNumRoofTypes);
  const NpyArray<float> u_polygon = output("roof_roof_u", crops.size(), kNumRoofTypes);
  DetectorNets nets(models_);
  Worst worst;
  in_all_batches(
      questions, [&](std::span<const RoofQuestion> some) { return nets.roofs(some); },
      [&](size_t i, const RoofAnswer& answer) {
        worst.add(answer.component, component.row(i));
        worst.add(answer.l_polygon, l_polygon.row(i));
        worst.add(answer.u_polygon, u_polygon.row(i));
      });
  EXPECT_LT(worst.value(), kTolerance);
}

TEST_F(DetectorParity, AzimuthsAreThoseOfTheTrainingAtEveryBatchSize) {
  const std::vector<HouseCrop> crops = crops_of(input("azimuth", kCropChannels));
  const NpyArray<float> bins = output("azimuth_bins", crops.size(), 3 * kAzimuthBins);
  DetectorNets nets(models_);
  Worst worst;
  in_all_batches(
      crops, [&](std::span<const HouseCrop> some) { return nets.azimuths(some); },
      [&](size_t i, const AzimuthAnswer& answer) { worst.add(answer.bins, bins.row(i)); });
  EXPECT_LT(worst.value(), kTolerance);
}

}  // namespace
}  // namespace gable
