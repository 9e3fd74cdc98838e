//! Number → function: every function of the paper's equations, with its reference value.

/// Relation of a function to the equation as printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// The printed equation, which is right.
    AsPrinted,
    /// The equation that follows from the paper's premises, where the printed one is wrong.
    Consistent,
    /// The printed equation, where it is wrong.
    Printed,
    /// A formula that the paper leaves out.
    Beyond,
}

/// Entry of [`CONTENTS`]: a function, its equation and its reference value.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Number of the equation in the paper; empty where it has none.
    pub equation: &'static str,
    /// Path of the function below `equations`, such as `force::U`.
    pub function: &'static str,
    /// Name of the value in [`state::evaluate`](crate::state::evaluate), in
    /// `evaluate_system` for (23), or in
    /// [`state::evaluate_cable`](crate::state::evaluate_cable) for the cable element.
    pub quantity: &'static str,
    /// Name of the value that it must equal: in `fixtures/equations.json`, in `fixtures/structure.json` for (23), or in
    /// `fixtures/cable.json` for the cable element.
    pub reference: &'static str,
    /// Relation to the printed equation.
    pub form: Form,
}

impl Entry {
    /// Whether the value belongs to a structure, (23), rather than to an element state.
    pub fn is_of_a_structure(&self) -> bool {
        self.equation == "23"
    }

    /// Whether the value belongs to a cable element's state.
    pub fn is_of_a_cable(&self) -> bool {
        self.quantity.starts_with("cable.")
    }
}

const fn entry(equation: &'static str, function: &'static str, quantity: &'static str, form: Form) -> Entry {
    Entry { equation, function, quantity, reference: quantity, form }
}

/// An entry that reaches the value `reference` by a second way.
const fn also(
    equation: &'static str,
    function: &'static str,
    quantity: &'static str,
    reference: &'static str,
) -> Entry {
    Entry { equation, function, quantity, reference, form: Form::AsPrinted }
}

/// Table of contents: equation number → function, in the paper's order. A test compares it with the source, the fixtures and
/// the tests.
///
/// ```
/// use ancf::internals::equations::{CONTENTS, Form};
///
/// let entry = CONTENTS.iter().find(|entry| entry.equation == "20" && entry.form == Form::Consistent).unwrap();
/// assert_eq!(entry.function, "force::K");
/// ```
pub const CONTENTS: &[Entry] = &[
    entry("1", "shape::r", "1.r", Form::AsPrinted),
    entry("2", "shape::S", "2.S", Form::AsPrinted),
    entry("3", "shape::S_i", "3.S", Form::AsPrinted),
    entry("", "shape::S_i_x", "3.S_x", Form::Beyond),
    entry("", "shape::S_i_y", "3.S_y", Form::Beyond),
    entry("4", "shape::nodes", "4.nodes", Form::AsPrinted),
    entry("5", "shape::r_dot", "5.rdot", Form::AsPrinted),
    entry("6", "inertia::T_integral", "6.T", Form::AsPrinted),
    also("6", "inertia::T", "6.T/matrix", "6.T"),
    entry("7", "inertia::M", "7.M", Form::AsPrinted),
    entry("8", "strain::eps_T", "8.epsilon_T", Form::AsPrinted),
    entry("", "strain::eps_T_1d", "8.epsilon_T", Form::Beyond),
    entry("9", "strain::J_0", "9.J_0", Form::AsPrinted),
    also("11", "strain::J_0_theta", "9.J_0/theta", "9.J_0"),
    entry("9", "strain::J", "9.J", Form::AsPrinted),
    entry("10", "strain::eps_m", "10.epsilon_m", Form::AsPrinted),
    entry("11", "strain::S_abc_theta", "11.S_a", Form::AsPrinted),
    entry("11", "strain::S_abc_theta", "11.S_b", Form::AsPrinted),
    entry("11", "strain::S_abc_theta", "11.S_c", Form::AsPrinted),
    also("11", "strain::S_abc", "11.S_a/general", "11.S_a"),
    also("11", "strain::S_abc", "11.S_b/general", "11.S_b"),
    also("11", "strain::S_abc", "11.S_c/general", "11.S_c"),
    entry("12", "strain::eps_f", "12.epsilon_f", Form::AsPrinted),
    entry("13", "strain::eps_1", "13.epsilon_1", Form::AsPrinted),
    entry("13", "strain::eps_2", "13.epsilon_2", Form::AsPrinted),
    entry("13", "strain::eps_3", "13.epsilon_3", Form::AsPrinted),
    entry("14", "strain::eps", "14.epsilon", Form::AsPrinted),
    entry("15", "material::sigma", "15.sigma", Form::AsPrinted),
    entry("16", "material::D", "16.D", Form::AsPrinted),
    entry("17", "material::lambda", "17.lambda", Form::AsPrinted),
    entry("17", "material::mu", "17.mu", Form::AsPrinted),
    entry("18", "force::U", "18.U", Form::Consistent),
    entry("18", "force::U_printed", "18.U/printed-shear", Form::Printed),
    entry("19", "force::Q_e", "19.Q_e", Form::Consistent),
    entry("19", "force::Q_e", "19.Q_e/printed-shear", Form::Printed),
    entry("20", "force::K", "20.K", Form::Consistent),
    entry("20", "force::K_printed", "20.K/printed-shear", Form::Printed),
    entry("21", "force::S_1", "21.S_a1", Form::AsPrinted),
    entry("21", "force::S_1", "21.S_b1", Form::AsPrinted),
    entry("21", "force::S_1", "21.S_c1", Form::AsPrinted),
    entry("21", "force::K_1", "21.K_1", Form::AsPrinted),
    entry("21", "force::K_2", "21.K_2", Form::AsPrinted),
    entry("21", "force::K_3", "21.K_3", Form::Consistent),
    entry("21", "force::K_3_printed", "21.K_3/printed", Form::Printed),
    entry("", "force::tangent", "tangent.dQ_e", Form::Beyond),
    entry("", "force::tangent_printed", "tangent.dQ_e/printed-shear", Form::Beyond),
    entry("", "inertia::Q_w_gravity", "gravity.Q_w", Form::Beyond),
    entry("22", "motion::acceleration", "22.eddot", Form::AsPrinted),
    entry("22", "motion::residual", "22.residual", Form::AsPrinted),
    entry("23", "motion::constraint_force", "23.constraint_force", Form::Consistent),
    entry("23", "motion::constraint_force_printed", "23.constraint_force/printed", Form::Printed),
    entry("23", "motion::system_residual", "23.residual", Form::Consistent),
    entry("23", "motion::system_residual", "23.residual/printed", Form::Printed),
    entry("23", "motion::system_acceleration", "23.acceleration", Form::Consistent),
    entry("23", "motion::system_acceleration", "23.lambda", Form::Consistent),
    entry("A.1", "shape::r_polynomial", "A.1.r", Form::AsPrinted),
    entry("", "shape::r_polynomial_x", "A.1.r_x", Form::Beyond),
    entry("", "shape::r_polynomial_y", "A.1.r_y", Form::Beyond),
    entry("A.2", "shape::nodal_conditions", "A.2.e", Form::AsPrinted),
    entry("A.3", "shape::coefficients", "A.3.coefficients", Form::Consistent),
    entry("A.3", "shape::coefficients_printed", "A.3.coefficients/printed", Form::Printed),
    entry("A.4", "shape::r_nodal", "A.4.r", Form::AsPrinted),
    also("A.5", "shape::S", "A.5.S", "2.S"),
    also("A.5", "shape::e", "A.5.e", "A.2.e"),
    entry("", "axis::D_0", "axis.D_0", Form::Beyond),
    entry("", "axis::epsilon", "axis.epsilon", Form::Beyond),
    entry("", "axis::U", "axis.U", Form::Beyond),
    entry("", "axis::Q_e", "axis.Q_e", Form::Beyond),
    entry("", "axis::tangent", "axis.tangent", Form::Beyond),
    entry("", "uniaxial::D", "uniaxial.D", Form::Beyond),
    entry("", "uniaxial::U", "uniaxial.U", Form::Beyond),
    entry("", "uniaxial::Q_e", "uniaxial.Q_e", Form::Beyond),
    entry("", "uniaxial::tangent", "uniaxial.tangent", Form::Beyond),
    entry("", "cable::S_i", "cable.S", Form::Beyond),
    entry("", "cable::S_i_x", "cable.S_x", Form::Beyond),
    entry("", "cable::S_i_xx", "cable.S_xx", Form::Beyond),
    entry("", "cable::r", "cable.r", Form::Beyond),
    entry("", "cable::r_x", "cable.r_x", Form::Beyond),
    entry("", "cable::r_xx", "cable.r_xx", Form::Beyond),
    entry("", "cable::epsilon", "cable.epsilon", Form::Beyond),
    entry("", "cable::kappa", "cable.kappa", Form::Beyond),
    entry("", "cable::T", "cable.T", Form::Beyond),
    entry("", "cable::M", "cable.M", Form::Beyond),
    entry("", "cable::U", "cable.U", Form::Beyond),
    entry("", "cable::Q_e", "cable.Q_e", Form::Beyond),
    entry("", "cable::tangent", "cable.tangent", Form::Beyond),
    entry("", "cable::Q_w_gravity", "cable.Q_w", Form::Beyond),
    entry("", "motion::acceleration", "cable.eddot", Form::Beyond),
];
