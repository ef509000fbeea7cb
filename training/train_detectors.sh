#!/usr/bin/env bash
# Trains the detectors that are shipped, from nothing: builds the program, synthesises crops, trains
# the three networks of docs/detectors.md, and exports them to models/detectors.
#   training/train_detectors.sh WORK_DIR [OPTION VALUE]...
# --count N          crops to synthesise (200000)
# --seed S           of the crops and of the training (1)
# --real DIR         shards of real crops to mix in; any number of times
# --real-share X     their share of every batch (0.1)
# --real-weight X    of their losses (1)
# --minutes N        for house; roof and azimuth take a quarter each (75)
# --threads N        (1)
# Needs python3 with torch, onnx, numpy and matplotlib (Debian: python3-torch python3-onnx
# python3-numpy python3-matplotlib); $PYTHON names another. Crops need 35 kB each in WORK_DIR. What
# is there already is used: an interrupted run goes on where it was.
set -euo pipefail

root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
python=${PYTHON:-/usr/bin/python3}
die() { echo "train_detectors.sh: $*" >&2; exit 2; }
(($# % 2 == 1)) || die "usage: train_detectors.sh WORK_DIR [OPTION VALUE]..."

mkdir -p "$1"
work=$(realpath "$1")
shift
count=200000 seed=1 real=() share=0.1 weight=1 minutes=75 threads=1
while (($#)); do
  case $1 in
    --count) count=$2 ;;
    --seed) seed=$2 ;;
    --real) real+=("$(realpath "$2")") ;;
    --real-share) share=$2 ;;
    --real-weight) weight=$2 ;;
    --minutes) minutes=$2 ;;
    --threads) threads=$2 ;;
    *) die "no such option: $1" ;;
  esac
  shift 2
done
"$python" -c 'import torch, onnx, numpy, matplotlib' 2>/dev/null ||
  die "$python lacks one of torch, onnx, numpy, matplotlib; set PYTHON or install them"

(cd "$root" && cmake --preset release && cmake --build --preset release --target gable_cli) >&2

data=$work/synthesised
if [[ ! -e $data/dataset.json ]]; then
  "$root/build/release/bin/gable" synthesize --dataset --count "$count" --seed "$seed" \
    -o "$data"
fi

detectors=$root/training/detectors
mixed=()
scored=()
if ((${#real[@]})); then
  mixed=(--real "${real[@]}" --real-share "$share" --real-weight "$weight")
  scored=(--real "${real[@]}")
fi
folders=()
for net in house roof azimuth; do
  part=$minutes
  [[ $net == house ]] || part=$(awk "BEGIN { print $minutes / 4 }")
  "$python" "$detectors/train.py" --net $net --data "$data" "${mixed[@]}" --out "$work/$net" \
    --minutes "$part" --seed "$seed" --threads "$threads"
  folders+=("$work/$net")
done

"$python" "$detectors/export.py" "${folders[@]}" --data "$data" "${scored[@]}" \
  -o "$root/models/detectors" --threads "$threads"
"$python" "$detectors/write_parity.py" "${folders[@]}" --data "$data" \
  -o "$root/tests/engine/detectors"
"$python" "$detectors/card.py" "${folders[@]}" --data "$data" -o "$root/models/detectors/CARD.md"
