//! Okabe and Ito's colours, which the colour-blind can distinguish, and the colour that a method has in every picture: one that nothing else has.

use plotters::style::RGBColor;

use ancf::model::Method;

pub const BLACK: RGBColor = RGBColor(0, 0, 0);
pub const ORANGE: RGBColor = RGBColor(230, 159, 0);
pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const GREY: RGBColor = RGBColor(150, 150, 150);
pub const VERMILLION: RGBColor = RGBColor(213, 94, 0);
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
pub const SKY: RGBColor = RGBColor(86, 180, 233);
/// Beside Okabe and Ito's: dark, so that it differs from all of them without colour, too.
pub const BROWN: RGBColor = RGBColor(102, 51, 0);

/// The colour of a method.
pub fn of_method(method: Method) -> RGBColor {
    match method {
        Method::GeneralizedAlpha => ORANGE,
        Method::EnergyMomentum => BLUE,
        Method::Explicit => VERMILLION,
        Method::Gauss => GREEN,
        Method::GaussAdaptive => PURPLE,
        Method::Nystrom => SKY,
        Method::NystromAdaptive => BROWN,
        // Statics, and what is to come.
        _ => BLACK,
    }
}
