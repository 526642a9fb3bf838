//! The cost of playing a shot.

/// The work done on a shot, measured as the number of tests of a pair of discs. This number is the
/// same on every machine, so a shot that exceeds the limit on one machine exceeds it on all
/// machines.
#[derive(Debug, Clone, Copy)]
pub(super) struct Work {
    done: u64,
    allowed: u64,
}

impl Work {
    pub(super) fn up_to(allowed: u64) -> Self {
        Self { done: 0, allowed }
    }

    pub(super) fn add(&mut self, looks: usize) {
        self.done += looks as u64;
    }

    pub(super) fn is_too_much(self) -> bool {
        self.done > self.allowed
    }
}
