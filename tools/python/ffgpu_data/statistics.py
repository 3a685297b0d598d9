"""stats.json: frames and their counters, and the configuration of the machine."""
import json
import pathlib

import pandas


def read(path):
    path = pathlib.Path(path)
    with open(path / "stats.json" if path.is_dir() else path) as file:
        return json.load(file)


def frames(path):
    """A row a frame: its own figures, and every counter of the functional and the timed units."""
    rows = []
    for frame in read(path)["frames"]:
        row = {key: value for key, value in frame.items() if not isinstance(value, (dict, list))}
        row.update(frame["functional"])
        row.update(frame.get("timing", {}))
        rows.append(row)
    return pandas.DataFrame(rows).set_index("frame")


def configuration(path):
    """Every parameter by its path: configuration(DIR)["texel_cache.ways"]."""
    groups = read(path)["configuration"]
    return {f"{group}.{name}": value
            for group, values in groups.items() for name, value in values.items()}
