#pragma once

#include <gable/grammar/random.h>

namespace gable {

/// Measures of a car, metres; x runs from the front to the rear, z up from the ground.
struct CarShape {
  double length = 4.3, width = 1.75;
  double sill = 0.22;       ///< lower edge of the body
  double crease = 0.70;     ///< where the sides bend, above the wheel arches
  double belt = 0.92;       ///< lower edge of the windows
  double nose = 0.70;       ///< height of the bonnet's front edge
  double bonnet_end = 1.1;  ///< x of the windscreen's lower edge
  double roof_start = 1.9, roof_end = 3.2;
  double roof = 1.42;            ///< height
  double rear_window_end = 3.8;  ///< x of its lower edge
  bool boot = true;              ///< a level boot lid behind the rear window
  double boot_height = 0.98;
  double shoulder = 0.05;    ///< of the side windows behind the sides
  double tumblehome = 0.22;  ///< of the side windows' upper edge, inwards
  double wheel = 0.31;       ///< radius
  double front_axle = 0.8, rear_axle = 3.4;
  double corner = 0.3;   ///< length of the tapered ends
  double taper = 0.1;    ///< how far they come in
  double crown = 0.03;   ///< rise of bonnet, roof and boot in the middle over their sides
  double bulge = 0.02;   ///< of panels along the car
  double bow = 0.05;     ///< of front, rear and windscreens in plan
  double bumper = 0.04;  ///< how far bumpers stand out
  bool underbody = true;
  int strips = 4;  ///< of a curved panel, each way

  double half_width() const { return 0.5 * width; }
  /// Half width where the side windows start.
  double half_belt() const { return half_width() - shoulder; }
  /// Half width where they end at the roof.
  double half_roof() const { return half_belt() - tumblehome; }
};

/// A random saloon, hatchback, estate, off-roader or van.
CarShape random_car_shape(Random* random);

}  // namespace gable
