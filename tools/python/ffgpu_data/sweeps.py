"""results.csv of `ffgpu sweep`."""
import pathlib

import pandas


def sweep(path):
    """A row a trace and point; machines that stood still are left out. `path` is results.csv or its
    folder."""
    path = pathlib.Path(path)
    table = pandas.read_csv(path / "results.csv" if path.is_dir() else path)
    return table[table.stuck == 0].drop(columns="stuck").reset_index(drop=True)
