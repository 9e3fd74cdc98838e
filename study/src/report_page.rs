//! `report.html`: the main job's printed text and its pictures.

use crate::html::Html;

/// The page of the printed text and of the pictures, each with its file name.
pub fn page(text: &str, pictures: &[(&'static str, String)]) -> String {
    let mut html = Html::default();
    html.paragraph("The printed output of the main job, followed by its pictures. main.json has the numbers with all digits, the .csv files have the curves.");
    html.preformatted(text);
    html.heading("Pictures");
    for (name, svg) in pictures {
        html.figure(svg, name);
    }
    html.page("Peng et al. (2018): the heated pendulum and the deployable structure")
}
