//! Mistakes in law, material and section.

use ancf::model::{Element, Law, Scene};

use crate::trajectory::mistake::{Add, INPUT, LAW, each_material, each_section};

/// Shear, Poisson, quadrature, section.
pub fn law(scene: &Scene, add: &mut Add) {
    let ancf = scene.rods.iter().any(|rod| rod.element == Element::Ancf);
    let has_nu = scene.rods.iter().any(|rod| scene.material(rod).nu != 0.0);
    if ancf {
        add("E3: the shear of the global axes counted once", LAW, &|setup| setup.law.printed_shear = true);
        add("the shear counted once: 2μ for 4μ", LAW, &|setup| setup.law.shear = 0.5);
        add("the shear counted twice", LAW, &|setup| setup.law.shear = 2.0);
        add("a shear correction factor of 5/6", LAW, &|setup| setup.law.shear = 5.0 / 6.0);
        add("no shear stiffness", LAW, &|setup| setup.law.shear = 0.0);
        add("no stiffness across the rod", LAW, &|setup| setup.law.across = 0.0);
        add("strains linear in the displacement", "ε of (10), (14): it is quadratic in the gradient", &|setup| {
            setup.law.linear = true
        });
        for nu in [0.3, 0.25, 0.2].into_iter().filter(|_| !has_nu) {
            add(&format!("ν is {nu} in place of 0"), INPUT, &|setup| each_material(&mut setup.scene, |m| m.nu = nu));
        }
        for points in [[4, 3], [3, 3], [4, 2], [3, 2], [2, 2], [2, 3], [2, 1], [3, 1], [5, 2], [5, 1], [1, 1]] {
            let what = format!("{} × {} Gauss points in the elastic force", points[0], points[1]);
            add(&what, "the quadrature of (18)–(21): 5 × 3 points are exact", &|setup| setup.law.points = points);
        }
        if has_nu {
            add("ν is 0", INPUT, &|setup| each_material(&mut setup.scene, |material| material.nu = 0.0));
            add("no coupling by ν: the uniaxial law", LAW, &|setup| {
                setup.scene.rods.iter_mut().for_each(|rod| rod.law = Law::Uniaxial);
            });
            add("plane stress in place of plane strain", LAW, &|setup| {
                // E and ν of a material whose plane strain is the plane stress of this one.
                each_material(&mut setup.scene, |material| {
                    let nu = material.nu;
                    material.youngs_modulus *= (1.0 + 2.0 * nu) / (1.0 + nu).powi(2);
                    material.nu = nu / (1.0 + nu);
                });
            });
        }
    }
    if scene.rods.iter().any(|rod| scene.section(rod).height != scene.section(rod).width) {
        add("height and width of the section exchanged", INPUT, &|setup| {
            each_section(&mut setup.scene, |section| std::mem::swap(&mut section.height, &mut section.width));
        });
    }
    add("half the section's height", INPUT, &|setup| each_section(&mut setup.scene, |section| section.height *= 0.5));
    add("twice the section's height: y from −h to h", INPUT, &|setup| {
        each_section(&mut setup.scene, |section| section.height *= 2.0)
    });
    add("I is w h³/3 in place of w h³/12", INPUT, &|setup| setup.law.depth = 2.0);
    add("I is w h³/6 in place of w h³/12", INPUT, &|setup| setup.law.depth = 2f64.sqrt());
    if scene.rods.len() > 1 {
        add("all rods have the scene's material", INPUT, &|setup| {
            setup.scene.rods.iter_mut().for_each(|rod| rod.material = None)
        });
        add("all rods have the scene's section", INPUT, &|setup| {
            setup.scene.rods.iter_mut().for_each(|rod| rod.section = None)
        });
    }
}
