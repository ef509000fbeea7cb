#include <gable/engine/drawing/fixed.h>
#include <gable/engine/drawing/html_escaped.h>
#include <gable/engine/drawing/page_style.h>
#include <gable/engine/scales/report/scales_page.h>

#include <algorithm>
#include <cmath>

namespace gable {
namespace {

constexpr const char* kScalesStyle = R"css(
.scales { display: grid; gap: 16px; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); }
.swatch { display: inline-block; width: 0.8em; height: 0.8em; border-radius: 50%; margin-right: 0.5em; }
.table th { padding: 8px 12px; font-weight: 600; }
.table th.number { text-align: right; }
)css";

constexpr const char* kNone = "&ndash;";

std::string percent(double share, int decimals) { return fixed(100.0 * share, decimals); }

std::string degrees(double angle) { return std::isfinite(angle) ? fixed(angle, 2) : kNone; }

std::string swatch(const ScaleEntry& entry) {
  return "<span class=\"swatch\" style=\"background:" + entry.color + "\"></span>";
}

std::string figure(const std::string& picture, const std::string& alt, const std::string& caption) {
  const std::string path = html_escaped(picture);
  return "<figure><a href=\"" + path + "\"><img src=\"" + path + "\" alt=\"" + html_escaped(alt) +
         "\"></a>\n<figcaption>" + caption + "</figcaption></figure>\n";
}

bool has_angles(const std::vector<ScaleEntry>& entries) {
  return std::any_of(entries.begin(), entries.end(), [](const ScaleEntry& entry) {
    return std::isfinite(entry.angle_before) || std::isfinite(entry.angle_after);
  });
}

std::string table(const std::vector<ScaleEntry>& entries) {
  const bool angles = has_angles(entries);
  const auto head = [](const char* name) {
    return std::string("<th class=\"number\">") + name + "</th>";
  };
  const auto cell = [](const std::string& text) {
    return "<td class=\"number\">" + text + "</td>";
  };
  std::string html = "<section class=\"table\"><table>\n<thead><tr><th>scale</th>" +
                     head("planes") + head("coverage (%)") + head("RMS (m)") +
                     head("RMS (% of diagonal)") + head("configuration");
  if (angles) html += head("angles before refit (&deg;)") + head("after (&deg;)");
  html += "</tr></thead>\n<tbody>\n";
  for (const ScaleEntry& entry : entries) {
    html += "<tr><td>" + swatch(entry) + html_escaped(entry.name) + "</td>" +
            cell(std::to_string(entry.num_shapes)) + cell(percent(entry.coverage, 1)) +
            cell(fixed(entry.rms, 3)) + cell(percent(entry.rms_share, 3)) +
            cell(std::to_string(entry.configuration));
    if (angles) html += cell(degrees(entry.angle_before)) + cell(degrees(entry.angle_after));
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table></section>\n";
}

}  // namespace

std::string scales_page(const ScalesSummary& summary, const std::vector<ScaleEntry>& entries) {
  const std::string title = html_escaped(summary.title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<title>gable: planar shapes of " +
      title + "</title>\n<style>" + kPageStyle + kScalesStyle +
      "</style>\n</head>\n<body>\n<main>\n<h1>Planar shapes at structural scales: " + title +
      "</h1>\n<div class=\"scales\">\n";
  html += figure(summary.picture, "The scan",
                 "<b>Input</b> <span class=\"figures\">" + html_escaped(summary.elements) +
                     ", diagonal " + fixed(summary.diagonal, 2) + " m</span>");
  for (const ScaleEntry& entry : entries) {
    const std::string name = html_escaped(entry.name);
    html += figure(entry.picture, "Planar shapes at " + entry.name,
                   swatch(entry) + "<b>" + name + "</b> <span class=\"figures\">" +
                       std::to_string(entry.num_shapes) +
                       (entry.num_shapes == 1 ? " plane" : " planes") + ", coverage " +
                       percent(entry.coverage, 1) + " %, RMS " + fixed(entry.rms, 3) + " m (" +
                       percent(entry.rms_share, 3) + " % of the diagonal)</span>");
  }
  html += "</div>\n<h2>Figures</h2>\n" + table(entries);
  html += "<h2>Trajectory</h2>\n";
  html += figure(summary.strip, "The labelled trajectory",
                 "<span class=\"figures\">From " + std::to_string(summary.num_first_shapes) +
                     " first shapes on the left, one merge after the other; the colour says which "
                     "scale a configuration belongs to, grey that it belongs to none. A scale is "
                     "shown by its first configuration, at its number.</span>");
  html +=
      "<p class=\"note\">Coverage: the share of the input (of a mesh: of its area) that the planes "
      "hold. RMS: root mean square distance of what they hold to them. A shape keeps its colour "
      "from scale to scale: where shapes merge, that of the largest stays.</p>\n";
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace gable
