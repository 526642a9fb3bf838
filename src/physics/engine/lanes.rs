//! Calculations with two values at a time: most processors handle two numbers in a single step, and
//! round each of them as they would a single number.

use std::ops::{Add, Mul, Sub};

use glam::DVec2;
use wide::f64x2;

/// Takes one number from each of two objects.
#[inline(always)]
pub(super) fn of_both<T>([a, b]: [&T; 2], number: impl Fn(&T) -> f64) -> f64x2 {
    f64x2::new([number(a), number(b)])
}

#[derive(Debug, Clone, Copy)]
pub(super) struct TwoVectors {
    x: f64x2,
    y: f64x2,
}

impl TwoVectors {
    /// Takes one vector from each of two objects.
    #[inline(always)]
    pub(super) fn of_both<T>(things: [&T; 2], vector: impl Fn(&T) -> DVec2) -> Self {
        Self {
            x: of_both(things, |thing| vector(thing).x),
            y: of_both(things, |thing| vector(thing).y),
        }
    }

    #[inline(always)]
    pub(super) fn dot(self, other: Self) -> f64x2 {
        self.x * other.x + self.y * other.y
    }

    #[inline(always)]
    pub(super) fn perp_dot(self, other: Self) -> f64x2 {
        self.x * other.y - self.y * other.x
    }
}

impl Add for TwoVectors {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            x: self.x + other.x,
            y: self.y + other.y,
        }
    }
}

impl Sub<DVec2> for TwoVectors {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: DVec2) -> Self {
        Self {
            x: self.x - f64x2::splat(other.x),
            y: self.y - f64x2::splat(other.y),
        }
    }
}

impl Mul<f64x2> for TwoVectors {
    type Output = Self;

    #[inline(always)]
    fn mul(self, by: f64x2) -> Self {
        Self {
            x: self.x * by,
            y: self.y * by,
        }
    }
}
