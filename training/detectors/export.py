#!/usr/bin/python3
"""Writes trained networks as ONNX files that OpenCV reads, calibrated and checked, and beside the
checkpoint of each its scores on crops that it has not seen (scores.json)."""

from __future__ import annotations

import argparse
import json
import os
import zlib
from pathlib import Path

import onnx
import torch

from calibrate import calibrate
from dataset import Dataset, drawn
from deployed import Deployed, multiply_adds
from house_task import evaluate_house
from networks import CROP_SIZE
from train import TASKS, brief
from trained import load_trained

OPSET = 11  # the newest that OpenCV 4.6 reads without gaps


def write_onnx(deployed: Deployed, path: Path) -> None:
    """Any number of crops at once; checked, or an exception."""
    network = deployed.network
    crop = torch.full((2, network.INPUT_CHANNELS, CROP_SIZE, CROP_SIZE), 128.0)
    part = path.with_suffix(".part")
    torch.onnx.export(
        deployed, (crop,), str(part), opset_version=OPSET, do_constant_folding=True,
        input_names=["crop"], output_names=list(network.OUTPUTS),
        dynamic_axes={name: {0: "batch"} for name in ("crop", *network.OUTPUTS)},
    )  # fmt: skip
    model = onnx.load(str(part))
    onnx.checker.check_model(model, full_check=True)
    add_checksum(model)
    onnx.save(model, str(part))
    os.replace(part, path)


def add_checksum(model: onnx.ModelProto) -> None:
    """Lets the reader notice a damaged file (engine/detectors/onnx_signature.h)."""
    entry = model.metadata_props.add()
    entry.key = "graph_crc32"
    entry.value = f"{zlib.crc32(model.graph.SerializeToString()):08x}"


def check_batches(deployed: Deployed, crops: torch.Tensor) -> None:
    """A crop's outputs must not depend on its neighbours in a batch."""
    with torch.no_grad():
        together = deployed(crops)
        for count in (1, 5):
            for all_of, some in zip(together, deployed(crops[:count])):
                if not torch.allclose(all_of[:count], some, atol=1e-4):
                    raise SystemExit(f"outputs for {count} crops differ from those for "
                                     f"{len(crops)}")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("trained", nargs="+", help="folders that train.py wrote")
    parser.add_argument("--data", required=True, help="folder of shards, to calibrate and score on")
    parser.add_argument("--real", nargs="+", default=[],
                        help="folders of real crops, to score on as well")
    parser.add_argument("--crops", type=int, default=6000, help="of each to score on, at most")
    parser.add_argument("-o", "--out", required=True, help="folder of the ONNX files")
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    out = Path(options.out)
    out.mkdir(parents=True, exist_ok=True)
    datasets = {"synthesised": Dataset(options.data)}
    datasets.update({Path(folder).name: Dataset(folder) for folder in options.real})
    for folder in options.trained:
        network = load_trained(folder)
        task = TASKS[network.NAME]()
        scores = {"of": {}}
        for kind, dataset in datasets.items():
            rows = drawn(task.rows(dataset, dataset.split()[1]), options.crops)
            if network.NAME == "house" and kind == "synthesised":
                # Half to calibrate with, the other half for the scores.
                thresholds = evaluate_house(network, dataset, rows[::2])[1]
                calibrate(network, thresholds)
                scores["thresholds before calibration"] = thresholds
                rows = rows[1::2]
            if len(rows):
                found = {"crops": len(rows), **task.evaluate(network, dataset, rows)}
                scores["of"][kind] = found
                print(f"{network.NAME}, {len(rows)} crops of {kind}: {brief(found)}")
        deployed = Deployed(network)
        check_batches(deployed, torch.rand(32, network.INPUT_CHANNELS, CROP_SIZE, CROP_SIZE) * 255)
        path = out / f"{network.NAME}.onnx"
        write_onnx(deployed, path)
        scores.update({
            "bytes": path.stat().st_size, "multiply adds": multiply_adds(network),
            "parameters": sum(p.numel() for p in deployed.parameters()),
        })  # fmt: skip
        (Path(folder) / "scores.json").write_text(json.dumps(scores, indent=1) + "\n")
        torch.save(deployed.state_dict(), Path(folder) / "deployed.pt")
        print(f"{path}: {scores['bytes']} bytes, {scores['multiply adds'] / 1e6:.1f} M "
              "multiply-adds a crop")


if __name__ == "__main__":
    main()
