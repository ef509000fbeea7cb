"""Shifts the maps of a trained `house` network so that 0.5 is the right threshold."""

from __future__ import annotations

import math

import torch

from house_task import KINDS
from networks import HouseNet
from targets import FIRST_DETAIL, NUM_CORNER_TYPES

LOWEST, HIGHEST = 0.02, 0.98  # of thresholds: beyond, a shift would be without end


def maps_of(kind: str) -> list[int]:
    """The maps of a kind of peaks (house_task.KINDS) or of "garages"."""
    corners = [name for name in KINDS if name.startswith("corners")]
    if kind in corners:
        first = corners.index(kind) * NUM_CORNER_TYPES
        return list(range(first, first + NUM_CORNER_TYPES))
    return [FIRST_DETAIL + ("dormers", "chimneys", "garages").index(kind)]


def calibrate(network: HouseNet, thresholds: dict[str, float]) -> None:
    """Moves the last bias of each kind's maps: what was its threshold, in [0, 1], becomes 0.5.
    Peaks stay where they are, for a shift keeps the order of a map's values."""
    with torch.no_grad():
        for kind, threshold in thresholds.items():
            threshold = min(max(threshold, LOWEST), HIGHEST)
            network.maps.bias[maps_of(kind)] -= math.log(threshold / (1 - threshold))
