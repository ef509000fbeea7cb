#!/usr/bin/env bash
# Trains the scale models that are shipped, from nothing: makes scans with known planes, marks the
# scales in their trajectories, and trains on one third of them.
#   training/train_scale_models.sh BUILD_DIR WORK_DIR [CITYJSON]
# CITYJSON: a city model with levels of detail 1.2 and 2.2; without it the buildings are all
# generated. Models and their cards go to models/scales; scans need 3 GB in WORK_DIR.
set -euo pipefail
programs=$(realpath "$1")/bin
work=$2
city=${3:-}
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")

for class in buildings indoor cars sofas; do
  scans=$work/$class
  rm -rf "$scans"
  "$programs/gable_make_scans" $class 160 --seed 1 -o "$scans/generated"
  folders=("$scans/generated")
  if [[ $class == buildings && -n $city ]]; then
    "$programs/gable_make_scans" $class 80 --seed 1 --cityjson "$city" -o "$scans/city"
    folders+=("$scans/city")
  fi
  "$programs/gable" shapes annotate "${folders[@]}" -o "$scans/labels.json"
  "$programs/gable" shapes train "${folders[@]}" --labels "$scans/labels.json" --name $class \
    -o "$root/models/scales"
done
