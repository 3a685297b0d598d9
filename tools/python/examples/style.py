"""How the figures look: colours that are told apart without red and green (Okabe and Ito)."""
import argparse
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))

from matplotlib import pyplot  # noqa: E402

COLORS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"]
pyplot.rcParams.update({
    "axes.prop_cycle": matplotlib.cycler(color=COLORS), "axes.grid": True, "grid.color": "#dddddd",
    "axes.spines.top": False, "axes.spines.right": False, "figure.figsize": (8, 5),
    "figure.dpi": 120, "font.size": 11})


def arguments(text, *inputs):
    """The inputs, and -o for the picture."""
    parser = argparse.ArgumentParser(description=text)
    for name, meaning in inputs:
        parser.add_argument(name, help=meaning)
    parser.add_argument("-o", "--output", required=True, help="a picture: PNG, SVG or PDF")
    return parser.parse_args()


def read(function, path):
    """What the function reads from the path. Where it cannot, one line says why, and all ends."""
    try:
        return function(path)
    except OSError as error:
        sys.exit(f"{error.filename or path}: {error.strerror or error}")
    except ValueError as error:
        sys.exit(str(error))


def save(figure, path):
    kinds = figure.canvas.get_supported_filetypes()
    kind = pathlib.Path(path).suffix[1:].lower()
    if not path or (kind and kind not in kinds):
        sys.exit(f"-o '{path}': expected a name that ends in one of {', '.join(sorted(kinds))}")
    try:
        figure.savefig(path, bbox_inches="tight",
                       metadata={"Software": None} if kind == "png" else None)
    except OSError as error:
        sys.exit(f"{path}: {error.strerror or error}")
