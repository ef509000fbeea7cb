"""Peaks of maps, and how well they agree with known points."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import torch
import torch.nn.functional as F

LOWEST = 0.02  # peaks below are of no interest
WINDOW = 5  # pixels a side within which a peak must be the highest


def find_peaks(maps: np.ndarray) -> list[list[tuple[np.ndarray, np.ndarray]]]:
    """Of each of n x K x 64 x 64 maps its peaks, highest first: (x, y) m x 2 in crop pixels, and
    values m."""
    tensor = torch.from_numpy(maps)
    highest = F.max_pool2d(tensor, WINDOW, 1, WINDOW // 2)
    found = ((tensor == highest) & (tensor >= LOWEST)).numpy()
    peaks = []
    for map_row, found_row in zip(maps, found):
        row = []
        for values, here in zip(map_row, found_row):
            y, x = np.nonzero(here)
            order = np.argsort(-values[y, x], kind="stable")
            row.append((np.stack([x, y], 1)[order] + 0.5, values[y, x][order]))
        peaks.append(row)
    return peaks


@dataclass
class Agreement:
    """Peaks of one kind over many crops: their values, whether they hit a known point, and how many
    points there were."""

    radius: float  # pixels
    values: list[np.ndarray] = field(default_factory=list)
    hits: list[np.ndarray] = field(default_factory=list)
    known: int = 0

    def add(self, found: np.ndarray, values: np.ndarray, known: np.ndarray) -> None:
        """Peaks, highest first, each take the nearest known point within the radius that none has
        taken."""
        known = known[np.isfinite(known[:, 0])]
        hits = np.zeros(len(found), bool)
        free = np.ones(len(known), bool)
        for i, point in enumerate(found):
            if not free.any():
                break
            distance = np.where(free, np.hypot(*(known - point).T), np.inf)
            nearest = int(np.argmin(distance))
            if distance[nearest] <= self.radius:
                hits[i], free[nearest] = True, False
        self.values.append(values)
        self.hits.append(hits)
        self.known += len(known)

    def at(self, threshold: float) -> tuple[float, float]:
        """Precision and recall of the peaks of at least this value; 1 where there is nothing."""
        values, hits = np.concatenate(self.values), np.concatenate(self.hits)
        kept = values >= threshold
        right = int(hits[kept].sum())
        return right / max(1, int(kept.sum())) if kept.any() else 1.0, (
            right / self.known if self.known else 1.0)

    def best_threshold(self) -> float:
        """Where F1 is best; 0.5 where no point is known or found."""
        values, hits = np.concatenate(self.values), np.concatenate(self.hits)
        if not self.known or not hits.any():
            return 0.5
        order = np.argsort(-values, kind="stable")
        right = np.cumsum(hits[order])
        f1 = 2 * right / (np.arange(1, len(order) + 1) + self.known)
        best = int(np.argmax(f1))
        below = values[order[best + 1]] if best + 1 < len(order) else values[order[best]] * 0.9
        return float((values[order[best]] + below) / 2)
