"""curves.csv of `ffgpu cache -o DIR`."""
from .files import file_at, read_table

NAMES = ["client", "layout", "traversal", "granularity"]
NUMBERS = ["level", "tile_width", "merged", "line_bytes", "sets", "ways", "bytes", "reads",
           "accesses", "misses"]


def miss_curves(path):
    """A row a cache, with `miss_rate` of its look-ups, `reads_rate` of what they serve (texels,
    samples, vertices), and `is_full`: fully associative. `path` is curves.csv or its folder."""
    table = read_table(file_at(path, "curves.csv"), "curves.csv of ffgpu cache", NAMES, NUMBERS)
    table["miss_rate"] = table.misses / table.accesses
    table["reads_rate"] = table.misses / table.reads
    table["is_full"] = table.sets == 1
    return table
