//! What playing a shot costs.

/// The work done on a shot, counted in looks at a pair of discs: the same count on every
/// machine, so that a shot which is too much for one is too much for all.
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
