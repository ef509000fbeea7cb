#pragma once

#include <gable/engine/error.h>
#include <gable/engine/io/answers/annotation_json.h>
#include <gable/engine/io/atomic_file.h>

#include <exception>
#include <set>
#include <string>

namespace gable::annotation_json {

/// Writes a list of houses with what they were looked at in (`HouseAnswers`, `AnnotatedTile`), each
/// house as `house_text` gives it. Throws Error (kCannotWrite).
template <typename List, typename HouseText>
void write_house_list(const std::string& path, const std::string& format, const List& list,
                      const HouseText& house_text) {
  std::string text = "{\"format\":\"" + format + "\",\"version\":1," + source_text(list.source) +
                     ",\n\"houses\":[";
  for (size_t i = 0; i < list.houses.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + house_text(list.houses[i]);
  }
  write_file_atomically(path, text + "]}\n");
}

/// Reads it; `house_from_json` reads all members of a house but its id. Throws Error: kNoInput
/// where the file cannot be opened; kBadInput, naming the house, where it is not of this form.
template <typename List, typename HouseFromJson>
List read_house_list(const std::string& path, const std::string& format,
                     const HouseFromJson& house_from_json) {
  List list;
  std::string who;
  try {
    const Json json = read(path, format);
    list.source = source(json);
    const Json& houses = member(json, "houses");
    require(houses.is_array(), "\"houses\" is no list");
    std::set<std::string> ids;
    for (const Json& item : houses) {
      who = "a house ";
      const std::string id = text(item, "id");
      who = id + ": ";
      require(ids.insert(id).second, "stands there twice");
      list.houses.push_back(house_from_json(item));
      list.houses.back().id = id;
    }
  } catch (const Error&) {
    throw;
  } catch (const std::exception& error) {
    throw Error(ExitCode::kBadInput, path + ": " + who + error.what() +
                                         "; correct it or write it anew with gable annotate");
  }
  return list;
}

}  // namespace gable::annotation_json
