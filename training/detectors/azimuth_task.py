"""Training and validation of `azimuth.onnx`."""

from __future__ import annotations

import numpy as np
import torch

from dataset import Dataset
from losses import QUARTER, azimuth_loss, decode_azimuth
from networks import AzimuthNet
from task import as_input, forward, low_precision

ANGLE_SHARE = 4.0  # of the angle within its bin in the loss, beside 1 of the bin


class AzimuthTask:
    NETWORK = AzimuthNet
    FIELDS = ("turned", "foundation", "azimuth")

    def rows(self, dataset: Dataset, rows: np.ndarray) -> np.ndarray:
        return rows[np.isfinite(dataset.field("azimuth"))[rows]]

    def loss(self, network: AzimuthNet, batch: dict[str, np.ndarray], weights: np.ndarray,
             rng: np.random.Generator) -> tuple[torch.Tensor, dict[str, float]]:
        """weights: one a crop."""
        with low_precision():
            scores = network(as_input(batch["turned"]))
        azimuth = torch.from_numpy(batch["azimuth"])
        of_bin, of_angle = azimuth_loss(*(score.float() for score in scores), azimuth,
                                        torch.from_numpy(weights))
        return of_bin + ANGLE_SHARE * of_angle, {"bin": of_bin.item(), "angle": of_angle.item()}

    def evaluate(self, network: AzimuthNet, dataset: Dataset, rows: np.ndarray) -> dict:
        errors = []
        for part in np.array_split(rows, max(1, len(rows) // 256)):
            batch = dataset.take(part, self.FIELDS)
            found = decode_azimuth(*forward(network, batch["turned"])).numpy()
            error = np.mod(found - batch["azimuth"], QUARTER)
            errors.append(np.degrees(np.minimum(error, QUARTER - error)))
        errors = np.concatenate(errors)
        return {
            "median error, degrees": float(np.median(errors)),
            "90 % below, degrees": float(np.quantile(errors, 0.9)),
            "share within 5 degrees": float((errors <= 5).mean()),
            "share beyond 10 degrees": float((errors > 10).mean()),
        }
