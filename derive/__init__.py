"""From a definition to source text: SymPy derives, simplifies, stabilises and writes the package `generated`.

Nothing here is imported at run time. The stages, in the order in which `python -m derive` walks them:

``quantities``, ``symbols``   what is derived, declared once as data
``integrate``                 definition -> closed form, each step proved
``stable``                    closed form -> form without cancellation, linked by proof
``fit``, ``approximants``     stable form -> minimax polynomials and rationals for each tier of accuracy
``dynamics``, ``phase``       balance laws -> equation of motion -> its solutions in time and in the phase plane, proved
``effects``                   what a scene may ask for, declared once as data, and the balance of each combination
``sensitivity``               derivatives of the closed forms, proved
``program``, ``exact``        SymPy expression -> straight-line `Program`, and its value as every machine rounds it
``functions``                 the functions of `generated`: each with its program, its domain and its words
``emit``, ``emit_c``          `Program` -> NumPy source, and C source of ufunc loops
``measure``                   a first look at the error of the text just emitted
``certificates``              the error bound of each kernel, proved by ``certify``, ``truth`` and ``rounding``
``write``                     source -> the files of `generated`, atomically, or a diff against them
``build``, ``build_hook``     C source -> extension module, here and at install time

Beside them stand ``appendices``, ``paper``, ``evidence`` and ``verify``, which judge the paper's claims, and ``hard``,
which measures the hard cases.
"""
