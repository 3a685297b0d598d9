"""The stages from texture on: a picture, rows of figures and a worked example each."""

from canvas import beside
from scene import fragments
from stages_front import busy, lines_of, percent

FAR, WALL, FENCE, SHADOW, GLASS = (2, 140), (250, 90), (236, 150), (225, 145), (160, 165)


def fragment_at(scene, pixel, wanted):
    """The text of the last fragment of a pixel's history that holds the words."""
    found = [f[3] for f in fragments(scene.explained(*pixel)) if wanted in f[3]]
    return found[-1]


def level_of_detail(scene):
    frame, far = scene.frame, fragment_at(scene, FAR, "texture 0")
    quads = frame["texture_quads"]
    rows = [("quads that read a texture", quads),
            ("bilinear samples a quad", f"{frame['texture_bilinear_samples'] / quads:.2f}")]
    return scene.picture("heat_level"), rows, lines_of(far, "texture", "derivatives", "footprint", "level 0, next")


def texel_cache(scene):
    frame = scene.frame
    lookups, misses = frame["texel_cache_accesses"], frame["texel_cache_misses"]
    fetched, texels = frame["memory_texture_read_bytes"], frame["texture_texel_reads"]
    kinds = [(f"misses that are {kind}", percent(frame[f"texel_cache_{kind}_misses"], misses))
             for kind in ("compulsory", "capacity", "conflict")]
    rows = [("texels read", texels),
            ("look-ups: lines that a quad reads", lookups),
            ("of them hits", percent(frame["texel_cache_hits"], lookups)), *kinds,
            ("bytes from memory", fetched), ("bytes from memory a texel read", f"{fetched / texels:.3f}"),
            ("cycles in which the texture unit waits for memory", frame["texture_stalled_memory_cycles"])]
    return scene.picture("heat_texture_misses"), rows, ""


def filtering(scene):
    frame, far = scene.frame, fragment_at(scene, FAR, "texture 0")
    textured = frame["texture_bilinear_samples"]
    rows = [("bilinear samples of quads", textured),
            ("texels read for one, up to 4 in each of 4 pixels", f"{frame['texture_texel_reads'] / textured:.2f}"),
            busy(scene, "texture")]
    begin, second = far.index("     probe 0"), far.index("     probe 1")
    rest = lines_of(far[second:], "of both levels", "sample")
    return scene.footprint(*FAR), rows, lines_of(far[begin:second], "") + "\n" + rest


def environments(scene):
    panels = [scene.picture(name).crop(88, 52, 200, 90).magnified(2)
              for name in ("view_untextured", "view_texcoord", "frame")]
    wall = fragment_at(scene, WALL, "environment 1")
    rows = [busy(scene, "fragment")]
    return beside(*panels), rows, lines_of(wall, "environment", "rgb:", "alpha:")


def fog(scene):
    far = fragment_at(scene, FAR, "fog:")
    return (beside(scene.picture("view_before_fog"), scene.picture("frame")), [busy(scene, "fragment")],
            lines_of(far, "fog", "factor"))


def alpha_test(scene):
    crop = (225, 125, 95, 85)
    killed = scene.picture("heat_alpha_killed")
    fence = fragment_at(scene, FENCE, "alpha test")
    rows = [("fragments ended", scene.frame["fragments_killed_alpha"])]
    return (beside(scene.picture("frame").crop(*crop).magnified(3), killed.crop(*crop).magnified(3)), rows,
            lines_of(fence, "alpha test", "ended"))


def stencil_and_depth(scene):
    frame = scene.frame
    rows = [("fragments ended by the stencil test", frame["fragments_killed_stencil"]),
            ("by the depth test, late", frame["fragments_killed_depth"]),
            ("bytes of depth and stencil read", frame["memory_depth_read_bytes"]),
            ("written", frame["memory_depth_written_bytes"])]
    shadow = fragments(scene.explained(*SHADOW))
    text = "\n\n".join(lines_of(f[3], "stencil", "depth test", "ended")
                       for f in shadow if "stencil test" in f[3])
    return beside(scene.picture("view_depth"), scene.picture("view_stencil")), rows, text


def blend(scene):
    crop = (95, 65, 120, 120)
    glass = fragment_at(scene, GLASS, "blended")
    frame = scene.frame
    rows = [("fragments written", frame["fragments_written"]),
            ("look-ups of the colour cache", frame["color_cache_accesses"]),
            ("of them hits", percent(frame["color_cache_hits"], frame["color_cache_accesses"])),
            ("bytes of colour read", frame["memory_color_read_bytes"]),
            ("written", frame["memory_color_written_bytes"]), busy(scene, "color")]
    return (beside(*(scene.step(draw).crop(*crop).magnified(2) for draw in (5, 6))), rows,
            lines_of(glass, "write", "rgb", "constant"))


def scan_out(scene):
    one, four = scene.frame, scene.multisampled
    crop = (150, 86, 40, 30)
    rows = [("samples covered, of 4 a pixel", four["samples_covered"]),
            ("bytes of colour written with 4 samples", four["memory_color_written_bytes"]),
            ("with 1", one["memory_color_written_bytes"]),
            ("cycles of the frame with 4 samples", four["total_cycles"]),
            ("with 1", one["total_cycles"]),
            ("milliseconds of the frame with 1", f"{one['milliseconds']:.3f}")]
    panels = [scene.picture("frame", run).crop(*crop).magnified(8) for run in ("one", "four")]
    return beside(*panels), rows, ""
