"""The Taylor integrator for all scenes: programs are assembled from `generated.flow` and integrated lane by lane.

`lanes` has the lanes of a scene, `problem` their dimensionless numbers and tables, `build` and `link` the program that
is assembled from the fragments of `generated.flow`. `integrate` integrates it in NumPy (with `stick_slip`, `recorder`,
`lane_state`, `pieces`, `events`, `polynomials`), `compiled` in C, `implicit` what is stiff (with `radau`); `tangents`
has derivatives.
"""
