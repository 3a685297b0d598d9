# The flow of `ffgpu sweep`: a functional run a trace, then a timing job a machine and trace.
# plan.json says what is missing; each file comes to its name whole, by a rename.
import json

with open("plan.json") as file:
    plan = json.load(file)

localrules: all

rule all:
    input: ["results/%s.json" % job for job in plan["missing"]]

def work_of(wildcards):
    trace = plan["traces"][wildcards.trace]
    return trace["input"] if trace["is_work"] else "work/%s.ffw" % wildcards.trace

# What is wrong with a trace leaves no work behind, though replay would keep what came before it.
rule work:
    output: "work/{trace}.ffw"
    params:
        program=plan["program"],
        trace=lambda wildcards: plan["traces"][wildcards.trace]["input"],
        frames=["--frames", plan["frames"]] if plan["frames"] else [],
    shell:
        "{params.program:q} replay {params.trace:q} {params.frames:q} --save-work {output:q}.unfinished"
        " && mv -f {output:q}.unfinished {output:q}"

# A machine that is stuck (status 3) is a result, too; `ffgpu time --totals` writes it.
rule time:
    input:
        work=lambda wildcards: ancient(work_of(wildcards)),
        point=ancient("points/{point}.toml"),
    output: "results/{trace}/{point}.json"
    params: program=plan["program"]
    shell:
        "{params.program:q} time {input.work:q} --config {input.point:q} --totals {output:q}"
        " 1>&2 || [ $? = 3 ]"
