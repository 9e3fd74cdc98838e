//! Other meshes.

use ancf::model::{Element, Scene};

use crate::trajectory::mistake::{Add, MESH};

/// Another number or kind of elements.
pub fn mesh(scene: &Scene, add: &mut Add) {
    let can_be = |element: Element, elements: usize| {
        // A pivot is a node of the Euler–Bernoulli element for even numbers only.
        element == Element::Ancf || elements.is_multiple_of(2) || scene.rods.iter().all(|rod| rod.pivot.is_none())
    };
    if scene.rods.len() == 1 {
        for (element, kind) in
            [(Element::Ancf, "elements of the paper"), (Element::EulerBernoulli, "Euler–Bernoulli elements")]
        {
            for elements in [1, 2, 3, 4, 5, 6, 8, 10] {
                let rod = &scene.rods[0];
                if (rod.element, rod.elements) == (element, elements) || !can_be(element, elements) {
                    continue;
                }
                let what = format!("{elements} {kind} in place of {}", rod.elements);
                add(&what, MESH, &|setup| {
                    (setup.scene.rods[0].element, setup.scene.rods[0].elements) = (element, elements)
                });
            }
        }
        return;
    }
    for (factor, what) in [(2, "twice as many elements in each rod"), (4, "four times as many elements in each rod")] {
        add(what, MESH, &|setup| setup.scene.rods.iter_mut().for_each(|rod| rod.elements *= factor));
    }
    add("one element in each rod", MESH, &|setup| setup.scene.rods.iter_mut().for_each(|rod| rod.elements = 1));
    if scene.rods.iter().all(|rod| can_be(Element::EulerBernoulli, rod.elements)) {
        add("Euler–Bernoulli elements in place of the paper's", MESH, &|setup| {
            setup.scene.rods.iter_mut().for_each(|rod| rod.element = Element::EulerBernoulli);
        });
    }
}
