"""From a definition to source text: SymPy derives, simplifies, stabilises and writes the package `generated`.

Nothing here is imported at run time. The stages, in the order in which `python -m derive` walks them:

``quantities``  what is derived, declared once as data
``integrate``   definition -> closed form, each step proved
``stable``      closed form -> form without cancellation, linked by proof
``dynamics``    balance laws -> equation of motion -> its solution, proved by substitution
``effects``     what a scene may ask for, declared once as data
``program``     SymPy expression -> straight-line `Program`
``emit``        `Program` -> NumPy source
``emit_c``      `Program` -> C source of ufunc loops
``build``       C source -> extension module, here and at install time (``build_hook``)
``write``       source -> the files of `generated`, atomically, or a diff against them
``appendices``, ``paper``, ``evidence``, ``verify``, ``hard``   the paper's claims, judged; the hard cases, measured
"""
