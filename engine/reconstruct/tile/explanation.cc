#include <gable/engine/reconstruct/tile/explanation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace gable {
namespace {

std::string decimals(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

std::string counted(size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text;
}

std::string foundation_of(const Candidate& candidate) {
  return std::string(foundation_name(candidate.house.foundation));
}

std::string roofs_of(const House& house) {
  std::vector<std::string> roofs;
  for (const Rule& roof : house.roofs) roofs.emplace_back(roof_name(roof.kind));
  return joined(roofs);
}

struct DetailCount {
  const char* name;
  size_t count;
};

std::array<DetailCount, 3> details_of(const House& house) {
  return {{{"dormer", house.dormers.size()},
           {"chimney", house.chimneys.size()},
           {"garage", house.garages.size()}}};
}

std::string details_text(const House& house) {
  std::vector<std::string> details;
  for (const DetailCount& detail : details_of(house)) {
    if (detail.count > 0) details.push_back(counted(detail.count, detail.name));
  }
  return details.empty() ? "none" : joined(details);
}

double parameters_price(const PenalisedCost& cost) {
  return cost.num_parameters * std::log(std::max(3, cost.num_samples));
}

/// S / sigma^2: what is left of J without the rest, since sigma depends on what is known of the
/// outline.
double data_term(const PenalisedCost& cost) {
  return std::max(0.0, cost.total - parameters_price(cost) - cost.prior);
}

std::string first_values_line(const HouseChoice& choice) {
  if (choice.first_values.empty()) return "  first values: none, so no house was fitted\n";
  return "  first values: " + std::to_string(choice.num_from(ValueSource::kClassical)) +
         " from the classical search, " + std::to_string(choice.num_from(ValueSource::kDetectors)) +
         " from the detectors, " + std::to_string(choice.num_from(ValueSource::kScales)) +
         " from the structural scales\n";
}

std::string probabilities_line(const HouseChoice& choice) {
  if (!choice.foundation) return "";
  std::vector<std::string> parts;
  for (int i = 0; i < kNumFoundations; ++i) {
    parts.push_back(std::string(foundation_name(static_cast<Foundation>(i))) + " " +
                    decimals((*choice.foundation)[i], 3));
  }
  return "  the detectors' probabilities of the foundation: " + joined(parts) + "\n";
}

/// Rows of cells below each other; the first `num_texts` columns are aligned left, others right.
std::string table_of(const std::vector<std::vector<std::string>>& rows, size_t num_texts) {
  std::vector<size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    text += "  ";
    for (size_t i = 0; i < row.size(); ++i) {
      const std::string blanks(widths[i] - row[i].size(), ' ');
      text += "  " + (i < num_texts ? row[i] + blanks : blanks + row[i]);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += "\n";
  }
  return text;
}

/// Hypotheses are counted from 1.
std::string hypothesis_text(const Candidate& c) {
  return c.hypothesis < 0 ? "-" : std::to_string(c.hypothesis + 1);
}

std::string finalists_table(const std::vector<Candidate>& finalists) {
  const PenalisedCost& first = finalists.front().cost;
  std::string head = "  finalists by J = S/sigma^2 + k ln N + charges, the least first; N = " +
                     std::to_string(first.num_samples) + " pixels";
  if (data_term(first) > 0.0) {
    head +=
        ", sigma = " + decimals(std::sqrt(first.squared_residuals / data_term(first)), 2) + " m";
  }
  std::vector<std::vector<std::string>> rows = {{"no.", "foundation", "roofs", "details", "source",
                                                 "hypothesis", "S/sigma^2", "k", "k ln N",
                                                 "charges", "J"}};
  for (const Candidate& c : finalists) {
    rows.push_back({std::to_string(rows.size()), foundation_of(c), roofs_of(c.house),
                    details_text(c.house), std::string(value_source_name(c.source)),
                    hypothesis_text(c), decimals(data_term(c.cost), 1),
                    std::to_string(c.cost.num_parameters), decimals(parameters_price(c.cost), 1),
                    decimals(c.cost.prior, 1), decimals(c.cost.total, 1)});
  }
  return head + "\n" + table_of(rows, 5);
}

std::string given_up_table(const HouseChoice& choice) {
  if (choice.given_up.empty()) return "";
  std::vector<std::vector<std::string>> rows = {
      {"hypothesis", "foundation", "roofs", "source", "given up", "J then"}};
  for (const Candidate& c : choice.given_up) {
    rows.push_back({hypothesis_text(c), foundation_of(c), roofs_of(c.house),
                    std::string(value_source_name(c.source)),
                    c.stage == ChoiceStage::kWide ? "wide stage" : "before details",
                    decimals(c.cost.total, 1)});
  }
  return "  given up, with J as it was then; in the wide stage it ranks among its like alone\n" +
         table_of(rows, 5);
}

std::string values_text(const Rule& rule) {
  const auto specs = parameter_specs(rule.kind);
  std::vector<std::string> values;
  for (size_t i = 0; i < specs.size(); ++i) {
    std::string value = std::string(specs[i].name) + " " + decimals(rule[static_cast<int>(i)], 2);
    if (specs[i].unit != "1") value += " " + std::string(specs[i].unit);
    values.push_back(value);
  }
  return joined(values);
}

std::string origins_table(const HouseChoice& choice, const Candidate& winner) {
  if (winner.hypothesis < 0 || winner.hypothesis >= choice.num_hypotheses()) return "";
  const FirstValue& first = choice.first_values[winner.hypothesis];
  std::string text = "  first values of no. 1: hypothesis " + hypothesis_text(winner) + ", " +
                     std::string(foundation_name(first.house.foundation)) + " from " +
                     std::string(value_source_name(first.source));
  if (first.house.foundation != winner.house.foundation) text += ", since rewritten";
  std::vector<std::vector<std::string>> rows;
  const auto rules = first.house.derivation();
  for (size_t i = 0; i < rules.size(); ++i) {
    rows.push_back({std::string(rule_name(rules[i]->kind)),
                    i < first.origins.size() ? first.origins[i] : "", values_text(*rules[i])});
  }
  return text + "\n" + table_of(rows, 3);
}

std::string lead_line(const std::vector<Candidate>& finalists) {
  const Candidate& winner = finalists.front();
  for (size_t i = 1; i < finalists.size(); ++i) {
    const Candidate& other = finalists[i];
    if (other.house.foundation == winner.house.foundation) continue;
    return "  lead: foundation " + foundation_of(winner) + " is " +
           decimals(other.cost.total - winner.cost.total, 1) + " ahead of " + foundation_of(other) +
           ", no. " + std::to_string(i + 1) + "\n";
  }
  return "  lead: no other foundation came so far as foundation " + foundation_of(winner) + "\n";
}

std::string afterwards_line(const Candidate& winner, const Candidate& best) {
  std::vector<std::string> changes;
  const auto before = details_of(winner.house), after = details_of(best.house);
  for (size_t i = 0; i < before.size(); ++i) {
    const size_t a = before[i].count, b = after[i].count;
    if (b > a) changes.push_back(counted(b - a, before[i].name) + " added");
    if (b < a) changes.push_back(counted(a - b, before[i].name) + " dropped");
  }
  const std::string roofs = roofs_of(best.house);
  if (roofs != roofs_of(winner.house)) changes.push_back("roofs now " + roofs);
  if (changes.empty()) changes.push_back("no more details");
  return "  afterwards: " + joined(changes) + "; refined once more, J " +
         decimals(winner.cost.total, 1) + " -> " + decimals(best.cost.total, 1) + " (S/sigma^2 " +
         decimals(data_term(best.cost), 1) + ", k " + std::to_string(best.cost.num_parameters) +
         ", charges " + decimals(best.cost.prior, 1) + ")\n";
}

std::string relation_text(const UsedRelation& relation) {
  const bool angle = relation.kind == NeighbourRelationKind::kEqualAzimuths;
  const auto number = [&](double misfit) {
    return angle ? decimals(misfit * 180.0 / M_PI, 1) : decimals(misfit, 2);
  };
  std::string text;
  switch (relation.kind) {
    case NeighbourRelationKind::kPartyWall:
      text = "party wall with ";
      break;
    case NeighbourRelationKind::kEqualEaves:
      text = "eaves equal to ";
      break;
    case NeighbourRelationKind::kEqualRidges:
      text = "ridge equal to ";
      break;
    default:
      text = "azimuth equal to ";
  }
  return text + relation.neighbour + " (" + number(relation.before) + " -> " +
         number(relation.after) + (angle ? " degrees)" : " m)");
}

std::string relations_line(const std::vector<UsedRelation>& relations) {
  if (relations.empty()) return "";
  std::vector<std::string> texts;
  for (const UsedRelation& relation : relations) texts.push_back(relation_text(relation));
  return "  refined together with its neighbours: " + joined(texts) + "\n";
}

std::string outcome_line(const Building& building) {
  const bool house = building.status == BuildingStatus::kGrammar && building.house;
  std::string line = "  outcome: ";
  if (house) {
    line += "a house of the grammar, foundation " +
            std::string(foundation_name(building.house->foundation));
  } else if (building.roof) {
    line += counted(building.roof->planes.size(), "plane") + " closed over its outline";
  } else {
    line += "its outline extruded to one height";
  }
  line += ", MAD " + decimals(building.quality.mad, 3) + " m";
  if (!building.reason.empty()) line += (house ? "; but " : ", because ") + building.reason;
  return line + "\n";
}

}  // namespace

std::string explain(const TileBuilding& building) {
  const HouseChoice& choice = building.choice;
  std::vector<Candidate> finalists = choice.finalists;
  std::stable_sort(finalists.begin(), finalists.end(), [](const Candidate& a, const Candidate& b) {
    return a.cost.total < b.cost.total;
  });
  std::string text = building.building.id + "\n" + first_values_line(choice);
  text += probabilities_line(choice);
  if (!finalists.empty()) {
    text += finalists_table(finalists) + given_up_table(choice);
    text += origins_table(choice, finalists.front()) + lead_line(finalists);
    text += afterwards_line(finalists.front(), choice.best);
    if (!choice.found) text += "  it explains the heights no better than bare ground does\n";
  }
  text += relations_line(building.relations) + outcome_line(building.building);
  for (const std::string& line : building.model.dropped) text += "  left out: " + line + "\n";
  return text;
}

}  // namespace gable
