#include <gable/engine/drawing/fixed.h>
#include <gable/engine/evaluate/detectors/detector_scores.h>

#include <cmath>
#include <functional>

namespace gable {
namespace {

constexpr size_t kTaskWidth = 34;
constexpr size_t kColumnWidth = 16;

std::string padded(std::string text, size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string percent(double share) { return fixed(100.0 * share, 1) + " %"; }

/// What there is none of is not scored.
std::string share_of(const ClassScore& score) {
  return score.all > 0 ? percent(score.share()) : "-";
}

std::string mean_of(const MeanScore& score) {
  return score.count > 0 ? fixed(score.mean(), 3) : "-";
}

std::string both_of(const DetectionScore& score) {
  if (score.truth == 0) return score.found == 0 ? "-" : std::to_string(score.found) + " false";
  return percent(score.precision()) + ", " + percent(score.recall());
}

struct Line {
  const char* task;
  const char* paper;
  std::function<std::string(const DetectorScores&)> figure;
};

const char* name_of(size_t foundation) {
  constexpr const char* kNames[] = {"I", "II", "III", "L", "U", "C"};
  return kNames[foundation];
}

std::string confusion_text(const ScoreColumn& column) {
  std::string text =
      "\nConfusion of foundations, " + column.title + " (rows: truth, columns: answer)\n";
  text += padded("", 6);
  for (size_t i = 0; i < kNumFoundations; ++i) text += padded(name_of(i), 7);
  text += "houses\n";
  for (size_t i = 0; i < kNumFoundations; ++i) {
    int all = 0;
    for (const int count : column.scores->confusion[i]) all += count;
    text += padded(name_of(i), 6);
    for (const int count : column.scores->confusion[i]) {
      text += padded(all > 0 ? fixed(static_cast<double>(count) / all, 3) : "-", 7);
    }
    text += std::to_string(all) + "\n";
  }
  return text;
}

}  // namespace

std::string score_table(std::span<const ScoreColumn> columns) {
  const auto iou = [](size_t i) {
    return [i](const DetectorScores& s) { return mean_of(s.foundation_iou[i]); };
  };
  const auto roof = [](size_t i) {
    return [i](const DetectorScores& s) { return share_of(s.roofs[i]); };
  };
  const Line lines[] = {
      {"houses", "1,070", [](const DetectorScores& s) { return std::to_string(s.houses()); }},
      {"foundation type", "89.2 %",
       [](const DetectorScores& s) { return percent(s.foundation_accuracy()); }},
      {"roof type, I components", "85.0 %", roof(0)},
      {"roof type, L", "89.7 %", roof(1)},
      {"roof type, U", "66.0 %", roof(2)},
      {"foundation IoU, I", "0.831", iou(0)},
      {"foundation IoU, II", "0.797", iou(1)},
      {"foundation IoU, III", "0.795", iou(2)},
      {"foundation IoU, L", "0.779", iou(3)},
      {"foundation IoU, U", "0.838", iou(4)},
      {"dormers, precision and recall", "77 %, 84 %",
       [](const DetectorScores& s) { return both_of(s.dormers); }},
      {"chimneys, precision and recall", "81 %, 84 %",
       [](const DetectorScores& s) { return both_of(s.chimneys); }},
      {"garage IoU", "0.582", [](const DetectorScores& s) { return mean_of(s.garage_iou); }},
      {"azimuth, median error", "-",
       [](const DetectorScores& s) {
         return s.azimuth_errors.empty()
                    ? std::string("-")
                    : fixed(s.median_azimuth_error() * 180.0 / M_PI, 2) + " degrees";
       }},
  };
  std::string text = padded("task", kTaskWidth) + padded("paper, test", kColumnWidth);
  for (const ScoreColumn& column : columns) text += padded(column.title, kColumnWidth);
  text += "\n";
  for (const Line& line : lines) {
    text += padded(line.task, kTaskWidth) + padded(line.paper, kColumnWidth);
    for (const ScoreColumn& column : columns) {
      text += padded(line.figure(*column.scores), kColumnWidth);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  for (const ScoreColumn& column : columns) text += confusion_text(column);
  return text;
}

}  // namespace gable
