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
// The files hold fewer crops than the largest batch, to be small: they come over and over.
constexpr size_t kNumCrops = 32;

// Keeps the largest difference; what is no number counts as the largest of all.
void note(double difference, double* worst) {
  if (!(std::abs(difference) <= *worst)) {
    *worst = std::isnan(difference) ? INFINITY : std::abs(difference);
  }
}

template <typename T>
NpyArray<T> repeated(const NpyArray<T>& few) {
  NpyArray<T> many;
  many.shape = few.shape;
  many.shape[0] = kNumCrops;
  for (size_t i = 0; i < kNumCrops; ++i) {
    const T* row = few.row(i % few.shape[0]);
    many.values.insert(many.values.end(), row, row + few.row_size());
  }
  return many;
}

// The shipped networks against what PyTorch said of the same inputs, see training/detectors.
// Without networks or references the tests are skipped.
class DetectorParity : public testing::Test {
 protected:
  void SetUp() override {
    const std::filesystem::path source(GABLE_SOURCE_DIR);
    models_ = (source / "models/detectors").string();
    references_ = (source / "tests/engine/detectors").string() + "/";
    for (const char* net : {kHouseNet, kRoofNet, kAzimuthNet}) {
      if (!std::filesystem::exists(std::filesystem::path(models_) / net)) {
        GTEST_SKIP() << "no network " << net << " in " << models_;
      }
    }
    for (const char* name : {"house_inputs", "house_foundation", "house_maps", "roof_inputs",
                             "roof_outputs", "azimuth_inputs", "azimuth_outputs"}) {
      const std::string file = references_ + "parity_" + name + ".npy";
      if (!std::filesystem::exists(file)) GTEST_SKIP() << "no reference " << file;
    }
  }

  NpyArray<uint8_t> inputs(const std::string& net) const {
    return repeated(read_npy<uint8_t>(references_ + "parity_" + net + "_inputs.npy", "|u1"));
  }
  NpyArray<float> outputs(const std::string& name) const {
    return repeated(read_npy<float>(references_ + "parity_" + name + ".npy", "<f4"));
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

// Calls check(first, answers) for all batches of a size, answered by ask(batch).
template <typename Question, typename Ask, typename Check>
void in_batches(const std::vector<Question>& questions, size_t size, Ask ask, Check check) {
  for (size_t first = 0; first < questions.size(); first += size) {
    const size_t count = std::min(size, questions.size() - first);
    const auto answers = ask(std::span(questions).subspan(first, count));
    ASSERT_EQ(answers.size(), count);
    for (size_t i = 0; i < count; ++i) check(first + i, answers[i]);
  }
}

TEST_F(DetectorParity, FoundationsAndMapsAreThoseOfTheTrainingAtEveryBatchSize) {
  const std::vector<HouseCrop> crops = crops_of(inputs("house"));
  const NpyArray<float> foundation = outputs("house_foundation"), maps = outputs("house_maps");
  ASSERT_EQ(foundation.shape, (std::vector<size_t>{crops.size(), kNumFoundations}));
  ASSERT_EQ(maps.shape,
            (std::vector<size_t>{crops.size(), (kNumCropMaps * kCropPixels - 1) / kMapStride + 1}));
  DetectorNets nets(models_);
  for (const size_t batch : kBatches) {
    double worst = 0.0;
    in_batches(
        crops, batch, [&](std::span<const HouseCrop> some) { return nets.look(some); },
        [&](size_t i, const CropAnswer& answer) {
          for (int k = 0; k < kNumFoundations; ++k) {
            note(1.0 * answer.foundation[k] - foundation.row(i)[k], &worst);
          }
          for (size_t k = 0; k < maps.row_size(); ++k) {
            note(1.0 * answer.maps[k * kMapStride] - maps.row(i)[k], &worst);
          }
        });
    EXPECT_LT(worst, kTolerance) << "batch " << batch;
  }
}

TEST_F(DetectorParity, RoofTypesAreThoseOfTheTrainingAtEveryBatchSize) {
  const NpyArray<uint8_t> input = inputs("roof");
  const std::vector<HouseCrop> crops = crops_of(input);
  const NpyArray<float> expected = outputs("roof_outputs");
  ASSERT_EQ(expected.shape, (std::vector<size_t>{crops.size(), 3 * kNumRoofTypes}));
  std::vector<RoofQuestion> questions(crops.size());
  for (size_t i = 0; i < crops.size(); ++i) {
    questions[i].crop = &crops[i];
    const uint8_t* mask = input.row(i) + kCropChannels * kCropPixels;
    for (size_t pixel = 0; pixel < kCropPixels; ++pixel) {
      ASSERT_TRUE(mask[pixel] == 0 || mask[pixel] == 255);
      if (mask[pixel]) {
        questions[i].pixels.set(static_cast<int>(pixel / kCropSize),
                                static_cast<int>(pixel % kCropSize));
      }
    }
  }
  DetectorNets nets(models_);
  for (const size_t batch : kBatches) {
    double worst = 0.0;
    in_batches(
        questions, batch, [&](std::span<const RoofQuestion> some) { return nets.roofs(some); },
        [&](size_t i, const RoofAnswer& answer) {
          const float* row = expected.row(i);
          for (const auto* roof : {&answer.component, &answer.l_polygon, &answer.u_polygon}) {
            for (const float probability : *roof) {
              note(1.0 * probability - *row++, &worst);
            }
          }
        });
    EXPECT_LT(worst, kTolerance) << "batch " << batch;
  }
}

TEST_F(DetectorParity, AzimuthsAreThoseOfTheTrainingAtEveryBatchSize) {
  const std::vector<HouseCrop> crops = crops_of(inputs("azimuth"));
  const NpyArray<float> expected = outputs("azimuth_outputs");
  ASSERT_EQ(expected.shape, (std::vector<size_t>{crops.size(), 3 * kAzimuthBins}));
  DetectorNets nets(models_);
  for (const size_t batch : kBatches) {
    double worst = 0.0;
    in_batches(
        crops, batch, [&](std::span<const HouseCrop> some) { return nets.azimuths(some); },
        [&](size_t i, const AzimuthAnswer& answer) {
          for (size_t k = 0; k < answer.bins.size(); ++k) {
            note(1.0 * answer.bins[k] - expected.row(i)[k], &worst);
          }
        });
    EXPECT_LT(worst, kTolerance) << "batch " << batch;
  }
}

}  // namespace
}  // namespace gable
