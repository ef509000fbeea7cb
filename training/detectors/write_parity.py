#!/usr/bin/python3
"""Writes what the exported networks must answer, as PyTorch computes it, for the test of how OpenCV
runs them (tests/engine/detectors/detector_parity_test.cc): of each network

  parity_<net>_inputs.npy    12 x C x 64 x 64, uint8: synthesised crops, two of each foundation

and of each crop the outputs as one row, float32

  parity_house_foundation.npy   12 x 6
  parity_house_maps.npy         12 x 972: every 97th value, from the first
  parity_roof_outputs.npy       12 x 9: roof_i, roof_l, roof_u
  parity_azimuth_outputs.npy    12 x 24"""

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
        with torch.no_grad():
            outputs = deployed(torch.from_numpy(crops).float())
        rows = [output.reshape(len(crops), -1).numpy() for output in outputs]
        if network.NAME == "house":
            named = {"foundation": rows[0], "maps": rows[1][:, ::MAP_STEP]}
        else:
            named = {"outputs": np.concatenate(rows, 1)}
        for name, array in {"inputs": crops, **named}.items():
            np.save(out / f"parity_{network.NAME}_{name}.npy", np.ascontiguousarray(array))


if __name__ == "__main__":
    main()
