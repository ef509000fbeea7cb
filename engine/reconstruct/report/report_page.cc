#include <gable/engine/drawing/fixed.h>
#include <gable/engine/drawing/html_escaped.h>
#include <gable/engine/drawing/page_style.h>
#include <gable/engine/reconstruct/report/mad_histogram.h>
#include <gable/engine/reconstruct/report/page_script.h>
#include <gable/engine/reconstruct/report/report_page.h>

#include <cmath>
#include <map>

namespace gable {
namespace {

constexpr double kBinWidth = 0.05;
constexpr size_t kBins = 21;

std::string meters(double value) { return std::isfinite(value) ? fixed(value, 2) : "&ndash;"; }

std::string anchor(const HouseEntry& entry) { return "house-" + std::to_string(entry.index); }

struct Column {
  const char* name;
  bool number;
};
constexpr Column kColumns[] = {{"building", false}, {"result", false}, {"foundation", false},
                               {"roofs", false},    {"dormers", true}, {"chimneys", true},
                               {"garages", true},   {"MAD (m)", true}, {"RMSE (m)", true},
                               {"time (ms)", true}, {"note", false}};

std::string row(const HouseEntry& entry) {
  const auto number = [](const std::string& text) {
    return "<td class=\"number\">" + text + "</td>";
  };
  std::string html = "<tr data-house=\"" + anchor(entry) + "\"><td><a href=\"#" + anchor(entry) +
                     "\">" + html_escaped(entry.id) + "</a></td>";
  html += "<td class=\"" + entry.status + "\">" + entry.status + "</td>";
  html += "<td>" + entry.foundation + "</td><td>" + entry.roofs + "</td>";
  html += number(std::to_string(entry.dormers)) + number(std::to_string(entry.chimneys)) +
          number(std::to_string(entry.garages));
  html += number(meters(entry.quality.mad)) + number(meters(entry.quality.rmse));
  html += number(entry.quality.time_ms < 0.0 ? "&ndash;" : fixed(entry.quality.time_ms, 1));
  return html + "<td class=\"reason\">" + html_escaped(entry.reason) + "</td></tr>\n";
}

std::string figure(const HouseEntry& entry) {
  const std::string picture = html_escaped(entry.picture), id = html_escaped(entry.id);
  std::string html = "<figure id=\"" + anchor(entry) + "\"><a href=\"" + picture +
                     "\"><img loading=\"lazy\" src=\"" + picture +
                     "\" alt=\"Heights, model, residual and parts of " + id +
                     "\"></a>\n<figcaption><b>" + id + "</b> <span class=\"figures\">" +
                     entry.status + ", foundation " + entry.foundation + ", MAD " +
                     meters(entry.quality.mad) + " m</span>";
  if (!entry.reason.empty()) {
    html += "<br><span class=\"extrusion\">" + html_escaped(entry.reason) + "</span>";
  }
  return html + "</figcaption></figure>\n";
}

std::string counts(const char* head, const std::map<std::string, size_t>& counts) {
  std::string html = std::string("<dt class=\"head\">") + head + "</dt>";
  for (const auto& [name, count] : counts) {
    html += "<dt>" + name + "</dt><dd>" + std::to_string(count) + "</dd>";
  }
  return html;
}

std::string summary(const std::vector<HouseEntry>& entries) {
  std::map<std::string, size_t> by_status, by_foundation;
  std::vector<double> mads;
  double sum = 0.0;
  for (const HouseEntry& entry : entries) {
    ++by_status[entry.status];
    ++by_foundation[entry.foundation];
    if (std::isfinite(entry.quality.mad)) {
      mads.push_back(entry.quality.mad);
      sum += entry.quality.mad;
    }
  }
  const double middle = median(mads);
  const double mean = mads.empty() ? NAN : sum / static_cast<double>(mads.size());
  std::string html = "<section class=\"summary\">\n<dl><dt class=\"head\">Buildings</dt>";
  html += "<dt>all</dt><dd>" + std::to_string(entries.size()) + "</dd>";
  html += "<dt>median MAD</dt><dd>" + meters(middle) + " m</dd>";
  html += "<dt>mean MAD</dt><dd>" + meters(mean) + " m</dd></dl>\n";
  html += "<dl>" + counts("Result", by_status) + "</dl>\n";
  html += "<dl>" + counts("Foundation", by_foundation) + "</dl>\n";
  return html + histogram_svg(make_histogram(mads, kBinWidth, kBins), middle) + "</section>\n";
}

}  // namespace

std::string report_page(const std::vector<HouseEntry>& entries) {
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>gable: " +
      std::to_string(entries.size()) + " buildings</title>\n<style>" + kPageStyle +
      "</style>\n</head>\n<body>\n<main>\n<h1>House models from heights</h1>\n";
  html += summary(entries);
  html += "<h2>Figures</h2>\n<section class=\"table\"><table>\n<thead><tr>";
  for (const Column& column : kColumns) {
    html += std::string("<th") + (column.number ? " class=\"number\"" : "") +
            "><button type=\"button\">" + column.name + "</button></th>";
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const HouseEntry& entry : entries) html += row(entry);
  html += "</tbody>\n</table></section>\n<h2>Pictures</h2>\n";
  html +=
      "<p class=\"note\">North is up. Heights and differences are in metres. Difference: blue "
      "where "
      "the measurement lies below the model, red where above, grey where there is none. MAD and "
      "RMSE "
      "are the mean absolute and the root mean square difference over the building's pixels. "
      "Clicking a column of the table orders the pictures as well.</p>\n<div class=\"houses\">\n";
  for (const HouseEntry& entry : entries) html += figure(entry);
  return html + "</div>\n</main>\n<script>" + kPageScript + "</script>\n</body>\n</html>\n";
}

}  // namespace gable
