#include <cpl_conv.h>
#include <gable/engine/error.h>
#include <gable/engine/io/crs.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/ogr_crs.h>

#include <cstdlib>
#include <cstring>

namespace gable {
namespace {

/// PROJ's confidence from which on a match is the same system but for names.
constexpr int kSameButForNames = 90;

int code_of(const OGRSpatialReference& srs, const char* node) {
  const char* authority = srs.GetAuthorityName(node);
  const char* code = srs.GetAuthorityCode(node);
  return authority && code && std::strcmp(authority, "EPSG") == 0 ? std::atoi(code) : 0;
}

bool same_components(const OGRSpatialReference& a, const OGRSpatialReference& b) {
  for (const char* node : {"PROJCS", "VERT_CS"}) {
    if (code_of(a, node) == 0 || code_of(a, node) != code_of(b, node)) return false;
  }
  return true;
}

/// A system that carries no code is looked up among the known ones: GeoTIFF, for one, keeps the
/// codes of a compound system's components only.
int epsg_of(const OGRSpatialReference& srs) {
  if (const int own = code_of(srs, nullptr)) return own;
  int count = 0;
  int* confidence = nullptr;
  OGRSpatialReferenceH* matches = srs.FindMatches(nullptr, &count, &confidence);
  int found = 0;
  for (int i = 0; i < count && found == 0; ++i) {
    const OGRSpatialReference& match = *OGRSpatialReference::FromHandle(matches[i]);
    if (match.IsCompound() != srs.IsCompound()) continue;
    const bool same =
        srs.IsCompound() ? same_components(srs, match) : confidence[i] >= kSameButForNames;
    if (same) found = code_of(match, nullptr);
  }
  OSRFreeSRSArray(matches);
  CPLFree(confidence);
  return found != 0 || !srs.IsCompound() ? found : code_of(srs, "PROJCS");
}

}  // namespace

Crs crs_from_ogr(const OGRSpatialReference& srs) {
  Crs crs;
  const char* const options[] = {"FORMAT=WKT2_2019", nullptr};
  char* wkt = nullptr;
  if (srs.exportToWkt(&wkt, options) == OGRERR_NONE) crs.wkt = wkt;
  CPLFree(wkt);
  if (const char* name = srs.GetName()) crs.name = name;
  crs.epsg = epsg_of(srs);
  return crs;
}

OGRSpatialReference ogr_from_crs(const Crs& crs) {
  OGRSpatialReference srs;
  if (!crs.empty()) srs.SetFromUserInput(crs.wkt.c_str());
  // WKT2 keeps the code of a compound system but not those of its parts: the database has both.
  if (const int code = code_of(srs, nullptr)) srs.importFromEPSG(code);
  srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return srs;
}

Crs crs_from_text(const std::string& text) {
  const GdalMessages messages;
  OGRSpatialReference srs;
  if (text.empty() || srs.SetFromUserInput(text.c_str()) != OGRERR_NONE) {
    throw Error(ExitCode::kUsage, "\"" + text +
                                      "\" is not a coordinate reference system; give it as "
                                      "EPSG:NNNN" +
                                      messages.suffix());
  }
  return crs_from_ogr(srs);
}

bool same_horizontal_crs(const Crs& a, const Crs& b) {
  const GdalMessages messages;
  OGRSpatialReference first = ogr_from_crs(a);
  OGRSpatialReference second = ogr_from_crs(b);
  first.StripVertical();
  second.StripVertical();
  const char* const options[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
                                 "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS", nullptr};
  if (first.IsSame(&second, options)) return true;
  const int epsg = epsg_of(first);
  return epsg != 0 && epsg == epsg_of(second);
}

std::string crs_url(const Crs& crs) {
  if (crs.epsg == 0) return "";
  return "https://www.opengis.net/def/crs/EPSG/0/" + std::to_string(crs.epsg);
}

}  // namespace gable
