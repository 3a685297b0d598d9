"""Ports of the modules in rtl/, as their files declare them."""
import re
from pathlib import Path

Rtl = Path(__file__).resolve().parents[2] / "rtl"
Packages = ["ffgpu_registers_pkg", "ffgpu_pkg", "ffgpu_texture_pkg", "ffgpu_pipe_pkg"]


def ports(module):
    """[(input or output, declaration, name)] of a module, its parameters as they are by default."""
    text = (Rtl / f"{module}.sv").read_text()
    header = text[text.index(f"module {module}"):text.index("\n);")]
    for name, value in re.findall(r"parameter int unsigned (\w+) = ([\w:]+)", header):
        header = re.sub(rf"\b(?<!::){name}\b", value, header)
    return re.findall(r"^  (input|output) +(.*?) +(\w+),?(?: *//.*)?$", header, re.M)
