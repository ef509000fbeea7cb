#!/usr/bin/python3
"""Writes the card of the exported networks: what they were trained on and how, and their scores."""

from __future__ import annotations

import argparse
import json
import os
from pathlib import Path

from house_task import FOUNDATIONS, KINDS
from roof_task import HEADS

ROOFS = ("flat", "gable", "hip")


def table(head: list[str], rows: list[list[str]]) -> list[str]:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows] + [""]


def percent(value: float) -> str:
    return f"{100 * value:.1f} %"


def confusion(names: tuple[str, ...], counts: list[list[int]]) -> list[str]:
    rows = [[name, *map(str, row), percent(row[i] / max(1, sum(row)))]
            for i, (name, row) in enumerate(zip(names, counts))]
    return table(["known \\ found", *names, "right"], rows)


def house_scores(scores: dict) -> list[str]:
    lines = [f"Foundation type: {percent(scores['foundation accuracy'])} right.", ""]
    lines += confusion(FOUNDATIONS, scores["confusion"])
    rows = [[kind, str(scores[kind]["known"]), percent(scores[kind]["precision"]),
             percent(scores[kind]["recall"])] for kind in KINDS if kind in scores]
    lines += ["Peaks of at least 0.5, the highest of 5 x 5 pixels; corners are right within 2 "
              "pixels, dormers and chimneys within 3; each only on crops whose truth holds it:", ""]
    lines += table(["kind", "known", "precision", "recall"], rows)
    return lines + [f"Garages: IoU {scores['garage IoU']:.3f} over all pixels of all crops.", ""]


def roof_scores(scores: dict) -> list[str]:
    lines = []
    for head in HEADS:
        if f"roof {head} accuracy" in scores:
            lines += [f"Roofs of {head}: {percent(scores[f'roof {head} accuracy'])} right.", ""]
            lines += confusion(ROOFS, scores[f"roof {head} confusion"])
    return lines


def azimuth_scores(scores: dict) -> list[str]:
    return table(["median error", "90 % below", "within 5 degrees", "beyond 10 degrees"], [[
        f"{scores['median error, degrees']:.2f} degrees",
        f"{scores['90 % below, degrees']:.2f} degrees",
        percent(scores["share within 5 degrees"]), percent(scores["share beyond 10 degrees"]),
    ]])  # fmt: skip


PARTS = {"house": house_scores, "roof": roof_scores, "azimuth": azimuth_scores}


def training_lines(log: dict) -> list[str]:
    options = log["options"]
    last = log["steps"][-1] if log["steps"] else {"step": 0, "minutes": 0}
    crops = last["step"] * options["batch"]
    lines = [f"- Trained {last['minutes']:.0f} minutes on {options['threads']} thread(s): {last['step']} steps of "
             f"{options['batch']} crops, {crops / max(1e-9, 60 * last['minutes']):.0f} crops a "
             f"second; seed {options['seed']}, highest rate {options['rate']:g}"]
    if options.get("start_from"):
        lines.append("- Began with the averaged weights of an earlier training (`--start-from`)")
    numbers = log["crops to train on"]
    real = [f"{number} of {Path(folder).name}"
            for number, folder in zip(numbers[1:], options.get("real") or [])]
    mixed = (f"; real ones, {percent(options['real_share'])} of every batch with weight "
             f"{options['real_weight']:g}: {', '.join(real)}" if real else "")
    lines.append(f"- Crops to train on: {numbers[0]} synthesised{mixed}")
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("trained", nargs="+", help="folders that train.py and export.py wrote")
    parser.add_argument("--data", required=True, help="folder of shards")
    parser.add_argument("-o", "--out", required=True, help="the card, a Markdown file")
    options = parser.parse_args()
    about = json.loads((Path(options.data) / "dataset.json").read_text())
    lines = [
        "# The detectors", "",
        "What they see and say: [docs/detectors.md](../../docs/detectors.md). Trained "
        "as `training/train_detectors.sh` does it; where a network began with the weights of an "
        "earlier training, docs/detectors.md tells the stages.", "",
        f"Synthesised crops: {about['crops']} ({about['source']}); the last "
        "tenth is not trained on, and the scores are of crops from there. The maps' thresholds are "
        "set on one half of these, the scores of `house.onnx` are of the other.", "",
    ]  # fmt: skip
    for folder in map(Path, options.trained):
        log = json.loads((folder / "log.json").read_text())
        scores = json.loads((folder / "scores.json").read_text())
        net = log["options"]["net"]
        lines += [f"## {net}.onnx", "",
                  f"- {scores['bytes']} bytes, {scores['parameters']} parameters, "
                  f"{scores['multiply adds'] / 1e6:.1f} million multiply-adds a crop",
                  *training_lines(log), ""]
        for kind, found in scores["of"].items():
            lines += [f"### {found['crops']} crops of {kind}", "", *PARTS[net](found)]
    out = Path(options.out)
    out.parent.mkdir(parents=True, exist_ok=True)
    part = out.with_name(out.name + ".part")
    part.write_text("\n".join(lines).rstrip() + "\n")
    os.replace(part, out)


if __name__ == "__main__":
    main()
