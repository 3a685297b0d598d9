#!/usr/bin/env python3
# %% [markdown]
# # Miss rates of a trace's texel cache, by size and ways
#
#     ffgpu cache traces/corridor.trace -o out/cache
#     tools/python/examples/miss_rates.py out/cache -o miss_rates.png

# %%
from style import arguments, pyplot, save

from ffgpu_data import miss_curves

given = arguments("Miss rates by size and ways", ("curves", "the folder of ffgpu cache -o"))
table = miss_curves(given.curves)
table = table[(table.client == "texel") & (table.line_bytes == 64)]
table = table[table["bytes"].between(512, 256 << 10)]

# %%
layouts = list(table.layout.unique())
figure, axes = pyplot.subplots(1, len(layouts), sharey=True, squeeze=False,
                               figsize=(2 + 4.5 * len(layouts), 4.5))
for axis, layout in zip(axes[0], layouts):
    own = table[table.layout == layout]
    for ways in (1, 2, 4):
        curve = own[(own.ways == ways) & (own.sets > 1)].sort_values("bytes")
        axis.plot(curve["bytes"] / 1024, 100 * curve.miss_rate, marker="o", markersize=3,
                  label=f"{ways} way" + ("s" if ways > 1 else ""))
    powers = own[own.is_full & (own.ways & (own.ways - 1) == 0)].sort_values("bytes")
    axis.plot(powers["bytes"] / 1024, 100 * powers.miss_rate, "--", color="#444444", label="full")
    axis.set_xscale("log", base=2)
    axis.xaxis.set_major_formatter("{x:g}")
    axis.set_title(f"texture layout: {layout}")
    axis.set_xlabel("size, KB")
axes[0][0].set_ylim(bottom=0)
axes[0][0].set_ylabel("misses, % of look-ups")
axes[0][-1].legend(frameon=False)
save(figure, given.output)
