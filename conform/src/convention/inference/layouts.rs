//! Layout of the nodal coordinates, from the quantities that become right under it.

use std::collections::BTreeSet;

use super::{Family, Inference, inclination, right_under_it};
use crate::answers::CaseAnswer;
use crate::convention::Conventions;
use crate::convention::components::Components;
use crate::convention::evidence::Weight;
use crate::convention::layout::Layout;
use crate::convention::matrices::Matrices;
use crate::convention::order::usual_orders;
use crate::convention::read_off;
use crate::convention::reading::Reading;
use crate::convention::slopes::Slope;
use crate::protocol::Answer;

/// Quantities that the layout is read off, most telling first: of the element, of the cable.
const BASES: [&[&str]; 2] = [
    &["2.S", "3.S", "7.M", "20.K", "tangent.dQ_e", "19.Q_e", "22.eddot", "gravity.Q_w", "A.2.e", "4.nodes"],
    &["cable.S", "cable.M", "cable.tangent", "cable.Q_e", "cable.eddot", "cable.Q_w"],
];
/// Sums over the nodal vectors, the same in every layout: of the element, of the cable.
const SUMS: [&[&str]; 2] =
    [&["A.4.r", "1.r", "5.rdot", "6.T", "13.epsilon_1", "18.U"], &["cable.r", "cable.r_x", "cable.T", "cable.U"]];
/// Quantities that look alike from both ends of the element.
const MIRRORED: [&str; 3] = ["7.M", "gravity.Q_w", "6.T"];
impl Inference<'_> {
    /// A program that refuses states in the layout of the fixtures may read its own: the usual ones are tried in one state.
    pub(super) fn refusals(&mut self, family: Family) {
        if self.is_declared("state") && self.conventions.reading == Reading::Fixture {
            return;
        }
        let is_refused = |(_, answer): &&CaseAnswer| matches!(answer, Ok(Answer::Error(_)));
        // In some states layouts are equal: slopes by ξ where l = 2.
        let refuses_most = |cases: &[CaseAnswer]| 2 * cases.iter().filter(is_refused).count() > cases.len();
        let mut rows = self.answers.0.iter().filter(|(quantity, _)| Family::of(quantity) == Some(family));
        let Some((quantity, cases)) = rows.find(|(_, cases)| refuses_most(cases)) else { return };
        let quantity = *quantity;
        // Where θ = 0, its unit is no reason to refuse.
        let suite = self.evidence.suite;
        let is_flat = |n: &usize| suite.cases.get(*n).is_some_and(|case| inclination(&case.state) == Some(0.0));
        let flat = cases.iter().filter(is_refused).map(|(n, _)| *n).filter(is_flat);
        let Some(n) = self.plainest(flat) else { return };
        let declared = Conventions { reading: Reading::Own, ..self.conventions.clone() };
        let usual = family.layout(&self.conventions).clone();
        let mut tried = vec![declared];
        for order in usual_orders(usual.names.len()) {
            for components in Components::ALL {
                for slopes in [
                    [Slope::One, Slope::One],
                    [Slope::HalfLength, Slope::HalfHeight],
                    [Slope::Length, Slope::Height],
                    [Slope::Length, Slope::One],
                ] {
                    let layout = Layout { order: order.clone(), components, slopes, ..usual.clone() };
                    let with = family.with(&self.conventions, self.keep_declared(layout, &usual));
                    tried.push(Conventions { reading: Reading::Own, ..with });
                }
            }
        }
        tried.dedup();
        let read = tried
            .into_iter()
            .filter(|conventions| !family.layout(conventions).is_usual())
            .find(|conventions| matches!((self.ask)(quantity, n, conventions), Ok(Answer::Value(_))));
        if let Some(conventions) = read {
            let refuses = "it refuses the states in the layout of the fixtures, and answers those in this one";
            let keys = family.layout(&conventions).differences().into_iter().map(|(key, _)| key);
            self.shown_by.extend(keys.chain(["state"]).map(|key| (key, refuses.to_string())));
            self.conventions = conventions;
            self.ask_again(&mut |quantity| Family::of(quantity) == Some(family));
        }
    }

    /// A layout with the parts that were declared.
    fn keep_declared(&self, layout: Layout, declared: &Layout) -> Layout {
        let order = if declared.names.len() == 4 { "cable_order" } else { "order" };
        Layout {
            order: if self.is_declared(order) { declared.order.clone() } else { layout.order },
            components: if self.is_declared("components") { declared.components } else { layout.components },
            slopes: if self.is_declared("slopes") { declared.slopes } else { layout.slopes },
            ..layout
        }
    }

    /// Layout of the coordinates, and nested lists of matrices.
    pub(super) fn layout(&mut self, family: Family) {
        if self.refuted.contains(&family) {
            return;
        }
        let usual = family.layout(&self.conventions).clone();
        let status = self.evidence.right_and_wrong(&self.conventions);
        let lists = match self.conventions.matrices {
            Matrices::Rows if !self.is_declared("matrices") => Matrices::ALL.to_vec(),
            known => vec![known],
        };
        let bases = match family {
            Family::Element => BASES[0],
            Family::Cable => BASES[1],
        };
        let wrong: Vec<&str> = bases.iter().copied().filter(|basis| status.1.contains(basis)).collect();
        // First layouts that a quantity fits entirely, then those that it fits but for one nodal vector, which may be a mistake.
        for spare in [0, 1] {
            let bases = if wrong.is_empty() { vec![None] } else { wrong.iter().copied().map(Some).collect() };
            for basis in bases {
                // Lists alone may explain a quantity that lists and layout explain, too: in blocks by columns S is as interleaved by rows.
                let with_lists =
                    lists.iter().map(|matrices| Conventions { matrices: *matrices, ..self.conventions.clone() });
                let with_lists: Vec<Conventions> = with_lists.collect();
                let mut tried = if spare == 0 { with_lists.clone() } else { Vec::new() };
                let row = basis.and_then(|basis| self.evidence.row(basis));
                for (row, with_lists) in row.iter().flat_map(|row| with_lists.iter().map(move |with| (row, with))) {
                    let found = read_off::layouts(&self.evidence, row, &usual, with_lists.matrices, spare);
                    if spare > 0 && found.contains(&usual) {
                        continue;
                    }
                    let layouts =
                        found.into_iter().filter(|layout| self.keep_declared(layout.clone(), &usual) == *layout);
                    tried.extend(layouts.map(|layout| family.with(with_lists, layout)));
                }
                let read_off = basis.filter(|_| spare > 0);
                if self.best_layout(family, &tried, &status, read_off) {
                    return;
                }
            }
        }
    }

    /// Accepts the conventions that make most quantities right; false if there are none. With `read_off`, a quantity that fits but for one
    /// nodal vector, none has to become right.
    fn best_layout(
        &mut self,
        family: Family,
        tried: &[Conventions],
        status: &(BTreeSet<&'static str>, BTreeSet<&'static str>),
        read_off: Option<&str>,
    ) -> bool {
        let weighed = tried
            .iter()
            .filter(|with| **with != self.conventions)
            .map(|with| (with, self.evidence.weigh(status, with)));
        let possible: Vec<(&Conventions, Weight)> = weighed
            .filter(|(_, weight)| weight.spoilt.is_empty() && (read_off.is_some() || !weight.cured.is_empty()))
            .collect();
        let Some(most) = possible.iter().map(|(_, weight)| weight.cured.len()).max() else { return false };
        let best: Vec<_> = possible.into_iter().filter(|(_, weight)| weight.cured.len() == most).collect();
        let Some((chosen, weight)) = best.first() else { return false };
        let single = weight.cured.len() == 1 && !self.followers_are_right(&weight.cured, chosen);
        if single || most == 0 && best.len() > 1 {
            return false;
        }
        let words = match read_off {
            Some(quantity) if weight.cured.is_empty() => format!("{quantity} fits it but for one nodal vector"),
            _ => right_under_it(&weight.cured),
        };
        let layout = family.layout(chosen);
        let keys = layout.differences().into_iter().map(|(key, _)| key);
        let matrices = (chosen.matrices != self.conventions.matrices).then_some("matrices");
        for key in keys.chain(matrices) {
            self.shown_by.insert(key, words.clone());
        }
        let mut others: Vec<(&'static str, String)> = Vec::new();
        for (other, _) in best.iter().skip(1) {
            if other.matrices != chosen.matrices {
                others.push(("matrices", other.matrices.words().into()));
            }
            let different = family.layout(other).differences();
            others.extend(different.into_iter().filter(|of| !layout.differences().contains(of)));
        }
        if matrices.is_none() && !layout.is_usual() && weight.cured.iter().all(|name| MIRRORED.contains(name)) {
            let mirrored = "the same element numbered from its other end: i ↔ k, x → l − x";
            others.push((layout.differences().first().map_or("order", |(key, _)| *key), mirrored.into()));
        }
        for (key, words) in others {
            let list = self.ambiguous.entry(key).or_default();
            if !list.contains(&words) {
                list.push(words);
            }
        }
        self.alternatives = best.iter().skip(1).map(|(other, _)| (*other).clone()).collect();
        self.conventions = (*chosen).clone();
        if self.conventions.reading == Reading::Own {
            self.ask_again(&mut |quantity| Family::of(quantity) == Some(family));
        }
        true
    }

    /// Takes an inferred layout back where the sums over the nodal vectors are wrong: they are the same in every layout. The program then
    /// has another S, not another e.
    pub(super) fn refute(&mut self, family: Family) {
        let conventions = &self.conventions;
        if family.layout(conventions).is_usual() || conventions.reading == Reading::Own || self.keys.contains(&"state")
        {
            return;
        }
        let judge = |name: &&str| self.evidence.row(name).and_then(|row| self.evidence.is_right(row, conventions));
        let judged: Vec<bool> = SUMS[family as usize].iter().filter_map(judge).collect();
        if judged.is_empty() || judged.contains(&true) {
            return;
        }
        self.refuted.push(family);
        // What was found under it is found again without it.
        let usual = Conventions { matrices: conventions.matrices, ..self.declared.clone() };
        let other = match family {
            Family::Element => Conventions { cable: conventions.cable.clone(), ..usual },
            Family::Cable => Conventions { element: conventions.element.clone(), ..usual },
        };
        self.conventions = other;
    }
}
