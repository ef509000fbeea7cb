#include <gable/engine/detectors/detector_nets.h>
#include <gable/grammar/random.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <thread>

#include "engine/detectors/tiny_onnx.h"
#include "engine/io/scratch.h"

namespace gable {
namespace {

// A folder with three tiny networks, any of which a test may damage.
class Nets : public testing::Test {
 protected:
  Nets() {
    scratch_.write(kHouseNet, tiny_house_net());
    scratch_.write(kRoofNet, tiny_roof_net());
    scratch_.write(kAzimuthNet, tiny_azimuth_net());
  }

  // What the constructor says once the house network is replaced by these bytes.
  Error damaged(const std::string& bytes) {
    scratch_.write(kHouseNet, bytes);
    const Error error = error_of([this] { DetectorNets nets(folder()); }, kHouseNet);
    EXPECT_THAT(error.what(), testing::HasSubstr("GABLE_MODELS"));
    return error;
  }

  std::string folder() const { return scratch_.path(""); }

  ScratchFolder scratch_;
};

std::vector<HouseCrop> random_crops(int count, uint64_t seed) {
  Random random(seed);
  std::vector<HouseCrop> crops(count);
  for (HouseCrop& crop : crops) {
    const int level = random.integer(0, 200);
    for (uint8_t& value : crop.channels) {
      value = static_cast<uint8_t>(level + random.integer(0, 55));
    }
  }
  return crops;
}

std::vector<double> channel_means(const HouseCrop& crop) {
  std::vector<double> means(kCropChannels, 0.0);
  for (size_t i = 0; i < crop.channels.size(); ++i) {
    means[i / kCropPixels] += crop.channels[i] / static_cast<double>(kCropPixels);
  }
  return means;
}

std::vector<double> softmax(const TinyWeights& weights, const std::vector<double>& x) {
  std::vector<double> out;
  double sum = 0.0;
  for (int i = 0; i < weights.outputs; ++i) sum += std::exp(weights.apply(i, x));
  for (int i = 0; i < weights.outputs; ++i) out.push_back(std::exp(weights.apply(i, x)) / sum);
  return out;
}

TEST_F(Nets, AnswersAreThoseOfTheClosedForms) {
  DetectorNets nets(folder());
  const std::vector<HouseCrop> crops = random_crops(3, 8);
  const std::vector<CropAnswer> answers = nets.look(crops);
  const TinyWeights maps(kNumCropMaps, kCropChannels, kTinySeed + 1);
  for (size_t i = 0; i < crops.size(); ++i) {
    const std::vector<double> foundation =
        softmax(TinyWeights(kNumFoundations, kCropChannels, kTinySeed), channel_means(crops[i]));
    for (int k = 0; k < kNumFoundations; ++k) {
      EXPECT_NEAR(answers[i].foundation[k], foundation[k], 1e-5);
    }
    for (const int map : {0, 7, kNumCropMaps - 1}) {
      for (const size_t pixel : {size_t{0}, size_t{77}, kCropPixels - 1}) {
        std::vector<double> x;
        for (int c = 0; c < kCropChannels; ++c)
          x.push_back(crops[i].channels[c * kCropPixels + pixel]);
        EXPECT_NEAR(answers[i].map(map)[pixel], 1.0 / (1.0 + std::exp(-maps.apply(map, x))), 1e-5);
      }
    }
  }
}

TEST_F(Nets, RoofsSeeTheirPixelsAsAFifthChannel) {
  DetectorNets nets(folder());
  const HouseCrop crop = random_crops(1, 9).front();
  CropBits pixels;
  for (int row = 10; row < 30; ++row) pixels.set_row(row, 5, 41);
  std::vector<double> x = channel_means(crop);
  x.push_back(255.0 * pixels.count() / kCropPixels);
  const RoofAnswer answer = nets.roof(crop, pixels);
  const std::array<const RoofAnswer::Probabilities*, 3> roofs = {
      &answer.component, &answer.l_polygon, &answer.u_polygon};
  for (int r = 0; r < 3; ++r) {
    const std::vector<double> expected =
        softmax(TinyWeights(kNumRoofTypes, kCropChannels + 1, kTinySeed + 2 + r), x);
    for (int k = 0; k < kNumRoofTypes; ++k) EXPECT_NEAR((*roofs[r])[k], expected[k], 1e-5);
  }
  EXPECT_EQ(&answer.of(Foundation::kIII), &answer.component);
  EXPECT_EQ(&answer.of(Foundation::kL), &answer.l_polygon);
  EXPECT_EQ(&answer.of(Foundation::kU), &answer.u_polygon);
}

TEST_F(Nets, BatchingChangesNothing) {
  DetectorNets nets(folder());
  const std::vector<HouseCrop> crops = random_crops(70, 10);
  const std::vector<CropAnswer> together = nets.look(crops);
  std::vector<RoofQuestion> questions;
  for (const HouseCrop& crop : crops) {
    questions.push_back({&crop, {}});
    questions.back().pixels.set_row(static_cast<int>(questions.size()) % kCropSize, 0, kCropSize);
  }
  const std::vector<RoofAnswer> roofs = nets.roofs(questions);
  const std::vector<AzimuthAnswer> azimuths = nets.azimuths(crops);
  ASSERT_EQ(together.size(), crops.size());
  for (size_t i = 0; i < crops.size(); i += 3) {
    const CropAnswer alone = nets.look(crops[i]);
    double worst = 0.0;
    for (int k = 0; k < kNumFoundations; ++k) {
      worst = std::max(worst, std::abs(1.0 * alone.foundation[k] - together[i].foundation[k]));
    }
    for (size_t k = 0; k < alone.maps.size(); ++k) {
      worst = std::max(worst, std::abs(1.0 * alone.maps[k] - together[i].maps[k]));
    }
    const RoofAnswer roof = nets.roof(crops[i], questions[i].pixels);
    const AzimuthAnswer azimuth = nets.azimuth(crops[i]);
    for (int k = 0; k < kNumRoofTypes; ++k) {
      worst = std::max(worst, std::abs(1.0 * roof.u_polygon[k] - roofs[i].u_polygon[k]));
    }
    for (size_t k = 0; k < azimuth.bins.size(); ++k) {
      worst = std::max(worst, std::abs(1.0 * azimuth.bins[k] - azimuths[i].bins[k]));
    }
    EXPECT_LT(worst, 1e-4) << i;
  }
  EXPECT_TRUE(nets.look(std::span<const HouseCrop>()).empty());
}

TEST_F(Nets, EveryThreadMayHaveItsOwn) {
  const std::vector<HouseCrop> crops = random_crops(4, 12);
  const std::vector<CropAnswer> expected = DetectorNets(folder()).look(crops);
  std::vector<std::vector<CropAnswer>> answers(4);
  std::vector<std::thread> threads;
  for (auto& mine : answers) {
    threads.emplace_back([&, this] { mine = DetectorNets(folder()).look(crops); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& mine : answers) {
    for (size_t i = 0; i < crops.size(); ++i) EXPECT_EQ(mine[i].maps, expected[i].maps);
  }
}

TEST_F(Nets, AMissingFileIsNamed) {
  for (const char* net : {kHouseNet, kRoofNet, kAzimuthNet}) {
    const std::string bytes = file_bytes(scratch_.path(net));
    std::filesystem::remove(scratch_.path(net));
    const Error error = error_of([this] { DetectorNets nets(folder()); }, net);
    EXPECT_EQ(error.code(), ExitCode::kNoInput);
    scratch_.write(net, bytes);
  }
  std::filesystem::remove(scratch_.path(kRoofNet));
  std::filesystem::create_directory(scratch_.path(kRoofNet));
  EXPECT_EQ(error_of([this] { DetectorNets nets(folder()); }, kRoofNet).code(), ExitCode::kNoInput);
}

TEST_F(Nets, AnEmptyFileIsNamed) { EXPECT_EQ(damaged("").code(), ExitCode::kBadInput); }

TEST_F(Nets, AFileCutAnywhereIsNamed) {
  const std::string whole = tiny_house_net();
  for (size_t size = 1; size < whole.size(); size += 1 + size / 40) {
    EXPECT_EQ(damaged(whole.substr(0, size)).code(), ExitCode::kBadInput) << size;
  }
  EXPECT_EQ(damaged(whole.substr(0, whole.size() - 1)).code(), ExitCode::kBadInput);
}

TEST_F(Nets, RandomBytesAndTextAreNamed) {
  Random random(3);
  for (int i = 0; i < 50; ++i) {
    std::string bytes(static_cast<size_t>(random.integer(1, 2000)), '\0');
    for (char& c : bytes) c = static_cast<char>(random.integer(0, 255));
    EXPECT_EQ(damaged(bytes).code(), ExitCode::kBadInput);
  }
  EXPECT_EQ(damaged("version https://git-lfs.github.com/spec/v1\noid sha256:12\n").code(),
            ExitCode::kBadInput);
}

// The checksum as zlib defines it, table by table: an independent way to the same number.
std::string checksum_of(const std::string& bytes) {
  std::array<uint32_t, 256> table;
  for (uint32_t i = 0; i < 256; ++i) {
    uint32_t value = i;
    for (int bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320u ^ (value >> 1) : value >> 1;
    table[i] = value;
  }
  uint32_t crc = ~0u;
  for (const char c : bytes) crc = table[(crc ^ static_cast<uint8_t>(c)) & 0xff] ^ (crc >> 8);
  std::ostringstream text;
  text << std::hex << std::setw(8) << std::setfill('0') << ~crc;
  return text.str();
}

TEST_F(Nets, TheChecksumIsThatOfZlib) { EXPECT_EQ(checksum_of("123456789"), "cbf43926"); }

TEST_F(Nets, AnyFlippedBitOfTheGraphIsNoticedByTheChecksum) {
  const TinyOnnx net = tiny_house();
  const std::string graph = net.graph_bytes();
  const std::string whole = net.bytes(checksum_of(graph));
  scratch_.write(kHouseNet, whole);
  DetectorNets nets(folder());
  const size_t start = whole.find(graph);
  ASSERT_NE(start, std::string::npos);
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    std::string bytes = whole;
    bytes[start + static_cast<size_t>(random.integer(0, static_cast<int>(graph.size()) - 1))] ^=
        static_cast<char>(1 << random.integer(0, 7));
    EXPECT_EQ(damaged(bytes).code(), ExitCode::kBadInput);
  }
}

TEST_F(Nets, WeightsOfAnotherSizeThanTheirShapeAreNoticed) {
  TinyOnnx net = tiny_house();
  net.add_weights("more weights", {3, 4}, std::vector<float>(11, 0.0f));
  EXPECT_THAT(damaged(net.bytes()).what(), testing::HasSubstr("damaged"));
}

TEST_F(Nets, ANetworkOfAnotherShapeIsToldWhatIsExpected) {
  EXPECT_THAT(damaged(tiny_house_net(22)).what(), testing::HasSubstr("maps n x 23 x 64 x 64"));
  damaged(tiny_house_net(23, "type"));
  damaged(tiny_roof_net());
  damaged(tiny_azimuth_net());
}

TEST_F(Nets, WeightsThatAreNoNumbersAreNoticed) {
  std::string bytes = tiny_house_net();
  const float weight = TinyWeights(6, 4, kTinySeed).values[5];
  std::string raw(sizeof weight, '\0');
  std::memcpy(raw.data(), &weight, sizeof weight);
  const size_t at = bytes.find(raw);
  ASSERT_NE(at, std::string::npos);
  const float nothing = std::nanf("");
  std::memcpy(bytes.data() + at, &nothing, sizeof nothing);
  EXPECT_THAT(damaged(bytes).what(), testing::HasSubstr("weights are damaged"));
}

TEST(AzimuthAnswer, IsTheAngleOfTheMostProbableBin) {
  for (int bin = 0; bin < kAzimuthBins; ++bin) {
    for (const double off : {-0.09, 0.0, 0.05}) {
      AzimuthAnswer answer;
      answer.bins[bin] = 1.0f;
      answer.bins[kAzimuthBins + bin] = static_cast<float>(std::cos(4.0 * off));
      answer.bins[2 * kAzimuthBins + bin] = static_cast<float>(std::sin(4.0 * off));
      const double center = (bin + 0.5) * M_PI / 16.0;
      EXPECT_NEAR(answer.angle(), center + off, 1e-6);
      EXPECT_NEAR(answer.confidence(), 1.0, 1e-6);
    }
  }
}

TEST(AzimuthAnswer, StaysWithinAQuarterTurn) {
  AzimuthAnswer answer;
  answer.bins[0] = 1.0f;
  const double off = -M_PI / 32.0 - 0.02;  // before the first bin's start, from where it wraps
  answer.bins[kAzimuthBins] = static_cast<float>(std::cos(4.0 * off));
  answer.bins[2 * kAzimuthBins] = static_cast<float>(std::sin(4.0 * off));
  EXPECT_NEAR(answer.angle(), 0.5 * M_PI - 0.02, 1e-6);
}

TEST(AzimuthAnswer, IsConfidentWhereNeighbouringBinsAgreeAndNotWhereOppositeOnesCompete) {
  const auto answer_of = [](int other, double other_angle) {
    AzimuthAnswer answer;
    answer.bins[1] = answer.bins[other] = 0.5f;
    const auto set = [&](int bin, double angle) {
      const double off = angle - (bin + 0.5) * M_PI / 16.0;
      answer.bins[kAzimuthBins + bin] = static_cast<float>(std::cos(4.0 * off));
      answer.bins[2 * kAzimuthBins + bin] = static_cast<float>(std::sin(4.0 * off));
    };
    set(1, 2.0 * M_PI / 16.0);
    set(other, other_angle);
    return answer;
  };
  EXPECT_NEAR(answer_of(2, 2.0 * M_PI / 16.0).confidence(), 1.0, 1e-6);
  EXPECT_NEAR(answer_of(5, 6.0 * M_PI / 16.0).confidence(), 0.0, 1e-6);
}

}  // namespace
}  // namespace gable
