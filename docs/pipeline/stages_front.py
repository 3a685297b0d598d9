"""The stages up to the interpolator: a picture, rows of figures and a worked example each."""

import re

from canvas import BLACK, WHITE, Canvas, beside, grid
from scene import NUMBER, fragments, numbers

BALL, COLORS, FLOOR = 0, 1, 2  # the frame's draws
SPHERE, TRIANGLE = (206, 118), (60, 150)  # pixels that show them
SMALL = (196, 106, 26, 20)  # a part of the sphere: x, y, width, height
RED, BLUE, YELLOW = (200, 30, 30), (60, 90, 200), (250, 220, 90)


def lines_of(paragraph, *beginnings):
    """Those lines of a fragment's history, as a worked example."""
    return "\n".join(line[3:] for line in paragraph.splitlines() if line.strip().startswith(beginnings))


def percent(part, whole):
    return f"{100 * part / whole:.1f} %"


def busy(scene, unit):
    return (f"cycles in which the timed unit `{unit}` works, of {scene.frame['total_cycles']:,}",
            scene.frame[f"{unit}_busy_cycles"])


def scene_as_a_whole(scene):
    frame = scene.frame
    units = ("vertex_fetch", "geometry", "clip", "setup", "raster", "depth", "texture", "fragment", "color")
    rows = [("draws", frame["draw_commands"]), ("vertices", frame["vertex_vertices"]),
            ("primitives", frame["primitives_in"]), ("fragments covered", frame["fragments_covered"]),
            ("fragments written", frame["fragments_written"]), ("texels read", frame["texture_texel_reads"]),
            ("cycles", frame["total_cycles"]), ("milliseconds", f"{frame['milliseconds']:.3f}"),
            *[(f"of the cycles the timed unit `{unit}` works in",
               percent(frame[f"{unit}_busy_cycles"], frame["total_cycles"])) for unit in units]]
    what = ("the sphere", "the triangle", "the floor", "the wall", "the fence", "the shadow", "the glass")
    columns = ("primitives", "fragments_covered", "fragments_written", "texel_reads", "texel_cache_misses", "cycles")
    lines = ["| draw | primitives | covered | written | texels read | lines missed | cycles | waits most for |",
             "|---|" + 6 * "---:|" + "---|"]
    for name, draw in zip(what, scene.draws(), strict=True):
        cells = [f"{int(draw[column]):,}" for column in columns]
        lines.append(f"| {name} | {' | '.join(cells)} | {draw['bottleneck']} |")
    return scene.picture("frame"), rows, "\n".join(lines) + "\n"


def vertex_fetch(scene):
    frame, edges = scene.frame, scene.picture("view_wireframe")
    lookups = frame["vertex_cache_accesses"]
    rows = [("vertices of all draws, as indexed", frame["vertex_vertices"]),
            ("of them transformed before, and used again", frame["vertex_reused"]),
            ("look-ups of the vertex cache", lookups),
            ("of them hits", percent(frame["vertex_cache_hits"], lookups)),
            ("bytes of vertices read from memory", frame["memory_vertex_read_bytes"]),
            ("bytes of indices read from memory", frame["memory_index_read_bytes"]),
            busy(scene, "vertex_fetch")]
    return beside(edges, edges.crop(140, 80, 90, 80).magnified(3)), rows, ""


def transform_and_lighting(scene):
    frame = scene.frame
    text = scene.explained(*SPHERE)
    found = [f for f in fragments(text) if f[0] == scene.first_draw + BALL]
    panels = [scene.picture(name).crop(135, 60, 110, 110).magnified(2)
              for name in ("view_normals", "view_unlit", "frame")]
    rows = [("different vertices of the draws", frame["vertices_shaded"]),
            (f"vertices transformed and lit, with a list of {scene.machine['vertex']['reuse_entries']}",
             frame["vertex_shaded"]), busy(scene, "geometry")]
    return beside(*panels), rows, lines_of(found[0][3], "vertex")


def corners(paragraph):
    """The window positions of a fragment's primitive, y up."""
    found = re.findall(rf"vertex \d+: \(({NUMBER}), ({NUMBER})\)", paragraph)
    return [(float(x), float(y)) for x, y in found]


def clipping(scene):
    """The floor's pieces, to scale: a picture's pixel is 32 pixels of the window's plane."""
    pieces = {}
    for top in (138, 145, 237):  # near the horizon, where all pieces meet, and below
        for text in sum(scene.region(0, top, 320, 3), []):
            for draw, primitive, piece, paragraph in fragments(text):
                if draw == scene.first_draw + FLOOR:
                    pieces[primitive, piece] = corners(paragraph)
    band, scale = 8192, 32
    plane = Canvas(2 * band // scale, 2 * band // scale, (235, 235, 235))

    def shown(x, y):
        return int((x + band) / scale), int((band - y) / scale)

    for points in pieces.values():
        plane.outline([shown(*point) for point in points], BLUE)
    left, top = shown(0, 240)
    plane.fill(left, top, 320 // scale, 240 // scale, RED)
    frame = scene.frame
    reach = max(abs(value) for points in pieces.values() for point in points for value in point)
    rows = [("primitives that some plane cuts", frame["primitives_clipped"]),
            ("planes that they are cut by, one after the other", frame["clip_planes"]),
            ("primitives with nothing inside", frame["primitives_outside"]),
            ("pieces of the floor in the picture", len(pieces)),
            ("their farthest coordinate, in pixels", f"{reach:,.0f}"),
            busy(scene, "clip")]
    return plane.crop(0, 200, 2 * band // scale, 140), rows, ""


def small_triangles(scene):
    """Of a part of the sphere: rows of pixels, each with the fragments that the first draw has there."""
    x, y, width, height = SMALL
    return [[[f for f in fragments(text) if f[0] == scene.first_draw + BALL] for text in row]
            for row in scene.region(x, y, width, height)]


def middle_fragment(cells):
    [found] = cells[len(cells) // 2][len(cells[0]) // 2]
    return found


def triangle_set_up(scene):
    cells = small_triangles(scene)
    found = middle_fragment(cells)
    points, cell = corners(found[3]), 16
    x, y, width, height = SMALL
    box = [min(p[0] for p in points), max(p[0] for p in points),
           240 - max(p[1] for p in points), 240 - min(p[1] for p in points)]

    def color(column, row):
        if any(f[1:3] == found[1:3] for f in cells[row][column]):
            return YELLOW
        within = (box[0] <= x + column + 1 and x + column <= box[1] and
                  box[2] <= y + row + 1 and y + row <= box[3])
        return (215, 225, 245) if within else WHITE

    picture = grid(width, height, cell, color)
    picture.outline([((px - x) * cell, (240 - py - y) * cell) for px, py in points], RED)
    frame = scene.frame
    rows = [("primitives that come", frame["primitives_in"]),
            ("of them facing away, and culled", frame["primitives_culled"]),
            ("of them without area", frame["primitives_degenerate"]),
            ("primitives set up", frame["primitives_set_up"]),
            ("of them without a pixel centre inside", frame["primitives_empty"]),
            busy(scene, "setup")]
    return picture, rows, lines_of(found[3], "vertex", "edges")


def coverage(scene):
    cells = small_triangles(scene)

    def color(column, row):
        if not cells[row][column]:
            return WHITE
        _, primitive, piece, _ = cells[row][column][0]
        return tuple(70 + (primitive * step + 31 * piece) % 170 for step in (37, 91, 53))

    owners = grid(SMALL[2], SMALL[3], 12, color)
    frame = scene.frame
    lanes = frame["histograms"]["quad_lanes_covered"]
    rows = [("fragments covered", frame["fragments_covered"]), ("quads of 2x2 pixels", frame["quads"]),
            *[(f"quads with {i} of 4 covered", percent(lanes[i], frame["quads"])) for i in (1, 2, 3, 4)],
            ("blocks of 8x8 pixels walked", frame["raster_blocks"] + frame["raster_empty_blocks"]),
            ("of them without a pixel", frame["raster_empty_blocks"]), busy(scene, "raster")]
    return beside(owners, scene.picture("heat_covered")), rows, ""


def interpolation(scene):
    x, y, width, height = 10, 62, 64, 64
    panels = [Canvas(width, height, BLACK) for _ in range(2)]
    for row, texts in enumerate(scene.region(x, y, width, height)):
        for column, text in enumerate(texts):
            for draw, _, _, paragraph in fragments(text):
                if draw == scene.first_draw + COLORS:
                    weights = [round(255 * weight) for weight in numbers(paragraph, "weights")]
                    panels[0].put(column, row, weights[:3])
                    panels[1].put(column, row, weights[3:])
    [found, *_] = fragments(scene.explained(*TRIANGLE))
    shares = numbers(found[3], "weights")
    rows = [("the red corner's share at the pixel of the example, by area", f"{shares[0]:.3f}"),
            ("the same with perspective", f"{shares[3]:.3f}"),
            ("fragments interpolated", scene.frame["fragments_covered"] -
             scene.frame["fragments_killed_early_depth"])]
    return (beside(*(panel.magnified(4) for panel in panels)), rows,
            lines_of(found[3], "vertex", "weights", "1/w", "primary"))


def early_depth(scene):
    frame = scene.frame
    rows = [("fragments covered", frame["fragments_covered"]),
            ("ended before anything was made of them", frame["fragments_killed_early_depth"]),
            ("ended by the depth test later", frame["fragments_killed_depth"]),
            ("look-ups of the depth cache", frame["depth_cache_accesses"]),
            ("of them hits", percent(frame["depth_cache_hits"], frame["depth_cache_accesses"])),
            busy(scene, "depth")]
    late = [f for f in fragments(scene.explained(*TRIANGLE)) if "ended at the early depth test" in f[3]]
    return scene.picture("heat_depth_killed"), rows, lines_of(late[0][3], "weights", "depth", "early", "ended")
