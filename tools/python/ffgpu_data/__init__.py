"""ffgpu's figures as pandas' tables: no installation, `PYTHONPATH=tools/python`.

    from ffgpu_data import miss_curves, sweep, frames, draws, traffic, pareto_front
"""
from .curves import miss_curves
from .draws import draws, roofs, traffic
from .fronts import pareto_front
from .statistics import configuration, frames
from .sweeps import sweep

__all__ = ["configuration", "draws", "frames", "miss_curves", "pareto_front", "roofs", "sweep",
           "traffic"]
