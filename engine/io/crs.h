#pragma once

#include <string>

namespace gable {

/// A coordinate reference system, kept as text so that no header needs GDAL.
struct Crs {
  std::string wkt;   ///< WKT2; empty: unknown
  std::string name;  ///< for messages, e.g. "Amersfoort / RD New"
  int epsg = 0;      ///< EPSG code of the whole, else of its horizontal part, else 0

  bool empty() const { return wkt.empty(); }
};

/// From anything GDAL understands: "EPSG:28992", WKT, a PROJ string. Throws Error (kUsage).
Crs crs_from_text(const std::string& text);

/// Whether two systems have the same horizontal part (heights may be declared or not).
bool same_horizontal_crs(const Crs& a, const Crs& b);

/// "https://www.opengis.net/def/crs/EPSG/0/NNNN" as CityJSON wants it, or "" without an EPSG code.
std::string crs_url(const Crs& crs);

}  // namespace gable
