//! Mistakes in the assembly of elements.

use ancf::model::Scene;

use crate::trajectory::mistake::{ASSEMBLY, Add, INERTIA, has_gravity};
use crate::trajectory::setup::{Blocks, Mass, Setup};

/// Blocks assembled once or twice, elements left out, masses lumped.
pub fn assembly(scene: &Scene, add: &mut Add) {
    let most = scene.rods.iter().map(|rod| rod.elements).max().unwrap_or(1);
    type Term = (&'static str, fn(&mut Setup, Blocks));
    let terms: [Term; 4] = [
        ("mass", |setup, blocks| setup.mass_blocks = blocks),
        ("elastic force", |setup, blocks| setup.force_blocks = blocks),
        ("weight", |setup, blocks| setup.weight_blocks = blocks),
        ("mass, elastic force and weight", |setup, blocks| {
            (setup.mass_blocks, setup.force_blocks, setup.weight_blocks) = (blocks, blocks, blocks);
        }),
    ];
    for (term, set) in terms {
        if term == "weight" && !has_gravity(scene) {
            continue;
        }
        if most > 1 {
            let nodes = "at nodes that elements share";
            add(
                &format!("{term} assembled once {nodes}: the last element's block replaces the other"),
                ASSEMBLY,
                &|setup| {
                    set(setup, Blocks::Last);
                },
            );
            add(&format!("{term} assembled once {nodes}: the first element's block is kept"), ASSEMBLY, &|setup| {
                set(setup, Blocks::First);
            });
            add(&format!("{term} assembled twice {nodes}"), ASSEMBLY, &|setup| set(setup, Blocks::Twice));
        }
        for element in 0..most {
            let what = format!("{term} of element {} of {most} is left out", element + 1);
            if most > 1 {
                add(&what, ASSEMBLY, &|setup| set(setup, Blocks::Without(element)));
            }
        }
    }
    add("a diagonal mass, scaled to the rod's", INERTIA, &|setup| setup.mass = Mass::ScaledDiagonal);
    add("the mass matrix's diagonal alone", INERTIA, &|setup| setup.mass = Mass::Diagonal);
}
