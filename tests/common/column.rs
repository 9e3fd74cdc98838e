//! Clamped columns with a force along them and a smaller one across, and their elastica.

use ancf::model::{Element, Force, Material, Method, Probe, Quantity, Rod, Scene, Section, Support};
use ancf::run::Run;

/// Clamped column of 1 m with a force along it and another across, at its tip.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// P/P_cr.
    pub load: f64,
    /// Force across, as a share of P.
    pub share: f64,
    /// Number of load steps.
    pub load_steps: usize,
    /// Number of elements.
    pub elements: usize,
    /// Direction of the column, from the x axis.
    pub angle: f64,
}

const HEIGHT: f64 = 0.02;
const E: f64 = 7e10;

impl Column {
    fn force(self) -> f64 {
        let bending = E * HEIGHT.powi(4) / 12.0;
        self.load * std::f64::consts::PI.powi(2) * bending / 4.0
    }

    pub fn scene(self) -> Scene {
        let (sin, cos) = self.angle.sin_cos();
        let turned = |[x, y]: [f64; 2]| [cos * x - sin * y, sin * x + cos * y];
        let force = self.force();
        let mut scene = Scene::new(Material::new(E, 0.0, 2700.0), Section::new(HEIGHT, HEIGHT))
            .point("a", [0.0, 0.0])
            .point("b", turned([1.0, 0.0]))
            .rod(Rod::new("r", "a", "b").elements(Element::Ancf, self.elements))
            .support(Support::pinned("a").clamping("r"))
            .force(Force::new("b", turned([-force, self.share * force])))
            .probe(Probe::point("b", "b", &[Quantity::Position]));
        (scene.time.method, scene.time.load_steps) = (Method::Static, self.load_steps);
        scene
    }

    /// Tip in the column's own axes.
    pub fn tip(self, run: &Run) -> [f64; 2] {
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = ["b.x", "b.y"].map(|name| *run.trajectory.column(name).unwrap().last().unwrap());
        [cos * x + sin * y, cos * y - sin * x]
    }

    /// Tip of the elastica, whose axis keeps its length: EI θ″ = −P sin θ − H cos θ, θ(0) = 0, θ′(L) = 0, integrated from
    /// the tip on by Runge and Kutta's method; bisection for the angle of the tip between 0 and π.
    pub fn elastica(self) -> [f64; 2] {
        let k = self.load * std::f64::consts::PI.powi(2) / 4.0;
        let slope = |theta: f64| k * theta.sin() + self.share * k * theta.cos();
        let n = 2000;
        let h = 1.0 / n as f64;
        // θ, −θ′, x, y over the distance from the tip.
        let rate = |[theta, turn, _, _]: [f64; 4]| [-turn, slope(theta), theta.cos(), theta.sin()];
        let from_tip = |angle: f64| {
            let mut y = [angle, 0.0, 0.0, 0.0];
            for _ in 0..n {
                let at = |k: [f64; 4], c: f64| std::array::from_fn(|i| y[i] + c * h * k[i]);
                let k_1 = rate(y);
                let k_2 = rate(at(k_1, 0.5));
                let k_3 = rate(at(k_2, 0.5));
                let k_4 = rate(at(k_3, 1.0));
                y = std::array::from_fn(|i| y[i] + h / 6.0 * (k_1[i] + 2.0 * k_2[i] + 2.0 * k_3[i] + k_4[i]));
            }
            y
        };
        let (mut low, mut high) = (0.0, std::f64::consts::PI);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if from_tip(middle)[0] < 0.0 { low = middle } else { high = middle }
        }
        let [_, _, x, y] = from_tip(low);
        [x, y]
    }
}
