#include <gable/engine/evaluate/evaluation_report.h>

#include <cmath>
#include <iomanip>
#include <sstream>

namespace gable {
namespace {

std::string metres(double value) {
  if (!std::isfinite(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << value << " m";
  return text.str();
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << 100.0 * share << " %";
  return text.str();
}

void write_error(const std::string& name, const HeightError& error, std::ostream& out) {
  out << std::left << std::setw(34) << name << "MAD " << metres(error.mad()) << ", RMSE "
      << metres(error.rmse()) << ", " << error.pixels() << " cells\n";
}

void write_detections(const std::string& name, const DetectionScore& score, std::ostream& out) {
  out << std::left << std::setw(34) << name << "precision " << percent(score.precision())
      << ", recall " << percent(score.recall()) << " (" << score.correct << " correct, "
      << score.found << " found, " << score.truth << " true)\n";
}

void write_confusion(const TruthSummary& summary, std::ostream& out) {
  out << "foundation: truth by row, found by column\n" << std::right << std::setw(7) << "";
  for (int column = 0; column < TruthSummary::kMissed; ++column) {
    out << std::setw(6) << foundation_name(static_cast<Foundation>(column));
  }
  out << "  missed\n";
  for (int row = 0; row < TruthSummary::kMissed; ++row) {
    int sum = 0;
    for (int n : summary.confusion[row]) sum += n;
    if (sum == 0) continue;
    out << std::setw(7) << foundation_name(static_cast<Foundation>(row));
    for (int column = 0; column < TruthSummary::kMissed; ++column) {
      out << std::setw(6) << summary.confusion[row][column];
    }
    out << std::setw(8) << summary.confusion[row][TruthSummary::kMissed] << '\n';
  }
}

void write_buildings(const Evaluation& evaluation, std::ostream& out) {
  out << "\nbuilding                     MAD      RMSE   cells  triangles  truth\n";
  for (const BuildingScore& score : evaluation.buildings) {
    out << std::left << std::setw(24) << score.id << std::right << std::setw(9)
        << metres(score.over_model.mad()) << ' ' << std::setw(9) << metres(score.over_model.rmse())
        << std::setw(8) << score.over_model.pixels() << std::setw(11)
        << (score.triangles ? std::to_string(*score.triangles) : "-") << "  "
        << (score.truth >= 0 ? evaluation.truth[score.truth].id : "-") << '\n';
  }
  if (evaluation.truth.empty()) return;
  out << "\ntruth                    type  found     IoU      MAD\n";
  for (const TruthScore& score : evaluation.truth) {
    out << std::left << std::setw(24) << score.id << std::right << std::setw(5)
        << foundation_name(score.foundation) << std::setw(7)
        << (score.match.building >= 0 ? foundation_name(score.found) : "-") << "  " << std::fixed
        << std::setprecision(3) << std::setw(6) << score.match.iou << std::setw(9)
        << metres(score.union_error.mad()) << '\n';
  }
}

}  // namespace

std::string evaluation_report(const Evaluation& evaluation, bool per_building) {
  std::ostringstream out;
  out << std::left << std::setw(34) << "buildings" << evaluation.buildings.size() << '\n';
  write_error("model to DSM, over the model", evaluation.over_model, out);
  if (evaluation.over_footprints) {
    write_error("model to DSM, over footprints", *evaluation.over_footprints, out);
  }
  if (evaluation.footprint_union) {
    write_error("model to DSM, over either", *evaluation.footprint_union, out);
  }
  if (evaluation.mean_triangles) {
    out << std::left << std::setw(34) << "triangles, mean" << std::fixed << std::setprecision(1)
        << *evaluation.mean_triangles << '\n';
  }
  if (evaluation.summary) {
    const TruthSummary& summary = *evaluation.summary;
    out << std::left << std::setw(34) << "truth buildings" << evaluation.truth.size() << ", "
        << summary.matched << " matched, " << evaluation.truth.size() - summary.matched
        << " missed; " << summary.invented << " invented\n";
    write_error("model to DSM, over the union", summary.union_error, out);
    out << std::left << std::setw(34) << "model to truth, per house"
        << "median MAD " << metres(summary.median_mad) << ", " << percent(summary.share_good)
        << " below " << metres(evaluation.options.good_mad) << '\n'
        << std::setw(34) << "footprint IoU, mean" << std::fixed << std::setprecision(3)
        << summary.mean_iou << '\n'
        << std::setw(34) << "foundation type" << percent(summary.foundation_accuracy) << " right\n";
    write_detections("dormers", summary.dormers, out);
    write_detections("chimneys", summary.chimneys, out);
    write_confusion(summary, out);
  }
  if (per_building) write_buildings(evaluation, out);
  return out.str();
}

}  // namespace gable
