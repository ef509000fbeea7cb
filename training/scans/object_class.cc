#include <gable/training/scans/building_surface.h>
#include <gable/training/scans/car_surface.h>
#include <gable/training/scans/indoor_surface.h>
#include <gable/training/scans/object_class.h>
#include <gable/training/scans/sofa_surface.h>

namespace gable {

const std::vector<ObjectClass>& object_classes() {
  static const std::vector<ObjectClass> kClasses = {{"buildings", random_building},
                                                    {"indoor", random_indoor_scene},
                                                    {"cars", random_car},
                                                    {"sofas", random_sofa}};
  return kClasses;
}

}  // namespace gable
