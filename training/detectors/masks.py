"""The mask channel of `roof.onnx`."""

from __future__ import annotations

import numpy as np

SIZE = 64
MAX_SHIFT = 1.5  # pixels a side
MAX_SCALE = 0.04  # share of the side
_CENTRES = np.arange(SIZE) + 0.5


def boxes(components: np.ndarray) -> np.ndarray:
    """... x 4 x 2 corners (top left, top right, bottom left, bottom right) to ... x 4: left, right,
    top, bottom, each the mean of its two corners. Rectangles found in a rectified crop lie along
    its axes, so the few degrees by which the true ones do not are left out."""
    x, y = components[..., 0], components[..., 1]
    return np.stack([
        (x[..., 0] + x[..., 2]) / 2, (x[..., 1] + x[..., 3]) / 2,
        (y[..., 0] + y[..., 1]) / 2, (y[..., 2] + y[..., 3]) / 2,
    ], -1)  # fmt: skip


def jittered(box: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Boxes as a detector would find them: every side moved, and the whole scaled, a little."""
    scale = 1 + rng.uniform(-MAX_SCALE, MAX_SCALE, box.shape[:-1])[..., None]
    middle = np.stack([box[..., :2].mean(-1)] * 2 + [box[..., 2:].mean(-1)] * 2, -1)
    return middle + (box - middle) * scale + rng.uniform(-MAX_SHIFT, MAX_SHIFT, box.shape)


def filled(box: np.ndarray) -> np.ndarray:
    """n x K x 4 boxes to n x 64 x 64 bytes: 255 at pixels whose centre some box holds. A box of
    NaN holds nothing."""
    left, right, top, bottom = (box[..., i, None] for i in range(4))
    columns = (_CENTRES >= left) & (_CENTRES <= right)
    rows = (_CENTRES >= top) & (_CENTRES <= bottom)
    inside = (rows[..., :, None] & columns[..., None, :]).any(1)
    return inside.astype(np.uint8) * np.uint8(255)
