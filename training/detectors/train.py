#!/usr/bin/python3
"""Trains one network of the detectors: writes checkpoint.pt, log.json and curves.png to a folder,
and goes on from the checkpoint where there is one."""

from __future__ import annotations

import argparse
import json
import os
import time
from pathlib import Path

import numpy as np
import torch

from average import WeightAverage
from azimuth_task import AzimuthTask
from curves import draw_curves
from dataset import Dataset, drawn
from deployed import multiply_adds
from house_task import HouseTask
from progress import ProgressLine
from roof_task import RoofTask
from schedule import Schedule, rate_at
from stream import Source, joined

TASKS = {"house": HouseTask, "roof": RoofTask, "azimuth": AzimuthTask}


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--net", required=True, choices=TASKS)
    parser.add_argument("--data", required=True, help="folder of shards")
    parser.add_argument("--real", nargs="+", default=[], help="folders of real crops, mixed in")
    parser.add_argument("--real-share", type=float, default=0.1, help="of every batch, (0, 1)")
    parser.add_argument("--real-weight", type=float, default=1.0, help="in the loss, > 0")
    parser.add_argument("--out", required=True, help="folder of the checkpoint and the log")
    length = parser.add_mutually_exclusive_group(required=True)
    length.add_argument("--minutes", type=float, help="of training")
    length.add_argument("--epochs", type=float, help="of the synthesised crops")
    parser.add_argument("--width", type=int, help="channels at the first stage")
    parser.add_argument("--batch", type=int, default=64)
    parser.add_argument("--rate", type=float, default=1.5e-3, help="highest learning rate")
    parser.add_argument("--decay", type=float, default=0.02, help="of weights (AdamW)")
    parser.add_argument("--start-from", help="checkpoint whose averaged weights to begin with")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--validate-every", type=float, default=5.0, help="minutes")
    parser.add_argument("--validation-crops", type=int, default=3000, help="at most, while training")
    options = parser.parse_args()
    if options.real and not 0 < options.real_share < 1:
        parser.error("--real-share must lie between 0 and 1")
    return options


class Training:
    def __init__(self, options: argparse.Namespace):
        self.options = options
        self.out = Path(options.out)
        self.out.mkdir(parents=True, exist_ok=True)
        torch.set_num_threads(options.threads)
        torch.manual_seed(options.seed)
        self.task = TASKS[options.net]()
        width = {"width": options.width} if options.width else {}
        network = self.task.NETWORK(**width)
        self.network = network.to(memory_format=torch.channels_last)
        if options.start_from:
            self.network.load_state_dict(torch.load(options.start_from)["average"])
        self.average = WeightAverage(self.network)
        self.optimizer = torch.optim.AdamW(self.network.parameters(), options.rate,
                                           weight_decay=options.decay)
        self._open_data()
        self.log = {"options": vars(options), "multiply adds": multiply_adds(network),
                    "parameters": sum(p.numel() for p in network.parameters()),
                    "crops to train on": [len(s.stream.rows) for s in self.sources],
                    "steps": [], "validations": []}
        self.step, seconds = self._resume()
        steps = options.epochs and round(options.epochs * self.sources[0].stream.steps_an_epoch)
        self.schedule = Schedule(options.minutes and options.minutes * 60, steps, seconds)
        self.line = ProgressLine(options.net)

    def _open_data(self) -> None:
        options = self.options
        real = [Dataset(folder) for folder in options.real]
        total = sum(len(dataset) for dataset in real)
        real_size = round(options.batch * options.real_share) if real else 0
        # Every real folder by its number of crops, but each with at least one in every batch.
        sizes = [max(1, round(real_size * len(dataset) / total)) for dataset in real]
        self.sources, self.validation = [], {}
        self._add_source("synthesised", Dataset(options.data), options.batch - sum(sizes), 1.0)
        for dataset, size in zip(real, sizes):
            self._add_source(dataset.folder.name, dataset, size, options.real_weight)

    def _add_source(self, name: str, dataset: Dataset, size: int, weight: float) -> None:
        training, validation = (self.task.rows(dataset, rows) for rows in dataset.split())
        seed = self.options.seed + len(self.sources)
        self.sources.append(Source(dataset, training, size, weight, seed))
        chosen = drawn(validation, self.options.validation_crops)
        self.validation[name] = (dataset, chosen)

    def _resume(self) -> tuple[int, float]:
        """The step to go on with, and the seconds trained before."""
        path = self.out / "checkpoint.pt"
        if not path.exists():
            return 0, 0.0
        state = torch.load(path)
        self.network.load_state_dict(state["network"])
        self.average.network.load_state_dict(state["average"])
        self.optimizer.load_state_dict(state["optimizer"])
        torch.set_rng_state(state["random"])
        self.log["steps"], self.log["validations"] = state["steps"], state["validations"]
        return state["step"], state["seconds"]

    def _save(self) -> None:
        state = {
            "net": self.options.net, "options": vars(self.options), "step": self.step,
            "seconds": self.schedule.elapsed(), "network": self.network.state_dict(),
            "average": self.average.network.state_dict(),
            "optimizer": self.optimizer.state_dict(), "random": torch.get_rng_state(),
            "steps": self.log["steps"], "validations": self.log["validations"],
        }  # fmt: skip
        part = self.out / "checkpoint.part"
        torch.save(state, part)
        os.replace(part, self.out / "checkpoint.pt")
        part = self.out / "log.part"
        part.write_text(json.dumps(self.log, indent=1) + "\n")
        os.replace(part, self.out / "log.json")
        draw_curves(self.log, self.out / "curves.png")

    def _train_step(self) -> tuple[float, dict[str, float]]:
        rng = np.random.default_rng([self.options.seed, 7, self.step])
        parts = [source.batch(self.step, self.task.FIELDS, rng) for source in self.sources]
        batch = joined(parts)
        for group in self.optimizer.param_groups:
            group["lr"] = self.options.rate * rate_at(self.schedule.progress(self.step))
        loss, parts = self.task.loss(self.network, batch, batch["weight"], rng)
        self.optimizer.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.network.parameters(), 5.0)
        self.optimizer.step()
        self.average.update(self.network, self.step)
        return loss.item(), parts

    def _validate(self) -> None:
        for name, (dataset, rows) in self.validation.items():
            if not len(rows):
                continue
            scores = self.task.evaluate(self.average.network, dataset, rows)
            self.log["validations"].append({"minutes": self.schedule.elapsed() / 60,
                                            "step": self.step, "crops": name, **scores})
            self.line.say(f"{self.options.net} at {self.schedule.elapsed() / 60:.1f} min, {name}: "
                          + brief(scores))

    def run(self) -> None:
        options = self.options
        self.line.say(f"{options.net}: {self.log['multiply adds'] / 1e6:.1f} M multiply-adds, "
                      f"{self.log['parameters']} parameters, "
                      f"{self.log['crops to train on']} crops")
        self.network.train()
        validated = time.monotonic()
        sums, steps = {}, 0
        while (progress := self.schedule.progress(self.step)) < 1:
            loss, parts = self._train_step()
            self.step += 1
            self.line.update(progress, self.schedule.left(self.step), options.batch, loss)
            for name, value in {"loss": loss, **parts}.items():
                sums[name] = sums.get(name, 0.0) + value
            steps += 1
            if steps == 50:
                self._record(sums, steps)
                sums, steps = {}, 0
            if time.monotonic() - validated > options.validate_every * 60:
                self._validate()
                self._save()
                validated = time.monotonic()
        if steps:
            self._record(sums, steps)
        self._validate()
        self._save()

    def _record(self, sums: dict[str, float], steps: int) -> None:
        """The mean losses of the last steps."""
        means = {name: value / steps for name, value in sums.items()}
        self.log["steps"].append({"minutes": self.schedule.elapsed() / 60, "step": self.step,
                                  **means})


def brief(scores: dict) -> str:
    """The numbers of a validation in one line."""
    words = []
    for name, value in scores.items():
        if isinstance(value, float):
            words.append(f"{name} {value:.3f}")
        elif isinstance(value, dict) and "precision" in value:
            words.append(f"{name} {value['precision']:.3f}/{value['recall']:.3f}")
    return ", ".join(words)


if __name__ == "__main__":
    Training(arguments()).run()
