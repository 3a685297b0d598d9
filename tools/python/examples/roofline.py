#!/usr/bin/env python3
# %% [markdown]
# # A roofline of draws
#
# Fragments that a draw wrote a cycle, against those a byte of texels that it read: under the slope
# the memory's buses bound it, if it read nothing else; under the flat roof the fragment pipes do.
#
#     ffgpu replay traces/corridor.trace -o out/corridor --timing --save-work corridor.ffw
#     ffgpu export corridor.ffw --format csv -o corridor.csv
#     tools/python/examples/roofline.py out/corridor corridor.csv -o roofline.png

# %%
import numpy
from matplotlib.ticker import NullFormatter
from style import COLORS, arguments, pyplot, read, save

from ffgpu_data import draws, roofs, traffic

given = arguments("A roofline of draws", ("run", "the folder of ffgpu replay --timing -o"),
                  ("memory", "what ffgpu export --format csv wrote"))
table = read(draws, given.run)
table["bytes"] = read(traffic, given.memory).sum(axis=1).reindex(table.index)
table = table[(table.fragments > 0) & (table["bytes"] > 0)]
if table.empty:
    raise SystemExit("roofline: no draw of the run writes fragments and reads texels from memory")
intensity, speed = table.fragments / table["bytes"], table.fragments / table.cycles
roof = read(roofs, given.run)

# %%
figure, axis = pyplot.subplots()
ridge = roof["fragments_per_cycle"] / roof["bytes_per_cycle"]
ridges = [ridge] if ridge > 0 else [] # A memory without buses has no slope.
reach = numpy.geomspace(min([intensity.min(), *ridges]) / 2,
                        max([intensity.max(), *ridges]) * 4, 100)
axis.plot(reach, numpy.minimum(reach * roof["bytes_per_cycle"], roof["fragments_per_cycle"]),
          color="#222222", label=f"{roof['bytes_per_cycle']:g} bytes, "
          f"{roof['fragments_per_cycle']:g} fragments a cycle")
for color, (name, own) in zip(COLORS * 3, table.groupby("bottleneck")):
    axis.scatter(intensity[own.index], speed[own.index], color=color, alpha=0.7,
                 s=12 + 60 * own.cycles / table.cycles.max(), label=name.replace("_", " "))
axis.set_xscale("log", base=2)
axis.set_yscale("log", base=2)
for side in (axis.xaxis, axis.yaxis):
    side.set_major_formatter("{x:g}")
    side.set_minor_formatter(NullFormatter())
axis.set_ylim(speed.min() / 2, 2 * roof["fragments_per_cycle"])
axis.set_xlabel("fragments written a byte of texels read")
axis.set_ylabel("fragments written a cycle")
axis.set_title("Draws by their bottleneck; the larger, the more cycles")
axis.legend(frameon=False, loc="lower left", markerscale=0.8)
save(figure, given.output)
