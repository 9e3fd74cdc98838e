"""Printed equations, proved or refuted symbol by symbol: `python -m oracle proofs`.

Each proof is a function that asserts and returns the sentence it has established.
"""

from .constraint import printed_constraint_force_has_no_meaning
from .energy import (
    five_by_three_points_are_exact,
    force_and_tangent_are_differences,
    poisson_on_the_axis_frees_the_thickness,
    printed_K_3_loads_an_undeformed_element,
    printed_shear_depends_on_the_frame,
    printed_shear_softens_an_inclined_rod,
    the_uniaxial_law_is_that_of_a_strut,
)
from .imperfection import deviation_is_a_constant_stiffness
from .interpolation import (
    a_1_is_misprinted,
    coefficients_start_at_zero,
    printed_shape_functions_hold,
)
from .strain import printed_forms_of_the_metric_hold, thermal_stretch_is_a_root

PROOFS = (
    a_1_is_misprinted,
    coefficients_start_at_zero,
    printed_shape_functions_hold,
    printed_forms_of_the_metric_hold,
    thermal_stretch_is_a_root,
    printed_K_3_loads_an_undeformed_element,
    printed_shear_depends_on_the_frame,
    printed_shear_softens_an_inclined_rod,
    five_by_three_points_are_exact,
    force_and_tangent_are_differences,
    poisson_on_the_axis_frees_the_thickness,
    the_uniaxial_law_is_that_of_a_strut,
    deviation_is_a_constant_stiffness,
    printed_constraint_force_has_no_meaning,
)
