//! A rod: coordinates of its elements, their heat, force and energy.

#![allow(non_snake_case)] // The paper's symbols are names here.

use ancf::model::{Element, Start, Temperature, ThermalModel};
use nalgebra::{DVector, Vector2};

use super::element::{ElementData, vectors};
use super::setup::{Blocks, Setup, StartStretch};

/// A rod: its elements' Gauss points, law and heat.
#[derive(Debug)]
pub struct Rod {
    /// Its first coordinate.
    pub first: usize,
    /// Number of its elements.
    pub elements: usize,
    element: ElementData,
    /// Direction at first.
    pub t: [f64; 2],
    alpha: f64,
    heat: Option<Temperature>,
    heat_factors: [f64; 2],
    ramp: f64,
    blocks: Blocks,
}

impl Rod {
    pub fn new(setup: &Setup, rod: &ancf::model::Rod, first: usize) -> Rod {
        let scene = &setup.scene;
        let (material, section) = (scene.material(rod), scene.section(rod));
        let ends = [&rod.from, &rod.to].map(|name| Vector2::from(scene.points.get(name).copied().unwrap_or_default()));
        let along = ends[1] - ends[0];
        let length = along.norm() / rod.elements as f64;
        let element = match rod.element {
            Element::Ancf => ElementData::ancf(&setup.law, rod, material, section, length, setup.retardation),
            Element::EulerBernoulli => ElementData::cable(&setup.law, material, section, length),
        };
        Rod {
            first,
            elements: rod.elements,
            element,
            t: (along / along.norm()).into(),
            alpha: material.alpha,
            heat: scene.heat(rod).cloned(),
            heat_factors: setup.heat,
            ramp: setup.ramp,
            blocks: setup.force_blocks,
        }
    }

    pub fn is_cable(&self) -> bool {
        matches!(self.element, ElementData::Cable { .. })
    }

    /// Vectors of an element, and those by which neighbours are apart.
    fn vectors(&self) -> (usize, usize) {
        vectors(if self.is_cable() { Element::EulerBernoulli } else { Element::Ancf })
    }

    /// Thermal strain (along, across).
    fn thermal_strain(&self, t: f64) -> [f64; 2] {
        let Some(heat) = &self.heat else { return [0.0; 2] };
        let part = if t < self.ramp { t / self.ramp } else { 1.0 };
        let strain = self.alpha * heat.at(t) * part;
        match heat.model {
            ThermalModel::TwoD => self.heat_factors.map(|factor| factor * strain),
            ThermalModel::OneD => [self.heat_factors[0] * strain, 0.0],
            ThermalModel::Transverse => [0.0, self.heat_factors[1] * strain],
            _ => [0.0; 2],
        }
    }

    /// Coordinates of the straight rod, unstretched.
    pub fn place(&self, element: Element, from: Vector2<f64>, to: Vector2<f64>, q: &mut DVector<f64>) {
        let t = Vector2::from(self.t);
        let n = Vector2::new(-t.y, t.x);
        let (of_element, stride) = vectors(element);
        for vector in 0..stride * self.elements + of_element - stride {
            let (at, within) = (vector / stride, vector % stride);
            let on_axis = |place: f64| from + (to - from) * (place / self.elements as f64);
            let value = match (element, within) {
                (_, 0) => on_axis(at as f64),
                (Element::EulerBernoulli, _) | (Element::Ancf, 3) => t,
                (Element::Ancf, 2) => on_axis(at as f64 + 0.5),
                (Element::Ancf, _) => n,
            };
            q[self.first + 2 * vector] = value.x;
            q[self.first + 2 * vector + 1] = value.y;
        }
    }

    /// Stretches a rod that starts free of stress, from its first point.
    pub fn stretch(&self, element: Element, start: StartStretch, q: &mut DVector<f64>) {
        if !self.heat.as_ref().is_some_and(|heat| heat.start == Start::Relaxed) {
            return;
        }
        let [along, across] = self.thermal_strain(self.ramp);
        let (of_element, stride) = vectors(element);
        let free = |strain: f64| if self.is_cable() { 1.0 + strain } else { (1.0 + 2.0 * strain).max(0.0).sqrt() };
        let across = if start == StartStretch::AlongOnly { 0.0 } else { across };
        let from = [q[self.first], q[self.first + 1]];
        for vector in 0..stride * self.elements + of_element - stride {
            let within = vector % stride;
            for (component, from) in from.into_iter().enumerate() {
                let value = &mut q[self.first + 2 * vector + component];
                *value = match (element, within) {
                    (_, 0) | (Element::Ancf, 2) => from + (*value - from) * free(along),
                    (Element::EulerBernoulli, _) | (Element::Ancf, 3) => *value * free(along),
                    (Element::Ancf, _) => *value * free(across),
                };
            }
        }
    }

    /// Subtracts Q_e from a force.
    pub fn subtract_force(&self, t: f64, q: &[f64], v: &[f64], force: &mut [f64]) {
        let heat = self.thermal_strain(t);
        let (of_element, stride) = self.vectors();
        for element in 0..self.elements {
            let first = self.first + 2 * stride * element;
            let own = first..first + 2 * of_element;
            let (Some(q), Some(v)) = (q.get(own.clone()), v.get(own.clone())) else { continue };
            let mut Q_e = [0.0; 14];
            self.element.force(q, v, heat, self.t, &mut Q_e);
            let Some(target) = force.get_mut(own) else { continue };
            for (n, (target, Q_e)) in target.iter_mut().zip(Q_e).enumerate() {
                *target -= self.blocks.share(element, self.elements, n, 2 * of_element) * Q_e;
            }
        }
    }

    pub fn energy(&self, t: f64, q: &[f64]) -> f64 {
        let heat = self.thermal_strain(t);
        let (of_element, stride) = self.vectors();
        let elements = (0..self.elements).filter_map(|element| {
            let first = self.first + 2 * stride * element;
            Some(self.element.energy(q.get(first..first + 2 * of_element)?, heat, self.t))
        });
        elements.sum()
    }
}
