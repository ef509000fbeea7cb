"""Shards of a training set (docs/detectors.md), and which of their crops validate."""

from __future__ import annotations

from pathlib import Path

import numpy as np

CLASS_C = 5
PIXELS = 64
NAMES = (
    "crops", "turned", "masks", "garages", "foundation", "azimuth", "roofs", "components",
    "corners", "dormers", "chimneys",
)  # fmt: skip
# Where it is missing, all dormers and chimneys are known; real crops may lack them.
OPTIONAL = "details_known"


class Dataset:
    """The crops of a folder of shards, one after the other; large arrays stay on the disk."""

    def __init__(self, folder: str | Path):
        self.folder = Path(folder)
        first = sorted(self.folder.glob("crops_*.npy"))
        if not first:
            raise SystemExit(f"{self.folder}: no crops_*.npy; make a set with gable synthesize "
                             "--dataset")
        numbers = [path.stem.split("_")[-1] for path in first]
        shards = [{name: self._load(name, number) for name in NAMES} for number in numbers]
        for number, shard in zip(numbers, shards):
            shard[OPTIONAL] = self._load_known(number, len(shard["crops"]))
            for name, array in shard.items():
                if len(array) != len(shard["crops"]):
                    raise SystemExit(f"{self.folder}/{name}_{number}.npy: has {len(array)} entries, "
                                     f"crops_{number}.npy {len(shard['crops'])}")
        self._large = {name: [shard[name] for shard in shards] for name in ("crops", "turned")}
        self._small = {
            name: np.concatenate([shard[name] for shard in shards])
            for name in (*NAMES, OPTIONAL)
            if name not in self._large
        }
        self._starts = np.cumsum([0] + [len(shard["crops"]) for shard in shards])

    def _load(self, name: str, number: str) -> np.ndarray:
        path = self.folder / f"{name}_{number}.npy"
        if not path.exists():
            raise SystemExit(f"{path}: is missing; make the set again")
        return np.load(path, mmap_mode="r")

    def _load_known(self, number: str, count: int) -> np.ndarray:
        path = self.folder / f"{OPTIONAL}_{number}.npy"
        return np.load(path) if path.exists() else np.ones(count, np.uint8)

    def __len__(self) -> int:
        return int(self._starts[-1])

    def field(self, name: str) -> np.ndarray:
        """A whole small array."""
        return self._small[name]

    def take(self, rows: np.ndarray, names: tuple[str, ...]) -> dict[str, np.ndarray]:
        """Arrays of the given crops, in their order; masks and garages as n x 64 x 64 of 0, 1."""
        batch = {}
        for name in names:
            if name in self._large:
                batch[name] = self._take_large(name, rows)
            elif name in ("masks", "garages"):
                bits = np.unpackbits(self._small[name][rows], axis=1)
                batch[name] = bits.reshape(-1, PIXELS, PIXELS)
            else:
                batch[name] = self._small[name][rows]
        return batch

    def _take_large(self, name: str, rows: np.ndarray) -> np.ndarray:
        arrays = self._large[name]
        shard = np.searchsorted(self._starts, rows, side="right") - 1
        result = np.empty((len(rows), *arrays[0].shape[1:]), arrays[0].dtype)
        for index in np.unique(shard):
            here = np.flatnonzero(shard == index)
            result[here] = arrays[index][rows[here] - self._starts[index]]
        return result

    def split(self, share: float = 0.1) -> tuple[np.ndarray, np.ndarray]:
        """Rows to train on, and rows to validate on: the last shards that hold this share, or the
        last rows where there is one shard only."""
        total = len(self)
        begin = total - max(1, round(share * total))
        starts = self._starts[1:-1]
        if len(starts):
            begin = int(starts[np.argmin(np.abs(starts - begin))])
        return np.arange(begin), np.arange(begin, total)


def drawn(rows: np.ndarray, count: int) -> np.ndarray:
    """At most so many of the rows, drawn without order, always the same. Rows at equal steps would
    not do: synthesised crops take turns by foundation."""
    return np.random.default_rng(0).permutation(rows)[:count]
