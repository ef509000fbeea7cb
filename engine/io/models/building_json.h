#pragma once

#include <gable/engine/io/models/building.h>

#include <nlohmann/json.hpp>
#include <string>

namespace gable {

/// Keys keep their order, so that the same building gives the same bytes.
using Json = nlohmann::ordered_json;

/// The attributes of a building with the prefix gable_, the derivation among them. Numbers are
/// written so that reading gives the same doubles.
Json attributes_json(const Building& building);

/// Inverse of `attributes_json`; derived attributes (counts, heights of eaves and ridge) are not
/// read. Throws Error (kBadInput), the line starting with `where` (file name and building).
Building building_from_attributes(const std::string& id, const Json& attributes,
                                  const std::string& where);

/// Compact text; bytes of strings that are not UTF-8 become U+FFFD.
std::string dump_json(const Json& json);

}  // namespace gable
