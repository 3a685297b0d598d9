"""The Verilated fragment pipe built apart from the build tree: with other parameters, or of other
sources. A tree like the build's stands in a folder, with the programs that take the pipe from it."""
import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

Root = Path(__file__).resolve().parents[2]
Rtl = Root / "rtl"
Packages = ["ffgpu_registers_pkg", "ffgpu_pkg", "ffgpu_texture_pkg", "ffgpu_pipe_pkg"]


def build_tree(folder, build, rtl=Rtl, options=(), sources=(), host=(), optimise="-O2"):
    """`options` of Verilator's, SystemVerilog `sources` and C++ files of the `host` beside its own;
    programs are those of the tree `build`."""
    verilated = folder / "verilated"
    files = [Rtl / "lint.vlt", *(rtl / f"{package}.sv" for package in Packages),
             rtl / "fragment_pipe.sv", Rtl / "pipe/pipe_ports.sv", Rtl / "pipe/pipe_activity.sv",
             *sources]
    subprocess.run(["verilator", "--cc", "-Wno-lint", "-Wno-fatal", "-O3", "--top-module",
                    "pipe_ports", "--prefix", "Vfragment_pipe", "-y", str(rtl), "--Mdir",
                    str(verilated), *options, *map(str, files)], check=True)
    include = Path("/usr/share/verilator/include")
    cpp = [*verilated.glob("*.cpp"), include / "verilated.cpp", include / "verilated_threads.cpp",
           *(Rtl / "pipe").glob("*.cpp"), *host]
    flags = ["-std=c++20", optimise, "-fPIC", "-ffp-contract=off", f"-I{include}",
             f"-I{include}/vltstd", f"-I{verilated}", f"-I{Root}", "-c"]

    def compile_one(file):
        output = verilated / (file.name + ".o")
        subprocess.run(["g++", *flags, str(file), "-o", str(output)], check=True)
        return str(output)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        objects = list(pool.map(compile_one, cpp))
    libraries = folder / "driver/GL"
    libraries.mkdir(parents=True, exist_ok=True)
    subprocess.run(["g++", "-shared", "-o", str(libraries / "ffgpu_pipe.so"), *objects, "-lfmt",
                    "-pthread"], check=True)
    for program in ("tests/rtl_pipe_test", "tests/rtl_pipe_blind_test", "tools/ffgpu"):
        (folder / program).parent.mkdir(exist_ok=True)
        if (build / program).exists():
            shutil.copy(build / program, folder / program)
