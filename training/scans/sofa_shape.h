#pragma once

#include <gable/grammar/random.h>

namespace gable {

/// Measures of a sofa, metres; x runs along it, its front is at y = 0, z up from the ground.
struct SofaShape {
  int seats = 3;
  double width = 2.1, depth = 0.9;
  double leg = 0.08;          ///< height of the legs
  double base = 0.2;          ///< height of the cushions' underside
  double seat_height = 0.42;  ///< of the cushions' upper side
  double back_height = 0.85, back_width = 0.2;
  double lean = 0.05;  ///< of the back, from the seat to its top
  bool arms = true;
  bool rolled = false;  ///< arms end in a roll instead of rounded edges
  double arm_width = 0.2, arm_height = 0.6;
  bool cushions_behind = true;  ///< one for every seat
  double radius = 0.04;         ///< of rounded edges
  int steps = 3;                ///< strips of a quarter round
  double bulge = 0.01;          ///< of cushions
  double chaise = 0.0;  ///< how far the last seat reaches forward; 0: no further than the others
  int pillows = 0;      ///< loose ones, at most 2
};

/// A random sofa of two to four seats, an armchair, or a sofa with a chaise.
SofaShape random_sofa_shape(Random* random);

}  // namespace gable
