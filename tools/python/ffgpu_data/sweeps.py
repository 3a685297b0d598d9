"""results.csv of `ffgpu sweep`."""
from .files import file_at, read_table

NUMBERS = ["stuck", "cycles", "memory_bytes", "cost"]


def sweep(path):
    """A row a trace and point; machines that stood still are left out. `path` is results.csv or its
    folder."""
    table = read_table(file_at(path, "results.csv"), "results.csv of ffgpu sweep",
                       ["trace", "point"], NUMBERS, dtype={"trace": str, "point": str},
                       keep_default_na=False, na_values={name: "" for name in NUMBERS})
    return table[table.stuck == 0].drop(columns="stuck").reset_index(drop=True)
