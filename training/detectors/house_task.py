"""Training and validation of `house.onnx`."""

from __future__ import annotations

import numpy as np
import torch

from dataset import CLASS_C, Dataset
from losses import class_loss, map_loss
from networks import NUM_FOUNDATIONS, HouseNet
from peaks import Agreement, find_peaks
from targets import house_targets, selected_maps, selected_weights
from task import as_input, forward, low_precision

FOUNDATIONS = ("I", "II", "III", "L", "U", "C")
KINDS = ("corners I", "corners II", "corners III", "corners L", "corners U", "dormers", "chimneys")
CORNER_RADIUS, DETAIL_RADIUS = 2.0, 3.0  # pixels
MAP_SHARE = 4.0  # of the maps in the loss, beside 1 of the foundation
# Of corner types, dormers, chimneys, garages: corners decide the model, chimneys are few.
GAINS = torch.tensor([9.0, 9.0, 9.0, 9.0, 9.0, 9.0, 2.0])
# Dormers and chimneys are the hardest to see and stand on few houses: their maps count double.
SHARES = torch.tensor([1.0, 1.0, 1.0, 1.0, 2.0, 2.0, 1.0])


class HouseTask:
    NETWORK = HouseNet
    FIELDS = ("crops", "garages", "foundation", "corners", "dormers", "chimneys", "details_known")

    def rows(self, dataset: Dataset, rows: np.ndarray) -> np.ndarray:
        """Those that this network trains on."""
        return rows

    def loss(self, network: HouseNet, batch: dict[str, np.ndarray], weights: np.ndarray,
             rng: np.random.Generator) -> tuple[torch.Tensor, dict[str, float]]:
        """weights: one a crop."""
        foundation = batch["foundation"]
        with low_precision():
            scores, features = network.features(as_input(batch["crops"]))
        weights = torch.from_numpy(weights)
        maps = network.maps.selected(features, torch.from_numpy(selected_maps(foundation)))
        known = torch.from_numpy(selected_weights(foundation, batch["details_known"]))
        of_class = class_loss(scores.float(), torch.from_numpy(foundation).long(), weights)
        of_maps = map_loss(maps, torch.from_numpy(house_targets(batch)),
                           known * weights[:, None], GAINS, SHARES)
        return of_class + MAP_SHARE * of_maps, {"foundation": of_class.item(),
                                                "maps": of_maps.item()}

    def evaluate(self, network: HouseNet, dataset: Dataset, rows: np.ndarray) -> dict:
        """Scores, and under "thresholds" the best value of each kind's peaks and of garages."""
        return evaluate_house(network, dataset, rows)[0]


class GarageOverlap:
    """Intersections and unions of garage pixels at thresholds, over many crops."""

    THRESHOLDS = np.linspace(0.05, 0.95, 19)

    def __init__(self):
        self.both, self.either = np.zeros(19), np.zeros(19)

    def add(self, maps: np.ndarray, truth: np.ndarray) -> None:
        for i, threshold in enumerate(self.THRESHOLDS):
            found = maps >= threshold
            self.both[i] += np.count_nonzero(found & truth)
            self.either[i] += np.count_nonzero(found | truth)

    def iou(self) -> np.ndarray:
        return self.both / np.maximum(1, self.either)


def evaluate_house(network: HouseNet, dataset: Dataset, rows: np.ndarray) -> tuple[dict, dict]:
    """Scores, and for calibration the best threshold of each kind and of "garages"."""
    confusion = np.zeros((NUM_FOUNDATIONS, NUM_FOUNDATIONS), int)
    agreements = {kind: Agreement(CORNER_RADIUS if kind.startswith("corners") else DETAIL_RADIUS)
                  for kind in KINDS}
    garages = GarageOverlap()
    for part in np.array_split(rows, max(1, len(rows) // 128)):
        batch = dataset.take(part, HouseTask.FIELDS)
        foundation = batch["foundation"]
        scores, maps = forward(network, batch["crops"])
        np.add.at(confusion, (foundation, scores.argmax(1).numpy()), 1)
        chosen = torch.from_numpy(selected_maps(foundation))
        maps = torch.sigmoid(maps[torch.arange(len(part))[:, None], chosen]).numpy()
        known = selected_weights(foundation, batch["details_known"]) > 0
        for i, peaks in enumerate(find_peaks(maps[:, :6])):
            if foundation[i] == CLASS_C:
                continue
            corners = batch["corners"][i]
            for corner_type in range(4):
                of_type = corners[corners[:, 0] == corner_type, 1:]
                agreements[KINDS[foundation[i]]].add(*peaks[corner_type], of_type)
            if known[i, 4]:
                agreements["dormers"].add(*peaks[4], batch["dormers"][i])
                agreements["chimneys"].add(*peaks[5], batch["chimneys"][i])
        here = known[:, 6]
        garages.add(maps[here, 6], batch["garages"][here] > 0)
    result = {
        "foundation accuracy": float(np.trace(confusion) / max(1, confusion.sum())),
        "confusion": confusion.tolist(),
        "garage IoU": float(garages.iou()[9]),
    }
    thresholds = {"garages": float(garages.THRESHOLDS[int(np.argmax(garages.iou()))])}
    for kind, agreement in agreements.items():
        if agreement.values:
            precision, recall = agreement.at(0.5)
            result[kind] = {"precision": precision, "recall": recall, "known": agreement.known}
            thresholds[kind] = agreement.best_threshold()
    result["thresholds"] = thresholds
    return result, thresholds
