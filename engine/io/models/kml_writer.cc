#include <cpl_vsi.h>
#include <gable/engine/error.h>
#include <gable/engine/io/gdal_messages.h>
#include <gable/engine/io/memory_file.h>
#include <gable/engine/io/models/building_figures.h>
#include <gable/engine/io/models/kml_writer.h>
#include <gable/grammar/solid/triangulate.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

namespace gable {
namespace {

/// Brightnesses that a kind of surface comes in.
constexpr int kNumShades = 4;
/// Share of the light that shadows still get.
constexpr double kAmbient = 0.55;

struct Paint {
  const char* name;
  std::array<int, 3> rgb;  ///< in full light
};
/// By SurfaceType.
constexpr Paint kPaints[3] = {
    {"ground", {120, 120, 110}}, {"wall", {236, 226, 208}}, {"roof", {190, 92, 70}}};

std::string style_name(int type, int shade) {
  return std::string(kPaints[type].name) + "-" + std::to_string(shade + 1);
}

std::string styles() {
  std::string text;
  for (int type = 0; type < 3; ++type) {
    for (int shade = 0; shade < kNumShades; ++shade) {
      const double light = kAmbient + (1.0 - kAmbient) * shade / (kNumShades - 1);
      const auto channel = [&](int i) {
        return static_cast<int>(std::lround(light * kPaints[type].rgb[i]));
      };
      char color[16];
      std::snprintf(color, sizeof color, "ff%02x%02x%02x", channel(2), channel(1), channel(0));
      text += "<Style id=\"" + style_name(type, shade) + "\"><PolyStyle><color>" + color +
              "</color><outline>0</outline></PolyStyle></Style>\n";
    }
  }
  return text;
}

int shade_of(const Eigen::Vector3d& normal) {
  const Eigen::Vector3d light = Eigen::Vector3d(-0.45, -0.6, 0.66).normalized();
  const double share = std::max(0.0, normal.dot(light));
  return static_cast<int>(std::lround(share * (kNumShades - 1)));
}

/// Text for XML: what has a meaning there is escaped, what is not allowed there becomes a space.
std::string xml_text(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return out;
}

/// Strings as they are, lists with commas between their items.
std::string value_text(const Json& value) {
  if (value.is_string()) {
    // Through JSON, which replaces bytes that are not UTF-8.
    return Json::parse(dump_json(value)).get<std::string>();
  }
  if (!value.is_array()) return dump_json(value);
  std::string text;
  for (const Json& item : value) text += (text.empty() ? "" : ", ") + value_text(item);
  return text;
}

std::string extended_data(const Json& attributes) {
  std::string text = "<ExtendedData>\n";
  for (const auto& [name, value] : attributes.items()) {
    text += "<Data name=\"" + xml_text(name) + "\"><value>" + xml_text(value_text(value)) +
            "</value></Data>\n";
  }
  return text + "</ExtendedData>\n";
}

bool is_convex(const Solid& solid, const Face& face, const Eigen::Vector3d& normal) {
  if (face.rings.size() != 1) return false;
  const std::vector<int>& ring = face.rings[0];
  const size_t n = ring.size();
  for (size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d& p = solid.vertices[ring[i]];
    const Eigen::Vector3d& q = solid.vertices[ring[(i + 1) % n]];
    const Eigen::Vector3d& r = solid.vertices[ring[(i + 2) % n]];
    if ((q - p).cross(r - q).dot(normal) < -1e-9) return false;
  }
  return true;
}

}  // namespace

KmlWriter::KmlWriter(const std::string& path, const ModelWriterOptions& options)
    : file_(path),
      position_([&] {
        if (!options.crs.empty()) return options.crs;
        throw Error(ExitCode::kUsage,
                    path +
                        ": a globe needs a reference system; name that of the raster with --crs "
                        "EPSG:NNNN");
      }()),
      on_terrain_(options.kml_on_terrain),
      zipped_(path.ends_with(".kmz")) {
  write(R"(<?xml version="1.0" encoding="UTF-8"?>)"
        "\n"
        R"(<kml xmlns="http://www.opengis.net/kml/2.2"><Document><name>gable</name>)"
        "\n" +
        styles() +
        // One line per building in the viewer's list.
        "<Style id=\"building\"><ListStyle><listItemType>checkHideChildren</listItemType>"
        "</ListStyle></Style>\n");
}

void KmlWriter::write(const std::string& text) {
  if (zipped_) {
    text_ += text;
  } else {
    file_.write(text);
  }
}

void KmlWriter::append(const Building& building, const BuildingModel& model) {
  const double lift = on_terrain_ ? 0.0 : model.origin.z();
  std::array<std::array<std::string, kNumShades>, 3> polygons;
  for (const PartModel& part : model.parts) {
    const Solid& solid = finest_solid(part);
    std::vector<std::string> points;
    for (const Eigen::Vector3d& p : solid.vertices) {
      const Eigen::Vector2d at = position_.lon_lat((model.origin + p).head<2>());
      char text[96];
      // Tenths of a millimetre in plan, millimetres in height.
      std::snprintf(text, sizeof text, "%.9f,%.9f,%.3f", at.x(), at.y(), p.z() + lift);
      points.emplace_back(text);
    }
    for (const Face& face : solid.faces) {
      const Eigen::Vector3d normal = face_vector(solid, face).normalized();
      const auto type = static_cast<size_t>(drawn_type(part.role, face.type));
      std::string& text = polygons[type][shade_of(normal)];
      const auto add_polygon = [&](const auto& ring) {
        text += on_terrain_ ? "<Polygon><altitudeMode>relativeToGround</altitudeMode>"
                            : "<Polygon><altitudeMode>absolute</altitudeMode>";
        text += "<outerBoundaryIs><LinearRing><coordinates>";
        for (const int v : ring) text += points[v] + ' ';
        text += points[ring[0]] + "</coordinates></LinearRing></outerBoundaryIs></Polygon>\n";
      };
      if (is_convex(solid, face, normal)) {
        add_polygon(face.rings[0]);
      } else {
        for (const auto& triangle : triangulate(solid, face)) add_polygon(triangle);
      }
    }
  }
  const std::string name = "<name>" + xml_text(value_text(Json(building.id))) + "</name>";
  const std::string data = extended_data(table_attributes(building, model));
  std::string text = "<Folder>" + name + "<styleUrl>#building</styleUrl>\n";
  for (int type = 2; type >= 0; --type) {
    for (int shade = 0; shade < kNumShades; ++shade) {
      if (polygons[type][shade].empty()) continue;
      text += "<Placemark>" + name + "<styleUrl>#" + style_name(type, shade) + "</styleUrl>\n" +
              data + "<MultiGeometry>\n" + polygons[type][shade] + "</MultiGeometry></Placemark>\n";
    }
  }
  write(text + "</Folder>\n");
}

void KmlWriter::close() {
  write("</Document></kml>\n");
  if (zipped_) {
    const GdalMessages messages;
    MemoryFile memory(".kmz");
    const std::string inside = "/vsizip/" + memory.name() + "/doc.kml";
    VSILFILE* document = VSIFOpenL(inside.c_str(), "wb");
    const bool written =
        document && VSIFWriteL(text_.data(), 1, text_.size(), document) == text_.size();
    const bool closed = document && VSIFCloseL(document) == 0;
    if (!written || !closed) {
      throw Error(ExitCode::kInternal,
                  file_.path() + ": could not be composed" + messages.suffix());
    }
    memory.write(&file_);
  }
  file_.commit();
}

}  // namespace gable
