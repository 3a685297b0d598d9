# The flow of `ffgpu sweep`: a functional run a trace, then a timing job a machine and trace.
# plan.json says what is missing; each file comes to its name whole, by a rename.
#
# Snakemake removes the outputs of a job before it runs it, also of one that a cluster starts again
# after it was done, and sets the times of those that it finds made. So its outputs are marks, empty
# files; results and work files are make_once.sh's.
import json
import os

with open("plan.json") as file:
    plan = json.load(file)

once = os.path.join(workflow.basedir, "make_once.sh")

localrules: all

rule all:
    input: ["marks/results/%s" % job for job in plan["missing"]]

def trace_of(wildcards):
    return plan["traces"][wildcards.trace]

def work_of(wildcards):
    return trace_of(wildcards)["work"]

# Whoever waits for a work file waits for its mark.
def work_or_mark(wildcards):
    trace = trace_of(wildcards)
    return ancient(trace["input"] if trace["is_work"] else "marks/work/" + wildcards.trace)

# What is wrong with a trace leaves no work behind, though replay would keep what came before it.
rule work:
    output: "marks/work/{trace}"
    params:
        once=once,
        program=plan["program"],
        work=work_of,
        trace=lambda wildcards: trace_of(wildcards)["input"],
        frames=["--frames", plan["frames"]] if plan["frames"] else [],
        values=["--work-values"] if plan["values"] else [],
    shell:
        "{params.once:q} {params.work:q} {params.program:q} replay {params.trace:q}"
        " {params.frames:q} {params.values:q} --save-work && touch {output:q}"

# A machine that is stuck is a result, too; `ffgpu time --totals` writes it.
rule time:
    input:
        work=work_or_mark,
        point=ancient("points/{point}.toml"),
    output: "marks/results/{trace}/{point}"
    params:
        once=once,
        program=plan["program"],
        work=work_of,
        result="results/{trace}/{point}.json",
    shell:
        "{params.once:q} {params.result:q} {params.program:q} time {params.work:q}"
        " --config {input.point:q} --totals 1>&2 && touch {output:q}"
