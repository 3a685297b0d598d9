"""stats.json: frames and their counters, and the configuration of the machine."""
import json

import pandas

from .files import file_at

# Figures of a frame's own, in stats.json's order; the last with --timing.
OWN = ["frame", "width", "height", "api_calls", "pixels", "overdraw", "milliseconds"]


def read(path):
    path = file_at(path, "stats.json")
    try:
        with open(path) as file:
            stats = json.load(file)
    except ValueError as error:
        raise ValueError(f"{path}: is not stats.json of a run: {error}") from error
    if not isinstance(stats, dict) or not {"configuration", "frames"} <= stats.keys():
        raise ValueError(f"{path}: is not stats.json of a run: it has no configuration or frames")
    return stats


def frames(path):
    """A row a frame: its own figures, and every counter of the functional and the timed units. Of a
    run without frames stats.json names no counters: the columns are the frame's own figures."""
    rows = []
    stats = read(path)
    for frame in stats["frames"]:
        row = {key: value for key, value in frame.items() if not isinstance(value, (dict, list))}
        row.update(frame["functional"])
        row.update(frame.get("timing", {}))
        rows.append(row)
    own = OWN + ["total_cycles"] if stats["configuration"] else OWN[:-1]
    return pandas.DataFrame(rows, columns=None if rows else own).set_index("frame")


def configuration(path):
    """Every parameter by its path: configuration(DIR)["texel_cache.ways"]."""
    groups = read(path)["configuration"]
    if not groups:
        raise ValueError(f"{path}: tells no configuration: it comes with --timing")
    return {f"{group}.{name}": value
            for group, values in groups.items() for name, value in values.items()}
