//! The cost of playing a shot.

/// The work done on a shot, counted in tests of a pair of discs: the count is the same on every
/// machine, so a shot that exceeds the limit on one exceeds it on all.
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
