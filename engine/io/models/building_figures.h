#pragma once

#include <gable/engine/io/models/building.h>
#include <gable/engine/io/models/building_json.h>
#include <gable/engine/io/models/building_model.h>

#include <Eigen/Core>

namespace gable {

/// Vector area of a planar face: its unit normal, outward, times its area in square metres.
Eigen::Vector3d face_vector(const Solid& solid, const Face& face);

/// Whether a face of the part belongs to the plan of the building: it is ground, and lies on the
/// building's lowest level (within 1 mm), which `bottom` is (metres, local frame).
bool is_on_the_ground(const Solid& solid, const Face& face, double bottom);

/// Height of the lowest vertex of the model without roof slabs, local frame, metres; 0 where there
/// is none.
double bottom_of(const BuildingModel& model);

/// What tables of buildings list: the attributes of `attributes_json` less the derivation, and
/// gable_plan_area_m2 (ground faces), gable_roof_area_m2 (along the slopes, what dormers and
/// chimneys cover included) and gable_volume_m3, all of the finest solids without roof slabs.
/// Standard deviations, where known: gable_azimuth_sd_deg, and gable_eaves_sd_m of the lowest
/// eaves.
Json table_attributes(const Building& building, const BuildingModel& model);

}  // namespace gable
