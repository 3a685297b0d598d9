"""Single draws: their cycles from stats.json, their bytes from `ffgpu export --format csv`."""
import math

import pandas

from .files import file_at, read_table
from .statistics import configuration, read


def draws(path):
    """A row a draw: frame, cycles, bottleneck, and the fragments that it wrote."""
    rows = []
    for frame in read(path)["frames"]:
        if "commands" not in frame:
            raise ValueError(f"{path}: tells no commands: they come with --timing")
        for command in frame["commands"]:
            if command["kind"] != "draw":
                continue
            written = command.get("quad_lanes_written", [])
            rows.append({"draw": command["draw"], "frame": frame["frame"],
                         "cycles": command["cycles"], "bottleneck": command.get("bottleneck"),
                         "fragments": sum(lanes * count for lanes, count in enumerate(written))})
    return pandas.DataFrame(rows, columns=["draw", "frame", "cycles", "bottleneck",
                                           "fragments"]).set_index("draw")


def traffic(path):
    """Bytes between the units and memory, a row a draw and a column a unit. Of units whose requests
    are a draw's alone, which are the texture units: a line of depths, colors or vertices is many
    draws' in turn."""
    columns = ["unit", "bytes", "draw"]
    table = read_table(file_at(path), "what ffgpu export --format csv writes", columns[:1],
                       columns[1:], usecols=lambda name: name in columns).dropna(subset=["draw"])
    table["draw"] = table["draw"].astype(int)
    return table.pivot_table(index="draw", columns="unit", values="bytes", aggfunc="sum",
                             fill_value=0)


def roofs(path):
    """What no draw exceeds: fragments a cycle, and bytes a cycle of the memory's buses; a memory of
    one latency (memory.kind=fixed) has none, and any number of bytes."""
    machine = configuration(path)
    memory_clocks = machine["memory.memory_clocks"] / machine["memory.core_clocks"]
    bus_bytes = machine["memory.channels"] * machine["memory.bytes_per_cycle"] * memory_clocks
    return {"fragments_per_cycle": 4 * machine["raster.quads_per_cycle"] /
            machine["fragment.quad_cycles"],
            "bytes_per_cycle": math.inf if machine["memory.kind"] == "fixed" else bus_bytes}
