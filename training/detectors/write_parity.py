#!/usr/bin/python3
"""Writes what the exported networks must answer, as PyTorch computes it, for the test of how OpenCV
runs them: of each network

  parity_<net>_input.npy     12 x C x 64 x 64, uint8: synthesised crops, two of each foundation
  parity_<net>_<output>.npy  12 x K, float32: of each crop the output as one row; of maps every
                             97th value only, from the first

Longer batches are these crops over and over."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import torch

from dataset import CLASS_C, Dataset
from deployed import Deployed
from roof_task import roof_inputs
from trained import load_trained

EACH = 2
MAP_STEP = 97  # a prime, so that it meets every row and column
SEED = 1


def crops_of(name: str, dataset: Dataset) -> np.ndarray:
    foundation = dataset.field("foundation")
    rows = dataset.split()[1]
    chosen = np.concatenate([rows[foundation[rows] == f][:EACH] for f in range(CLASS_C + 1)])
    batch = dataset.take(chosen, ("crops", "turned", "foundation", "roofs", "components"))
    if name != "roof":
        return batch["turned" if name == "azimuth" else "crops"]
    # C has no components: its mask stays empty, which a network must bear as well.
    batch["foundation"] = np.minimum(batch["foundation"], CLASS_C - 1)
    return roof_inputs(batch, np.random.default_rng(SEED))[0]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trained", nargs="+", help="folders that train.py and export.py wrote")
    parser.add_argument("--data", required=True, help="folder of shards")
    parser.add_argument("-o", "--out", required=True, help="folder of the files")
    options = parser.parse_args()
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    dataset = Dataset(options.data)
    for folder in options.trained:
        deployed = Deployed(load_trained(folder))
        # Of the export, for it is calibrated.
        deployed.load_state_dict(torch.load(Path(folder) / "deployed.pt"))
        network = deployed.network
        crops = crops_of(network.NAME, dataset)
        np.save(out / f"parity_{network.NAME}_input.npy", crops)
        with torch.no_grad():
            outputs = deployed(torch.from_numpy(crops).float())
        for name, output in zip(network.OUTPUTS, outputs):
            values = output.reshape(len(crops), -1).numpy()
            step = MAP_STEP if output.dim() == 4 else 1
            np.save(out / f"parity_{network.NAME}_{name}.npy",
                    np.ascontiguousarray(values[:, ::step]))


if __name__ == "__main__":
    main()
