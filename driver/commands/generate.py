#!/usr/bin/env python3
"""Writes the lists of entry points from the Khronos registry (Debian package khronos-api):

    driver/commands/generate.py commands > driver/commands/commands.inc
    driver/commands/generate.py arrays   > driver/commands/array_lengths.inc
    driver/commands/generate.py later    > driver/window_system/exports/later_commands.inc
    driver/commands/generate.py origins  > driver/commands/command_origins.inc

commands.inc: each command of OpenGL 1.0 to 1.5 and of the extensions below, in alphabetical order:

    GL_COMMAND(return type, Name, (parameters), (arguments), Class)
    GL_ALIAS(return type, Name, (parameters), (arguments), TheCommandItEquals)

Class says how a command meets glBegin/glEnd and display lists (GL 1.5, sections 2.6.3 and 5.4):

    Immediate  executed at once even while a list is compiled; an error between glBegin and glEnd
    Compiled   recorded in a list that is being compiled; an error between glBegin and glEnd
    Inside     recorded; allowed between glBegin and glEnd (CallList, Material, EvalCoord)
    Vertex     glBegin, glEnd and what a vertex is made of: assembled into vertices, in lists too

array_lengths.inc: the recorded commands with array arguments whose length the registry gives,
elements an array:

    GL_ARRAYS(Name, (parameters), elements)
later_commands.inc: the other commands of OpenGL 1.0 to 4.6 and of the ARB's and EXT extensions,
which programs may be linked with:

    GL_LATER_COMMAND(Name)

command_origins.inc: of each command that is in none of OpenGL 1.0 to 1.5 where it comes from: an extension of the
list below, else a later version, else another extension:

    GL_ORIGIN(Name, "GL_EXT_texture3D")
"""
import re
import sys
import xml.etree.ElementTree as ET

EXTENSIONS = """
ARB_copy_buffer ARB_draw_buffers ARB_draw_elements_base_vertex ARB_framebuffer_object ARB_map_buffer_range ARB_multisample ARB_multitexture
ARB_occlusion_query ARB_point_parameters ARB_provoking_vertex ARB_sync ARB_texture_compression ARB_texture_storage
ARB_transpose_matrix ARB_vertex_array_object ARB_vertex_buffer_object ARB_window_pos
ARB_internalformat_query ARB_sampler_objects ARB_clear_texture KHR_debug EXT_debug_marker EXT_debug_label
APPLE_vertex_array_object APPLE_object_purgeable ATI_draw_buffers ATI_separate_stencil
EXT_blend_color EXT_blend_equation_separate EXT_blend_func_separate EXT_blend_minmax EXT_compiled_vertex_array
EXT_copy_texture EXT_depth_bounds_test EXT_draw_range_elements EXT_fog_coord EXT_framebuffer_blit
EXT_framebuffer_multisample EXT_framebuffer_object EXT_multi_draw_arrays EXT_point_parameters EXT_polygon_offset
EXT_polygon_offset_clamp EXT_provoking_vertex EXT_secondary_color EXT_stencil_two_side EXT_subtexture EXT_texture3D
EXT_texture_object EXT_vertex_array GREMEDY_string_marker MESA_window_pos NV_point_sprite NV_primitive_restart
""".split()
# Left out until something needs them.
EXTENSIONS = [e for e in EXTENSIONS if e not in (
    "ARB_sync", "ARB_sampler_objects", "ARB_clear_texture", "KHR_debug", "EXT_debug_marker", "EXT_debug_label",
    "ARB_internalformat_query", "ARB_texture_storage", "APPLE_object_purgeable")]

# Of later versions: what commands of the extensions above are other names of.
LATER_NAMES = {"glDrawBuffers"}

CORE_VERSIONS = {f"GL_VERSION_1_{i}" for i in range(6)}

IMMEDIATE = set("""
AreTexturesResident BindBuffer BindFramebuffer BindFramebufferEXT BindRenderbuffer BindRenderbufferEXT
BindVertexArray BufferData BufferSubData CheckFramebufferStatus ClientActiveTexture ColorPointer
CopyBufferSubData DeleteBuffers DeleteFramebuffers DeleteLists DeleteQueries DeleteRenderbuffers DeleteTextures
DeleteVertexArrays DisableClientState EdgeFlagPointer EnableClientState EndList FeedbackBuffer Finish Flush
FlushMappedBufferRange FogCoordPointer FramebufferRenderbuffer FramebufferTexture1D FramebufferTexture2D
FramebufferTexture3D FramebufferTextureLayer GenBuffers GenFramebuffers GenLists GenQueries GenRenderbuffers GenTextures
GenVertexArrays GenerateMipmap IndexPointer InterleavedArrays IsBuffer IsEnabled IsFramebuffer IsList IsQuery
IsRenderbuffer IsTexture IsVertexArray LockArraysEXT MapBuffer MapBufferRange NewList NormalPointer PixelStoref
PixelStorei PopClientAttrib PushClientAttrib ReadPixels RenderMode RenderbufferStorage RenderbufferStorageMultisample
SecondaryColorPointer SelectBuffer StringMarkerGREMEDY TexCoordPointer UnlockArraysEXT UnmapBuffer VertexPointer
GetError GetString GetStringi DeleteTexturesEXT GenTexturesEXT IsTextureEXT AreTexturesResidentEXT
PrimitiveRestartIndexNV
ColorPointerEXT EdgeFlagPointerEXT IndexPointerEXT NormalPointerEXT TexCoordPointerEXT VertexPointerEXT
""".split())


VERTEX = re.compile(
    "((Vertex|Color|SecondaryColor|Normal|TexCoord|MultiTexCoord)[1-4](b|s|i|f|d|ub|us|ui)v?"
    "|FogCoord[fd]v?|Index(d|f|i|s|ub)v?|EdgeFlagv?|Begin|End|ArrayElement|PrimitiveRestartNV)$")
INSIDE = re.compile("(CallLists?|Material[fi]v?|EvalCoord[12][fd]v?|EvalPoint[12])$")


def class_of(short):
    base = re.sub(r"(ARB|EXT|ATI|NV|MESA|APPLE)$", "", short)
    if short in IMMEDIATE or base in IMMEDIATE or short.startswith("Get"):
        return "Immediate"
    if VERTEX.match(short):
        return "Vertex"
    return "Inside" if INSIDE.match(short) else "Compiled"


def text_of(element):
    return re.sub(r"\s+", " ", "".join(element.itertext())).strip()


class Command:
    def __init__(self, element):
        proto = element.find("proto")
        self.name = proto.find("name").text
        self.returned = text_of(proto)[: -len(self.name)].strip()
        self.parameters = []  # (type, name)
        self.lengths = []  # of the arrays among them
        for parameter in element.findall("param"):
            name = parameter.find("name").text
            full = text_of(parameter)
            self.parameters.append(
                (re.sub(r"\s*\*\s*", " *", full[: full.rindex(name)]).strip(), name))
            if "*" in full:
                self.lengths.append(parameter.get("len"))
        alias = element.find("alias")
        self.alias = alias.get("name") if alias is not None else None

    def declared(self):
        return ", ".join(f"{t}{'' if t.endswith('*') else ' '}{n}" for t, n in self.parameters)

    def arguments(self):
        return ", ".join(n for _, n in self.parameters)


def read_registry(path):
    """The wanted commands in alphabetical order; `alias` is set only where it is one of them."""
    root = ET.parse(path).getroot()
    commands = {c.name: c for c in map(Command, root.find("commands"))}
    core, wanted = set(), set()
    for feature in root.findall("feature"):
        if feature.get("api") == "gl" and feature.get("name") in CORE_VERSIONS:
            core.update(c.get("name") for r in feature.findall("require") for c in r.findall("command"))
    for extension in root.find("extensions"):
        if extension.get("name")[3:] in EXTENSIONS:
            for r in extension.findall("require"):
                if r.get("api", "gl") == "gl":
                    wanted.update(c.get("name") for c in r.findall("command"))
    wanted |= core | LATER_NAMES
    for name in wanted:
        command = commands[name]
        while command.alias and commands.get(command.alias) and commands[command.alias].alias:
            command.alias = commands[command.alias].alias
        if name in core or command.alias not in wanted:
            command.alias = None
    return [commands[name] for name in sorted(wanted)]


def print_commands(commands):
    for c in commands:
        last = c.alias[2:] if c.alias else class_of(c.name[2:])
        macro = "GL_ALIAS" if c.alias else "GL_COMMAND"
        print(f"{macro}({c.returned}, {c.name[2:]}, ({c.declared()}), ({c.arguments()}), {last})")


def print_array_lengths(commands):
    for c in commands:
        lengths = set(c.lengths)
        if c.alias or len(lengths) != 1 or class_of(c.name[2:]) not in ("Compiled", "Inside"):
            continue
        length = lengths.pop().replace("COMPSIZE(pname)", "parameter_count(pname)")
        if "COMPSIZE" not in length and not c.name.startswith("glMultiDraw"):
            print(f"GL_ARRAYS({c.name[2:]}, ({c.declared()}), {length})")


def print_later_commands(path):
    known = {c.name for c in read_registry(path)}
    root = ET.parse(path).getroot()
    groups = [f for f in root.findall("feature") if f.get("api") == "gl"]
    groups += [e for e in root.find("extensions")
               if re.match("GL_(ARB|EXT)_", e.get("name")) and re.search(r"\bgl\b", e.get("supported"))]
    later = {c.get("name") for g in groups for r in g.findall("require") for c in r.findall("command")}
    for name in sorted(later - known):
        print(f"GL_LATER_COMMAND({name[2:]})")


def print_origins(path):
    root = ET.parse(path).getroot()
    features = [f for f in root.findall("feature") if f.get("api") == "gl"]
    extensions = [e for e in root.find("extensions") if re.search(r"\bgl\b", e.get("supported"))]
    ours = [e for e in extensions if e.get("name")[3:] in EXTENSIONS]
    core = [f for f in features if f.get("name") in CORE_VERSIONS]

    def names(group):
        return [c.get("name") for r in group.findall("require") for c in r.findall("command")]
    origin = {name: None for group in core for name in names(group)}
    for group in ours + features + extensions:
        for name in names(group):
            origin.setdefault(name, group.get("name"))
    for name in sorted(n for n in origin if origin[n]):
        print(f'GL_ORIGIN({name[2:]}, "{origin[name]}")')


def main():
    what = sys.argv[1] if len(sys.argv) > 1 else "commands"
    path = sys.argv[2] if len(sys.argv) > 2 else "/usr/share/khronos-api/gl.xml"
    print("// Made by driver/commands/generate.py from the Khronos registry. Not edited by hand.")
    if what == "later":
        return print_later_commands(path)
    if what == "origins":
        return print_origins(path)
    {"commands": print_commands, "arrays": print_array_lengths}[what](read_registry(path))


main()
