//! Choice of the instructions, once per structure.

use super::Lanes;
#[cfg(target_arch = "x86_64")]
use super::avx2::Avx2;
use super::portable::Portable;

/// Variable of the environment that forces the portable path, where it is set to anything but `0` or nothing.
const SWITCH: &str = "ANCF_PORTABLE";

/// Computation with four numbers side by side, for either path.
pub trait Task {
    /// Result.
    type Output;

    /// Computes; `#[inline(always)]`, as all that it calls.
    fn run<L: Lanes>(self, token: L::Token) -> Self::Output;
}

/// Instructions that a structure computes with.
#[derive(Clone, Copy, Debug)]
pub struct Path(Kind);

#[derive(Clone, Copy, Debug)]
enum Kind {
    Portable,
    #[cfg(target_arch = "x86_64")]
    Avx2(pulp::x86::V3),
}

impl Path {
    /// Path with the least processor's instructions: equal bits on every machine.
    pub const PORTABLE: Path = Path(Kind::Portable);

    /// Fastest path of this processor.
    pub fn fastest() -> Path {
        #[cfg(target_arch = "x86_64")]
        if let Some(token) = pulp::x86::V3::try_new() {
            return Path(Kind::Avx2(token));
        }
        Path::PORTABLE
    }

    /// Fastest path of this processor, unless the environment forces the portable one by `ANCF_PORTABLE=1`.
    pub fn chosen() -> Path {
        let is_forced = std::env::var_os(SWITCH).is_some_and(|value| !value.is_empty() && value != "0");
        if is_forced { Path::PORTABLE } else { Path::fastest() }
    }

    /// Runs a task.
    #[inline]
    pub fn run<T: Task>(self, task: T) -> T::Output {
        match self.0 {
            Kind::Portable => task.run::<Portable>(()),
            #[cfg(target_arch = "x86_64")]
            Kind::Avx2(token) => token.vectorize(OnAvx2(token, task)),
        }
    }
}

/// A task with its proof, as the crate of the instructions wants it.
#[cfg(target_arch = "x86_64")]
struct OnAvx2<T>(pulp::x86::V3, T);

#[cfg(target_arch = "x86_64")]
impl<T: Task> pulp::NullaryFnOnce for OnAvx2<T> {
    type Output = T::Output;

    #[inline(always)]
    fn call(self) -> T::Output {
        self.1.run::<Avx2>(self.0)
    }
}
