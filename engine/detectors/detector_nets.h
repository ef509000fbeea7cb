#pragma once

#include <gable/engine/detectors/crop_bits.h>
#include <gable/engine/detectors/crop_tasks.h>
#include <gable/engine/detectors/house_crop.h>
#include <gable/grammar/house.h>

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gable {

/// The networks' files in a folder of detectors, see docs/detectors.md.
inline constexpr char kHouseNet[] = "house.onnx";
inline constexpr char kRoofNet[] = "roof.onnx";
inline constexpr char kAzimuthNet[] = "azimuth.onnx";

/// The foundations that the networks tell apart, the paper's six: those before Foundation::kMany,
/// which is C to them.
inline constexpr int kNumFoundations = 6;

/// What house.onnx says of one crop.
struct CropAnswer {
  std::array<float, kNumFoundations> foundation{};  ///< probabilities, by Foundation
  std::vector<float> maps;  ///< kNumCropMaps x 64 x 64, in [0, 1], see crop_map

  std::span<const float> map(int index) const {
    return std::span(maps).subspan(static_cast<size_t>(index) * kCropPixels, kCropPixels);
  }
};

/// A roof to classify: the pixels of a component (I, II, III) or of a whole polygon (L, U).
struct RoofQuestion {
  const HouseCrop* crop = nullptr;  ///< not null
  CropBits pixels;
};

/// What roof.onnx says: probabilities by RoofType, of three classifiers.
struct RoofAnswer {
  using Probabilities = std::array<float, kNumRoofTypes>;
  Probabilities component{};  ///< if it is a component of an I, II or III
  Probabilities l_polygon{};  ///< if it is the polygon of an L
  Probabilities u_polygon{};  ///< if it is that of a U

  const Probabilities& of(Foundation foundation) const {
    if (foundation == Foundation::kL) return l_polygon;
    return foundation == Foundation::kU ? u_polygon : component;
  }
};

inline constexpr int kAzimuthBins = 8;

/// What azimuth.onnx says of a crop that is not rectified.
struct AzimuthAnswer {
  std::array<float, 3 * kAzimuthBins> bins{};  ///< as the network gives them

  /// The angle of the most probable bin, radians in [0, pi/2), anticlockwise from crop x.
  double angle() const;
  /// How well the bins agree: the length of the mean of the unit vectors at four times the angle of
  /// each, weighted by their probabilities. In [0, 1]; near 1 also between two bins that agree.
  double confidence() const;
};

/// The three networks of the detectors. An instance serves one thread at a time: give every worker
/// its own. OpenCV may use threads of its own inside; their number is the program's to choose
/// (cv::setNumThreads; 1 is best where workers run side by side). Answers do not depend on how
/// crops are batched, beyond 1e-4.
class DetectorNets {
 public:
  /// Loads house.onnx, roof.onnx and azimuth.onnx from a folder and tries them. Throws Error with
  /// one line that names the file and the remedy: kNoInput where one cannot be opened, kBadInput
  /// where one is empty, cut, no network, a network of other inputs or outputs, or one whose
  /// answers are no numbers or no probabilities.
  explicit DetectorNets(const std::string& folder);
  ~DetectorNets();
  DetectorNets(DetectorNets&&) noexcept;
  DetectorNets& operator=(DetectorNets&&) noexcept;

  /// Foundation and maps of rectified crops, in their order; any number of them, run in batches of
  /// at most 32. These and the following throw Error (kBadInput) where a network fails.
  std::vector<CropAnswer> look(std::span<const HouseCrop> crops);
  CropAnswer look(const HouseCrop& crop) { return look(std::span(&crop, 1)).front(); }

  /// Roof types of parts of rectified crops.
  std::vector<RoofAnswer> roofs(std::span<const RoofQuestion> questions);
  RoofAnswer roof(const HouseCrop& crop, const CropBits& pixels) {
    const RoofQuestion question{&crop, pixels};
    return roofs(std::span(&question, 1)).front();
  }

  /// Azimuths of crops that are not rectified, modulo a quarter turn, relative to the crop's own.
  std::vector<AzimuthAnswer> azimuths(std::span<const HouseCrop> crops);
  AzimuthAnswer azimuth(const HouseCrop& crop) { return azimuths(std::span(&crop, 1)).front(); }

 private:
  struct Nets;
  std::unique_ptr<Nets> nets_;
};

}  // namespace gable
