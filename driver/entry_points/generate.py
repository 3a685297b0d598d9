#!/usr/bin/env python3
"""Writes driver/entry_points/commands.inc from the Khronos registry (Debian package khronos-api).

    driver/entry_points/generate.py [/usr/share/khronos-api/gl.xml] > driver/entry_points/commands.inc

Each command of OpenGL 1.0 to 1.5 and of the extensions below becomes one row, in alphabetical order:

    GL_COMMAND(return type, Name, (parameters), (arguments), Compiled | Immediate)
    GL_ALIAS(return type, Name, (parameters), (arguments), TheCommandItEquals)

Immediate: executed at once even while a display list is compiled (GL 1.5, section 5.4).
"""
import re
import sys
import xml.etree.ElementTree as ET

EXTENSIONS = """
ARB_copy_buffer ARB_draw_elements_base_vertex ARB_framebuffer_object ARB_map_buffer_range ARB_multisample ARB_multitexture
ARB_occlusion_query ARB_point_parameters ARB_provoking_vertex ARB_sync ARB_texture_compression ARB_texture_storage
ARB_transpose_matrix ARB_vertex_array_object ARB_vertex_buffer_object ARB_window_pos
ARB_internalformat_query ARB_sampler_objects ARB_clear_texture KHR_debug EXT_debug_marker EXT_debug_label
APPLE_vertex_array_object APPLE_object_purgeable ATI_separate_stencil EXT_bindable_uniform_none
EXT_blend_color EXT_blend_equation_separate EXT_blend_func_separate EXT_blend_minmax EXT_compiled_vertex_array
EXT_copy_texture EXT_depth_bounds_test EXT_draw_range_elements EXT_fog_coord EXT_framebuffer_blit
EXT_framebuffer_multisample EXT_framebuffer_object EXT_multi_draw_arrays EXT_point_parameters EXT_polygon_offset
EXT_polygon_offset_clamp EXT_provoking_vertex EXT_secondary_color EXT_stencil_two_side EXT_subtexture EXT_texture3D
EXT_texture_object EXT_vertex_array GREMEDY_string_marker MESA_window_pos NV_point_sprite NV_primitive_restart
SGIS_point_parameters_none ATI_meminfo_none EXT_texture_perturb_normal_none NV_texture_barrier_none ARB_robustness_none
""".split()
EXTENSIONS = [e for e in EXTENSIONS if not e.endswith("_none")]
# Left out until something needs them.
EXTENSIONS = [e for e in EXTENSIONS if e not in (
    "ARB_sync", "ARB_sampler_objects", "ARB_clear_texture", "KHR_debug", "EXT_debug_marker", "EXT_debug_label",
    "ARB_internalformat_query", "ARB_texture_storage", "APPLE_object_purgeable")]

IMMEDIATE = set("""
AreTexturesResident ArrayElement_no BindBuffer BindFramebuffer BindFramebufferEXT BindRenderbuffer BindRenderbufferEXT
BindVertexArray BlitFramebuffer_no BufferData BufferSubData CheckFramebufferStatus ClientActiveTexture ColorPointer
CopyBufferSubData DeleteBuffers DeleteFramebuffers DeleteLists DeleteQueries DeleteRenderbuffers DeleteTextures
DeleteVertexArrays DisableClientState EdgeFlagPointer EnableClientState EndList FeedbackBuffer Finish Flush
FlushMappedBufferRange FogCoordPointer FramebufferRenderbuffer FramebufferTexture1D FramebufferTexture2D
FramebufferTexture3D FramebufferTextureLayer GenBuffers GenFramebuffers GenLists GenQueries GenRenderbuffers GenTextures
GenVertexArrays GenerateMipmap IndexPointer InterleavedArrays IsBuffer IsEnabled IsFramebuffer IsList IsQuery
IsRenderbuffer IsTexture IsVertexArray LockArraysEXT MapBuffer MapBufferRange NewList NormalPointer PixelStoref
PixelStorei PopClientAttrib PushClientAttrib ReadPixels RenderMode RenderbufferStorage RenderbufferStorageMultisample
SecondaryColorPointer SelectBuffer StringMarkerGREMEDY TexCoordPointer UnlockArraysEXT UnmapBuffer VertexPointer
GetError GetString GetStringi DeleteTexturesEXT GenTexturesEXT IsTextureEXT AreTexturesResidentEXT
ColorPointerEXT EdgeFlagPointerEXT IndexPointerEXT NormalPointerEXT TexCoordPointerEXT VertexPointerEXT
""".split())


def text_of(element, without=()):
    return "".join(element.itertext())


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else "/usr/share/khronos-api/gl.xml"
    root = ET.parse(path).getroot()
    commands = {}
    for c in root.find("commands"):
        proto = c.find("proto")
        name = proto.find("name").text
        returned = re.sub(r"\s+", " ", text_of(proto)[: -len(name)]).strip()
        params = []
        for p in c.findall("param"):
            pname = p.find("name").text
            full = re.sub(r"\s+", " ", text_of(p)).strip()
            params.append((re.sub(r"\s*\*\s*", " *", full[: full.rindex(pname)]).strip(), pname))
        alias = c.find("alias")
        commands[name] = (returned, params, alias.get("name") if alias is not None else None)

    wanted = {}
    for f in root.findall("feature"):
        if f.get("api") == "gl" and f.get("name") in {f"GL_VERSION_1_{i}" for i in range(6)}:
            for r in f.findall("require"):
                wanted.update({c.get("name"): True for c in r.findall("command")})
    core = set(wanted)
    for e in root.find("extensions"):
        if e.get("name")[3:] in EXTENSIONS:
            for r in e.findall("require"):
                if r.get("api", "gl") == "gl":
                    wanted.update({c.get("name"): True for c in r.findall("command")})

    print("// Made by driver/entry_points/generate.py from the Khronos registry. Not edited by hand.")
    for name in sorted(wanted):
        returned, params, alias = commands[name]
        while alias and commands.get(alias, (0, 0, None))[2]:
            alias = commands[alias][2]
        if name in core or alias not in wanted:
            alias = None
        short = name[2:]
        declared = ", ".join(f"{t}{'' if t.endswith('*') else ' '}{n}" for t, n in params)
        arguments = ", ".join(n for _, n in params)
        if alias:
            print(f"GL_ALIAS({returned}, {short}, ({declared}), ({arguments}), {alias[2:]})")
        else:
            base = re.sub(r"(ARB|EXT|ATI|NV|MESA|APPLE)$", "", short)
            now = short in IMMEDIATE or base in IMMEDIATE or short.startswith("Get")
            print(f"GL_COMMAND({returned}, {short}, ({declared}), ({arguments}), {'Immediate' if now else 'Compiled'})")


main()
