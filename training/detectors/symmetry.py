"""The eight turns and mirrors of a crop, and what they do to all that belongs to it.

Pixels have y down, normals have y up: a turn is named as one sees it, anticlockwise.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

SIZE = 64.0
NUM_SYMMETRIES = 8
# (x, y) of the corners top left, top right, bottom left, bottom right from the centre, y down.
_PLACES = [(-1, -1), (1, -1), (-1, 1), (1, 1)]


@dataclass(frozen=True)
class Symmetry:
    """First mirrored (left to right) or not, then turned anticlockwise by quarters."""

    mirrored: bool
    quarters: int

    @staticmethod
    def of(index: int) -> Symmetry:
        return Symmetry(index >= 4, index % 4)

    def pixels(self, images: np.ndarray) -> np.ndarray:
        """... x 64 x 64."""
        if self.mirrored:
            images = images[..., ::-1]
        return np.rot90(images, self.quarters, axes=(-2, -1))

    def crops(self, crops: np.ndarray) -> np.ndarray:
        """n x 4 x 64 x 64, bytes; the first two channels are the normals' x and y."""
        moved = np.ascontiguousarray(self.pixels(crops))
        x, y = moved[:, 0].copy(), moved[:, 1].copy()
        if self.mirrored:
            x = 255 - x
        for _ in range(self.quarters):
            x, y = 255 - y, x
        moved[:, 0], moved[:, 1] = x, y
        return moved

    def points(self, points: np.ndarray) -> np.ndarray:
        """... x 2, crop pixels."""
        x, y = points[..., 0], points[..., 1]
        if self.mirrored:
            x = SIZE - x
        for _ in range(self.quarters):
            x, y = y, SIZE - x
        return np.stack([x, y], -1)

    def rectangle_corners(self) -> np.ndarray:
        """The new corner of a rectangle (top left, top right, bottom left, bottom right) that each
        corner becomes."""
        centre = SIZE / 2
        moved = self.points(np.array(_PLACES) + centre) - centre
        return np.array([_PLACES.index((round(x), round(y))) for x, y in moved])

    def azimuths(self, azimuths: np.ndarray) -> np.ndarray:
        """Radians, modulo a quarter turn: turns change nothing."""
        return np.mod(-azimuths, np.pi / 2) if self.mirrored else azimuths

    def components(self, components: np.ndarray) -> np.ndarray:
        """n x 3 x 4 x 2: corners move, and take their new places."""
        moved = np.empty_like(components)
        moved[:, :, self.rectangle_corners()] = self.points(components)
        return moved

    def corners(self, corners: np.ndarray, foundation: np.ndarray) -> np.ndarray:
        """n x 12 x 3, (type, x, y): types of I, II and III are places, those of L and U roles."""
        moved = corners.copy()
        moved[..., 1:] = self.points(corners[..., 1:])
        types = corners[..., 0]
        places = np.isfinite(types) & (foundation <= 2)[:, None]
        moved[..., 0][places] = self.rectangle_corners()[types[places].astype(int)]
        return moved

    def batch(self, batch: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
        """All arrays of a batch of `Dataset.take`."""
        moved = dict(batch)
        for name, array in batch.items():
            if name in ("crops", "turned"):
                moved[name] = self.crops(array)
            elif name in ("masks", "garages"):
                moved[name] = self.pixels(array)
            elif name in ("dormers", "chimneys"):
                moved[name] = self.points(array)
            elif name == "components":
                moved[name] = self.components(array)
            elif name == "corners":
                moved[name] = self.corners(array, batch["foundation"])
            elif name == "azimuth":
                moved[name] = self.azimuths(array)
        return moved


def vary(batch: dict[str, np.ndarray], rng: np.random.Generator) -> dict[str, np.ndarray]:
    """A batch whose eighths are turned and mirrored each in its own way."""
    count = len(next(iter(batch.values())))
    parts = []
    for rows, index in zip(np.array_split(np.arange(count), NUM_SYMMETRIES),
                           rng.permutation(NUM_SYMMETRIES)):
        part = {name: array[rows] for name, array in batch.items()}
        parts.append(Symmetry.of(int(index)).batch(part))
    return {name: np.concatenate([part[name] for part in parts]) for name in batch}
