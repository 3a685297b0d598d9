#!/usr/bin/env python3
# %% [markdown]
# # The Pareto front of a design space
#
#     ffgpu sweep space.toml traces/corridor.trace -o out/space
#     tools/python/examples/pareto.py out/space -o pareto.png

# %%
import sys

from matplotlib.ticker import EngFormatter
from style import arguments, pyplot, read, save

from ffgpu_data import pareto_front, sweep

given = arguments("Pareto fronts", ("sweep", "the folder of ffgpu sweep -o"))
table = read(sweep, given.sweep)
if table.empty:
    sys.exit(f"{given.sweep}: no machine of the sweep came to an end")
prices = [("memory_bytes", "bytes of memory traffic"), ("cost", "cost, LUTs")]
prices = [(name, label) for name, label in prices if table[name].notna().all()]

# %%
figure, axes = pyplot.subplots(1, len(prices), sharey=True, squeeze=False,
                               figsize=(1 + 5 * len(prices), 4.5))
for axis, (price, label) in zip(axes[0], prices):
    for number, (trace, own) in enumerate(table.groupby("trace")):
        points = axis.scatter(own[price], own.cycles, s=14, alpha=0.5, color=f"C{number}")
        front = pareto_front(own, price, "cycles")
        axis.step(front[price], front.cycles, where="post", color=points.get_facecolor()[0],
                  alpha=1, label=trace)
        axis.scatter(front[price], front.cycles, s=28, color=f"C{number}", zorder=3)
    axis.set_xlabel(label)
    axis.xaxis.set_major_formatter(EngFormatter())
    axis.yaxis.set_major_formatter(EngFormatter())
axes[0][0].set_ylabel("cycles")
axes[0][-1].legend(frameon=False, title="front of")
save(figure, given.output)
