# SPDX-License-Identifier: BSL-1.0
"""What the examples have in common: where their pictures go."""

import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

quick = "--quick" in sys.argv
"""Less of everything, to see that it runs."""


def save(figure, script: str) -> None:
    """Into out/, or into the folder that the first argument names."""
    named = [word for word in sys.argv[1:] if not word.startswith("-")]
    folder = pathlib.Path(named[0] if named else "out")
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / (pathlib.Path(script).stem + ".png")
    figure.savefig(path, dpi=110, bbox_inches="tight")
    plt.close(figure)
    print("written:", path)
