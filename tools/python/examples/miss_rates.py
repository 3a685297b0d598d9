#!/usr/bin/env python3
# %% [markdown]
# # Miss rates of a trace's texel cache, by size and ways
#
#     ffgpu cache traces/corridor.trace -o out/cache
#     tools/python/examples/miss_rates.py out/cache -o miss_rates.png

# %%
from style import arguments, pyplot, read, save

from ffgpu_data import miss_curves

given = arguments("Miss rates by size and ways", ("curves", "the folder of ffgpu cache -o"))
table = read(miss_curves, given.curves)
table = table[(table.client == "texel") & (table.accesses > 0)]
if table.empty:
    raise SystemExit(f"{given.curves}: no texel was looked up: there is nothing to draw")
line = 64 if (table.line_bytes == 64).any() else table.line_bytes.min()
table = table[(table.line_bytes == line) & table["bytes"].between(512, 256 << 10)]
if table.empty:
    raise SystemExit(f"{given.curves}: no cache of 512 bytes to 256 KB: there is nothing to draw")

# %%
# What a run of `ffgpu cache` can vary besides size and ways: an axis each, named by what differs.
KINDS = {"layout": "texture layout: {}", "traversal": "{}", "tile_width": "tiles of {}",
         "granularity": "by {}", "merged": "merged: {}", "level": "level {}"}
kinds = table[list(KINDS)].drop_duplicates()
varied = [name for name in KINDS if name == "layout" or kinds[name].nunique() > 1]
columns = min(3, len(kinds))
rows = -(-len(kinds) // columns)
figure, axes = pyplot.subplots(rows, columns, sharey=True, squeeze=False,
                               figsize=(2 + 4.5 * columns, 4.5 * rows))
for axis in axes.flat[len(kinds):]:
    axis.remove()
for axis, kind in zip(axes.flat, kinds.itertuples(index=False)):
    own = table[(table[list(KINDS)] == list(kind)).all(axis=1)]
    for ways in (1, 2, 4):
        curve = own[(own.ways == ways) & (own.sets > 1)].sort_values("bytes")
        axis.plot(curve["bytes"] / 1024, 100 * curve.miss_rate, marker="o", markersize=3,
                  label=f"{ways} way" + ("s" if ways > 1 else ""))
    powers = own[own.is_full & (own.ways & (own.ways - 1) == 0)].sort_values("bytes")
    axis.plot(powers["bytes"] / 1024, 100 * powers.miss_rate, "--", color="#444444", label="full")
    axis.set_xscale("log", base=2)
    axis.xaxis.set_major_formatter("{x:g}")
    axis.set_title(", ".join(KINDS[name].format(getattr(kind, name)) for name in varied))
    axis.set_xlabel(f"size, KB, lines of {line} bytes")
for row in axes:
    row[0].set_ylim(bottom=0)
    row[0].set_ylabel("misses, % of look-ups")
axes.flat[len(kinds) - 1].legend(frameon=False)
figure.tight_layout()
save(figure, given.output)
