"""Training and validation of `roof.onnx`."""

from __future__ import annotations

import numpy as np
import torch

from dataset import CLASS_C, Dataset
from losses import class_loss
from masks import boxes, filled, jittered
from networks import NUM_ROOF_TYPES, RoofNet
from task import as_input, forward, low_precision

HEADS = ("I", "L", "U")
_HEAD_OF_FOUNDATION = np.array([0, 0, 0, 1, 2])


def roof_inputs(batch: dict[str, np.ndarray], rng: np.random.Generator | None
                ) -> tuple[np.ndarray, np.ndarray]:
    """Crops with their mask as fifth channel, n x 5 x 64 x 64 bytes, and the component (n) that is
    masked: any one of I, II and III, all of L and U together (component 0). Without a generator the
    first component and no jitter."""
    foundation, roofs = batch["foundation"], batch["roofs"]
    box = boxes(batch["components"])
    component = np.zeros(len(foundation), int)
    if rng is not None:
        box = jittered(box, rng)
        draws = rng.random(roofs.shape) * (roofs >= 0)
        component = np.where(foundation <= 2, draws.argmax(1), 0)
    single = foundation <= 2
    only = np.where(np.arange(3) == component[:, None], 1.0, np.nan)
    box = np.where(single[:, None, None], box * only[..., None], box)
    crops = np.concatenate([batch["crops"], filled(box)[:, None]], 1)
    return crops, component


class RoofTask:
    NETWORK = RoofNet
    FIELDS = ("crops", "foundation", "roofs", "components")

    def rows(self, dataset: Dataset, rows: np.ndarray) -> np.ndarray:
        known = (dataset.field("foundation") != CLASS_C) & (dataset.field("roofs")[:, 0] >= 0)
        return rows[known[rows]]

    def loss(self, network: RoofNet, batch: dict[str, np.ndarray], weights: np.ndarray,
             rng: np.random.Generator) -> tuple[torch.Tensor, dict[str, float]]:
        """weights: one a crop."""
        crops, component = roof_inputs(batch, rng)
        with low_precision():
            scores = network(as_input(crops))
        truth = torch.from_numpy(batch["roofs"][np.arange(len(component)), component]).long()
        head = _HEAD_OF_FOUNDATION[batch["foundation"]]
        losses = {}
        for i, (name, score) in enumerate(zip(HEADS, scores)):
            here = torch.from_numpy(weights * (head == i))
            losses[name] = class_loss(score.float(), truth, here)
        # By how many crops each head saw, or a batch with one U would count as much as all of I.
        share = [float((head == i).mean()) for i in range(len(HEADS))]
        total = sum(loss * part for loss, part in zip(losses.values(), share))
        return total, {name: loss.item() for name, loss in losses.items()}

    def evaluate(self, network: RoofNet, dataset: Dataset, rows: np.ndarray) -> dict:
        """Every component once, of a detector's accuracy (the jitter of training, seed 0)."""
        rng = np.random.default_rng(0)
        confusion = np.zeros((len(HEADS), NUM_ROOF_TYPES, NUM_ROOF_TYPES), int)
        for part in np.array_split(rows, max(1, len(rows) // 256)):
            batch = dataset.take(part, self.FIELDS)
            crops, component = roof_inputs(batch, rng)
            scores = torch.stack(forward(network, crops), 1).argmax(2).numpy()
            index = np.arange(len(part))
            head = _HEAD_OF_FOUNDATION[batch["foundation"]]
            np.add.at(confusion, (head, batch["roofs"][index, component], scores[index, head]), 1)
        result = {}
        for name, counts in zip(HEADS, confusion):
            if counts.sum():
                result[f"roof {name} accuracy"] = float(np.trace(counts) / counts.sum())
                result[f"roof {name} confusion"] = counts.tolist()
        return result
