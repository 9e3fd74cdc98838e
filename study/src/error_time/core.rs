//! One core for all that is measured: this thread and the programs that it starts.

/// Keeps this thread on the core it runs on until the value is dropped; does nothing where the system has no such call.
pub struct OneCore(#[cfg(target_os = "linux")] Option<rustix::thread::CpuSet>);

#[cfg(target_os = "linux")]
impl OneCore {
    /// From now on.
    pub fn keep() -> OneCore {
        use rustix::thread::{CpuSet, sched_getaffinity, sched_getcpu, sched_setaffinity};
        let before = sched_getaffinity(None).ok();
        let mut one = CpuSet::new();
        one.set(sched_getcpu());
        OneCore(before.filter(|_| sched_setaffinity(None, &one).is_ok()))
    }
}

#[cfg(target_os = "linux")]
impl Drop for OneCore {
    fn drop(&mut self) {
        if let Some(before) = &self.0 {
            // Without it the thread stays where it is, which is no fault.
            let _ = rustix::thread::sched_setaffinity(None, before);
        }
    }
}

#[cfg(not(target_os = "linux"))]
impl OneCore {
    /// From now on.
    pub fn keep() -> OneCore {
        OneCore()
    }
}
