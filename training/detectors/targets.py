"""What the maps of `house.onnx` should show."""

from __future__ import annotations

import numpy as np

SIZE = 64
SIGMA = 1.3  # pixels
CENTRES = np.arange(SIZE, dtype=np.float32) + 0.5
NUM_CORNER_TYPES = 4
FIRST_DETAIL = 20
# Of each crop: the four corner types of its own foundation, dormers, chimneys, garages.
NUM_SELECTED = NUM_CORNER_TYPES + 3


def bells(coordinates: np.ndarray) -> np.ndarray:
    """n coordinates to n x 64 values of a Gaussian of height 1."""
    return np.exp((CENTRES - coordinates[:, None]) ** 2 * np.float32(-0.5 / SIGMA**2))


def add_points(maps: np.ndarray, points: np.ndarray, channels: np.ndarray | int) -> None:
    """Raises n x K x 64 x 64 maps to a Gaussian over each of n x P points (x, y), NaN for none;
    channels: n x P, which map of its crop a point belongs to, or one for all."""
    known = np.isfinite(points[..., 0])
    channels = np.broadcast_to(channels, known.shape)
    for slot in range(points.shape[1]):
        rows = np.flatnonzero(known[:, slot])
        if not len(rows):
            continue
        x, y = points[rows, slot].astype(np.float32).T
        where = (rows, channels[rows, slot])
        peak = bells(y)[:, :, None] * bells(x)[:, None, :]
        maps[where] = np.maximum(maps[where], peak)


def selected_maps(foundation: np.ndarray) -> np.ndarray:
    """n x 7: the maps of each crop that its truth speaks of. C has no corners: those of I stand
    there, to be given no weight."""
    first = np.where(foundation < 5, foundation, 0).astype(np.int64) * NUM_CORNER_TYPES
    corners = first[:, None] + np.arange(NUM_CORNER_TYPES)
    details = np.broadcast_to(FIRST_DETAIL + np.arange(3), (len(foundation), 3))
    return np.concatenate([corners, details], 1)


def selected_weights(foundation: np.ndarray, details_known: np.ndarray) -> np.ndarray:
    """n x 7: 1 where the truth of a map is known, else 0."""
    weights = np.zeros((len(foundation), NUM_SELECTED), np.float32)
    in_grammar = foundation < 5
    weights[:, :4] = in_grammar[:, None]
    weights[:, 4:] = (in_grammar & (details_known > 0))[:, None]
    return weights


def house_targets(batch: dict[str, np.ndarray]) -> np.ndarray:
    """n x 7 x 64 x 64 in [0, 1], in the order of `selected_maps`."""
    count = len(batch["foundation"])
    maps = np.zeros((count, NUM_SELECTED, SIZE, SIZE), np.float32)
    corners = batch["corners"]
    types = np.where(np.isfinite(corners[..., 0]), corners[..., 0], 0).astype(np.int64)
    add_points(maps, corners[..., 1:], types)
    add_points(maps, batch["dormers"], 4)
    add_points(maps, batch["chimneys"], 5)
    maps[:, 6] = batch["garages"]
    return maps
