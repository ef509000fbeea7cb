#include <gable/engine/detectors/detector_nets.h>
#include <gable/engine/detectors/onnx_signature.h>
#include <gable/engine/error.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <utility>

namespace gable {
namespace {

constexpr size_t kMostBatch = 32;
constexpr char kInput[] = "crop";

// An output: its name and its shape for one crop.
struct OutputShape {
  const char* name;
  std::vector<int> shape;

  size_t size() const {
    size_t product = 1;
    for (const int n : shape) product *= static_cast<size_t>(n);
    return product;
  }
};

std::string shape_text(const OutputShape& output) {
  std::string text = std::string(output.name) + " n";
  for (const int n : output.shape) text += " x " + std::to_string(n);
  return text;
}

// OpenCV's importer logs what it then throws as well; the Error's line says it once. The level is
// OpenCV's and global, hence the lock.
class QuietOpenCv {
 public:
  QuietOpenCv() : lock_(mutex()) {
    namespace log = cv::utils::logging;
    level_ = log::setLogLevel(log::LOG_LEVEL_SILENT);
  }
  ~QuietOpenCv() { cv::utils::logging::setLogLevel(level_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex loading;
    return loading;
  }
  std::lock_guard<std::mutex> lock_;
  cv::utils::logging::LogLevel level_;
};

// One network: knows its file, its input and its outputs.
class Net {
 public:
  Net(const std::filesystem::path& file, int channels, std::vector<OutputShape> outputs)
      : file_(file.string()), channels_(channels), outputs_(std::move(outputs)) {
    const std::string bytes = read();
    check_signature(bytes);
    const QuietOpenCv quiet;
    try {
      net_ = cv::dnn::readNetFromONNX(bytes.data(), bytes.size());
      net_.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
      net_.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
    } catch (const cv::Exception& failure) {
      fail("no network that OpenCV can read (" + one_line(failure.err) + ")");
    } catch (const std::exception& failure) {
      fail(std::string("no network that OpenCV can read (") + failure.what() + ")");
    }
  }

  size_t input_size() const { return static_cast<size_t>(channels_) * kCropPixels; }

  // Runs a batch: `input` holds n x channels x 64 x 64 values. One matrix per output, n rows.
  std::vector<cv::Mat> run(std::vector<float>* input) {
    const int n = static_cast<int>(input->size() / input_size());
    const int sizes[] = {n, channels_, kCropSize, kCropSize};
    std::vector<cv::Mat> answers;
    try {
      net_.setInput(cv::Mat(4, sizes, CV_32F, input->data()), kInput);
      std::vector<cv::String> names;
      for (const OutputShape& output : outputs_) names.push_back(output.name);
      net_.forward(answers, names);
    } catch (const cv::Exception& failure) {
      fail("the network cannot be run (" + one_line(failure.err) + ")");
    } catch (const std::exception& failure) {
      fail(std::string("the network cannot be run (") + failure.what() + ")");
    }
    if (answers.size() != outputs_.size()) fail_of_shape();
    for (size_t i = 0; i < answers.size(); ++i) {
      std::vector<int> expected = {n};
      expected.insert(expected.end(), outputs_[i].shape.begin(), outputs_[i].shape.end());
      const cv::Mat& answer = answers[i];
      if (answer.type() != CV_32F || !answer.isContinuous() ||
          !std::equal(expected.begin(), expected.end(), answer.size.p,
                      answer.size.p + answer.dims)) {
        fail_of_shape();
      }
      // The network writes its next answer over this one.
      answers[i] = answer.clone().reshape(1, n);
    }
    return answers;
  }

  // Runs two unequal crops and checks that the first `probabilities` values of the named outputs
  // are probabilities and that all values lie within [low, 1] or so.
  void try_out(int probabilities, const std::vector<int>& of_outputs, float low) {
    const QuietOpenCv quiet;
    std::vector<float> crops(2 * input_size(), 128.0f);
    for (size_t i = 0; i < input_size(); ++i) crops[i] = static_cast<float>(i % 256);
    const std::vector<cv::Mat> answers = run(&crops);
    constexpr float kSlack = 1e-3f;
    for (size_t i = 0; i < answers.size(); ++i) {
      for (int row = 0; row < 2; ++row) {
        const float* values = answers[i].ptr<float>(row);
        for (int k = 0; k < answers[i].cols; ++k) {
          if (!(values[k] >= low - kSlack && values[k] <= 1.0f + kSlack)) fail_of_weights();
        }
        if (std::find(of_outputs.begin(), of_outputs.end(), static_cast<int>(i)) ==
            of_outputs.end()) {
          continue;
        }
        float sum = 0.0f;
        for (int k = 0; k < probabilities; ++k) {
          if (values[k] < -kSlack) fail_of_weights();
          sum += values[k];
        }
        if (!(std::abs(sum - 1.0f) < kSlack)) fail_of_weights();
      }
    }
  }

 private:
  [[noreturn]] void fail(const std::string& why, ExitCode code = ExitCode::kBadInput) const {
    throw Error(code, file_ + ": " + why +
                          "; install the detectors of this version of gable, or set GABLE_MODELS "
                          "to a folder that has them in detectors/");
  }

  [[noreturn]] void fail_of_shape() const {
    std::string expected;
    for (const OutputShape& output : outputs_) {
      expected += (expected.empty() ? "" : ", ") + shape_text(output);
    }
    fail("the network does not take crop n x " + std::to_string(channels_) + " x 64 x 64 to " +
         expected);
  }

  [[noreturn]] void fail_of_weights() const {
    fail("the network's answers are no probabilities, its weights are damaged");
  }

  static std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    return text;
  }

  std::string read() const {
    std::error_code none;
    std::ifstream stream(file_, std::ios::binary);
    if (!stream || std::filesystem::is_directory(file_, none)) {
      fail("cannot be opened", ExitCode::kNoInput);
    }
    std::string bytes(std::istreambuf_iterator<char>(stream), {});
    if (bytes.empty()) fail("is empty");
    return bytes;
  }

  void check_signature(const std::string& bytes) const {
    const std::optional<OnnxSignature> signature = onnx_signature(bytes);
    if (!signature) fail("no ONNX file, or one that is cut or damaged");
    const std::vector<int64_t> crop = {channels_, kCropSize, kCropSize};
    if (signature->inputs.size() != 1 || signature->inputs[0].name != kInput ||
        signature->inputs[0].dims.size() != 4 ||
        !std::equal(crop.begin(), crop.end(), signature->inputs[0].dims.begin() + 1) ||
        signature->outputs.size() != outputs_.size()) {
      fail_of_shape();
    }
    // The sizes of outputs may be left open in the file; those of real answers are checked.
    for (const OutputShape& output : outputs_) {
      if (std::none_of(signature->outputs.begin(), signature->outputs.end(),
                       [&](const OnnxTensor& tensor) { return tensor.name == output.name; })) {
        fail_of_shape();
      }
    }
  }

  std::string file_;
  int channels_;
  std::vector<OutputShape> outputs_;
  cv::dnn::Net net_;
};

template <typename Values>
void copy_row(const cv::Mat& answers, int row, Values* values) {
  const float* first = answers.ptr<float>(row);
  std::copy(first, first + answers.cols, values->begin());
}

// Calls run(first, last) for batches that cover [0, count).
template <typename Run>
void for_batches(size_t count, Run run) {
  for (size_t first = 0; first < count; first += kMostBatch) {
    run(first, std::min(first + kMostBatch, count));
  }
}

void append_channels(const HouseCrop& crop, std::vector<float>* input) {
  input->insert(input->end(), crop.channels.begin(), crop.channels.end());
}

// Radians, anticlockwise from crop x.
double bin_angle(const std::array<float, 3 * kAzimuthBins>& bins, int bin) {
  const double center = (bin + 0.5) * 0.5 * M_PI / kAzimuthBins;
  return center + 0.25 * std::atan2(bins[2 * kAzimuthBins + bin], bins[kAzimuthBins + bin]);
}

}  // namespace

struct DetectorNets::Nets {
  Net house, roof, azimuth;
};

DetectorNets::DetectorNets(const std::string& folder) {
  const std::filesystem::path in(folder);
  nets_ = std::make_unique<Nets>(Nets{
      Net(in / kHouseNet, kCropChannels,
          {{"foundation", {kNumFoundations}}, {"maps", {kNumCropMaps, kCropSize, kCropSize}}}),
      Net(in / kRoofNet, kCropChannels + 1,
          {{"roof_i", {kNumRoofTypes}}, {"roof_l", {kNumRoofTypes}}, {"roof_u", {kNumRoofTypes}}}),
      Net(in / kAzimuthNet, kCropChannels, {{"bins", {3 * kAzimuthBins}}})});
  nets_->house.try_out(kNumFoundations, {0}, 0.0f);
  nets_->roof.try_out(kNumRoofTypes, {0, 1, 2}, 0.0f);
  nets_->azimuth.try_out(kAzimuthBins, {0}, -1.0f);
}

DetectorNets::~DetectorNets() = default;
DetectorNets::DetectorNets(DetectorNets&&) noexcept = default;
DetectorNets& DetectorNets::operator=(DetectorNets&&) noexcept = default;

std::vector<CropAnswer> DetectorNets::look(std::span<const HouseCrop> crops) {
  std::vector<CropAnswer> out(crops.size());
  for_batches(crops.size(), [&](size_t first, size_t last) {
    std::vector<float> input;
    for (size_t i = first; i < last; ++i) append_channels(crops[i], &input);
    const std::vector<cv::Mat> answers = nets_->house.run(&input);
    for (size_t i = first; i < last; ++i) {
      const int row = static_cast<int>(i - first);
      copy_row(answers[0], row, &out[i].foundation);
      out[i].maps.resize(static_cast<size_t>(kNumCropMaps) * kCropPixels);
      copy_row(answers[1], row, &out[i].maps);
    }
  });
  return out;
}

std::vector<RoofAnswer> DetectorNets::roofs(std::span<const RoofQuestion> questions) {
  std::vector<RoofAnswer> out(questions.size());
  for_batches(questions.size(), [&](size_t first, size_t last) {
    std::vector<float> input;
    for (size_t i = first; i < last; ++i) {
      append_channels(*questions[i].crop, &input);
      for (int row = 0; row < kCropSize; ++row) {
        for (int col = 0; col < kCropSize; ++col) {
          input.push_back(questions[i].pixels.at(row, col) ? 255.0f : 0.0f);
        }
      }
    }
    const std::vector<cv::Mat> answers = nets_->roof.run(&input);
    for (size_t i = first; i < last; ++i) {
      const int row = static_cast<int>(i - first);
      copy_row(answers[0], row, &out[i].component);
      copy_row(answers[1], row, &out[i].l_polygon);
      copy_row(answers[2], row, &out[i].u_polygon);
    }
  });
  return out;
}

std::vector<AzimuthAnswer> DetectorNets::azimuths(std::span<const HouseCrop> crops) {
  std::vector<AzimuthAnswer> out(crops.size());
  for_batches(crops.size(), [&](size_t first, size_t last) {
    std::vector<float> input;
    for (size_t i = first; i < last; ++i) append_channels(crops[i], &input);
    const std::vector<cv::Mat> answers = nets_->azimuth.run(&input);
    for (size_t i = first; i < last; ++i) {
      copy_row(answers[0], static_cast<int>(i - first), &out[i].bins);
    }
  });
  return out;
}

double AzimuthAnswer::angle() const {
  const auto best = std::max_element(bins.begin(), bins.begin() + kAzimuthBins);
  const double angle = bin_angle(bins, static_cast<int>(best - bins.begin()));
  const double turns = angle / (0.5 * M_PI);
  const double wrapped = (turns - std::floor(turns)) * 0.5 * M_PI;
  return wrapped < 0.5 * M_PI ? wrapped : 0.0;
}

double AzimuthAnswer::confidence() const {
  std::complex<double> mean = 0.0;
  for (int bin = 0; bin < kAzimuthBins; ++bin) {
    mean += static_cast<double>(bins[bin]) * std::polar(1.0, 4.0 * bin_angle(bins, bin));
  }
  return std::min(1.0, std::abs(mean));
}

}  // namespace gable
