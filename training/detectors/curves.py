"""The curves of a training."""

from __future__ import annotations

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)


def draw_curves(log: dict, path: Path) -> None:
    """Losses above, validation scores below, over minutes."""
    figure, (above, below) = plt.subplots(2, 1, figsize=(9, 9), sharex=True)
    steps = log["steps"]
    for name in steps[0] if steps else ():
        if name not in ("minutes", "step"):
            above.plot([s["minutes"] for s in steps], [s[name] for s in steps], label=name)
    above.set_ylabel("loss")
    if steps:
        above.set_yscale("log")
        above.legend()
    for kind in sorted({v["crops"] for v in log["validations"]}):
        validations = [v for v in log["validations"] if v["crops"] == kind]
        for name, values in _series(validations).items():
            below.plot([v["minutes"] for v in validations], values, label=f"{name} ({kind})",
                       linestyle="-" if kind == "synthesised" else "--", marker=".")
    below.set_xlabel("minutes")
    below.set_ylabel("validation")
    if log["validations"]:
        below.legend(fontsize=7)
    figure.tight_layout()
    figure.savefig(path, dpi=80)
    plt.close(figure)


def _series(validations: list[dict]) -> dict[str, list[float]]:
    series: dict[str, list[float]] = {}
    for name, value in validations[-1].items() if validations else ():
        if name in ("minutes", "step", "crops"):
            continue
        if isinstance(value, float):
            series[name] = [v.get(name, float("nan")) for v in validations]
        elif isinstance(value, dict) and "precision" in value:
            series[f"{name} F1"] = [_f1(v[name]) if name in v else float("nan")
                                    for v in validations]
    return series


def _f1(score: dict) -> float:
    total = score["precision"] + score["recall"]
    return 2 * score["precision"] * score["recall"] / total if total else 0.0
