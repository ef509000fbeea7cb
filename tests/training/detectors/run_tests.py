"""Runs the tests of training/detectors. Exits with 77, saying so, where PyTorch is missing."""

import importlib.util
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
NEEDED = ("numpy", "torch")


def main() -> int:
    missing = [name for name in NEEDED if importlib.util.find_spec(name) is None]
    if missing:
        print(f"skipped: {sys.executable} lacks {', '.join(missing)}")
        return 77
    sys.dont_write_bytecode = True
    sys.path.insert(0, str(HERE.parents[2] / "training" / "detectors"))
    tests = unittest.defaultTestLoader.discover(str(HERE), "*_test.py", str(HERE))
    return 0 if unittest.TextTestRunner(verbosity=1).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
