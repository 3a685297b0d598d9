"""curves.csv of `ffgpu cache -o DIR`."""
import pathlib

import pandas


def miss_curves(path):
    """A row a cache, with `miss_rate` of its look-ups, `reads_rate` of what they serve (texels,
    samples, vertices), and `is_full`: fully associative. `path` is curves.csv or its folder."""
    path = pathlib.Path(path)
    table = pandas.read_csv(path / "curves.csv" if path.is_dir() else path)
    table["miss_rate"] = table.misses / table.accesses
    table["reads_rate"] = table.misses / table.reads
    table["is_full"] = table.sets == 1
    return table
