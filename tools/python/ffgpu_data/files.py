"""Files that tables are made of. One that is not what it should be is a ValueError of one line that
names it; one that cannot be read is the system's OSError."""
import pathlib

import pandas


def file_at(path, name=None):
    """`path`, or the file of this name in it where it is a folder."""
    if not str(path):  # would be the working folder
        raise ValueError(f"'': expected {name + ' or its folder' if name else 'a file'}")
    path = pathlib.Path(path)
    return path / name if name and path.is_dir() else path


def read_table(path, what, names, numbers, **options):
    """The table of a CSV file, which is `what`: of its columns these are there, and `numbers` hold
    numbers, also where there is no row."""
    try:
        table = pandas.read_csv(path, **options)
    except ValueError as error:
        raise ValueError(f"{path}: is not {what}: {' '.join(str(error).split())}") from error
    for name in [*names, *numbers]:
        if name not in table:
            raise ValueError(f"{path}: is not {what}: it has no column {name}")
    for name in numbers:
        try:
            table[name] = pandas.to_numeric(table[name])
        except (TypeError, ValueError) as error:
            raise ValueError(f"{path}: is not {what}: {name}: {error}") from error
    return table
