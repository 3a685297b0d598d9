"""Pareto fronts of tables."""
import numpy


def pareto_front(table, *columns):
    """The rows of which none is less in one of the columns and no more in the others, by the first
    column."""
    values = table[list(columns)].to_numpy()
    best = numpy.ones(len(values), dtype=bool)
    for i, own in enumerate(values):
        beats = (values <= own).all(axis=1) & (values < own).any(axis=1)
        best[i] = not beats.any()
    return table[best].sort_values(list(columns))
