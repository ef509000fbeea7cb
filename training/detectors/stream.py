"""Batches of a training: synthesised crops, and a share of real ones."""

from __future__ import annotations

import numpy as np

from dataset import Dataset
from symmetry import vary


class Stream:
    """Batches of rows, every row once an epoch, the same at a step whatever came before it."""

    def __init__(self, rows: np.ndarray, size: int, seed: int):
        if len(rows) < size:
            raise SystemExit(f"{len(rows)} crops to train on are fewer than a batch of {size}")
        self.rows, self.size, self.seed = rows, size, seed
        self.steps_an_epoch = len(rows) // size
        self._epoch, self._order = -1, rows

    def at(self, step: int) -> np.ndarray:
        epoch, place = divmod(step, self.steps_an_epoch)
        if epoch != self._epoch:
            self._order = np.random.default_rng([self.seed, epoch]).permutation(self.rows)
            self._epoch = epoch
        return self._order[place * self.size : (place + 1) * self.size]


class Source:
    """A dataset's part in every batch."""

    def __init__(self, dataset: Dataset, rows: np.ndarray, size: int, weight: float, seed: int):
        self.dataset, self.weight = dataset, weight
        self.stream = Stream(rows, size, seed)

    def batch(self, step: int, names: tuple[str, ...], rng: np.random.Generator
              ) -> dict[str, np.ndarray]:
        """Turned and mirrored at random; "weight" is the loss's weight of each crop."""
        batch = vary(self.dataset.take(self.stream.at(step), names), rng)
        batch["weight"] = np.full(self.stream.size, self.weight, np.float32)
        return batch


def joined(parts: list[dict[str, np.ndarray]]) -> dict[str, np.ndarray]:
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}
