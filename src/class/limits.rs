//! Limits on what devices may do to a class: a burst, and then a rate per second.
//!
//! The caller passes the time, counted from any fixed moment: this module reads no clock.

use std::collections::BTreeMap;
use std::net::IpAddr;
use std::time::Duration;

use super::join_code::JoinCode;

/// New seats for one address, so that a single device cannot quickly fill a class; a class of 40
/// behind one router may join at once, some of them twice.
pub(super) const NEW_SEATS: Allowance = Allowance {
    at_once: 60.0,
    per_s: 0.5,
};
/// Wrong codes from one address: enough for pupils who mistype, then one every ten seconds.
const WRONG_CODES: Allowance = Allowance {
    at_once: 60.0,
    per_s: 0.1,
};
/// Wrong codes from all addresses together.
const ALL_WRONG_CODES: Allowance = Allowance {
    at_once: 400.0,
    per_s: 1.5,
};
/// Wrong codes from each address that do not count towards the limit for all addresses together, so
/// that guessing from many addresses does not keep out a pupil who has just arrived.
const FIRST_WRONG_CODES: Allowance = Allowance {
    at_once: 2.0,
    per_s: 1.0 / 1800.0,
};
/// The delay of the reply to the first wrong code from an address. The delay increases by the same
/// amount for every ten wrong codes.
const WRONG_CODE_DELAY: Duration = Duration::from_secs(1);
const DELAY_STEP: f64 = 10.0;
/// While carrom remembers fewer addresses than this, it forgets none of them.
const MANY: usize = 256;

/// A burst, and then a rate per second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Allowance {
    /// The size of the burst.
    pub at_once: f64,
    /// The rate per second.
    pub per_s: f64,
}

/// The unused part of an allowance.
#[derive(Debug, Clone, Copy)]
pub struct Bucket {
    allowance: Allowance,
    left: f64,
    /// The time at which `left` was calculated.
    since: Duration,
}

impl Bucket {
    /// A full allowance.
    pub const fn full(allowance: Allowance) -> Self {
        Self {
            allowance,
            left: allowance.at_once,
            since: Duration::ZERO,
        }
    }

    /// The unused part at time `now`.
    fn left(&self, now: Duration) -> f64 {
        let back = self.allowance.per_s * now.saturating_sub(self.since).as_secs_f64();
        (self.left + back).min(self.allowance.at_once)
    }

    /// Whether at least 1 is left.
    fn has_one(&self, now: Duration) -> bool {
        self.left(now) >= 1.0
    }

    /// Uses `count` of the allowance, even if less is left; returns the time until the balance is
    /// at least 0.
    pub fn take(&mut self, count: f64, now: Duration) -> Duration {
        self.left = self.left(now) - count;
        self.since = self.since.max(now);
        Duration::from_secs_f64((-self.left / self.allowance.per_s).max(0.0))
    }
}

/// The same allowance for each address.
#[derive(Debug, Clone)]
pub(super) struct Addresses {
    allowance: Allowance,
    /// The allowances of known addresses; every other address has a full allowance.
    known: BTreeMap<IpAddr, Bucket>,
    /// Once `known` contains this many addresses, those with a full allowance are forgotten.
    most: usize,
}

impl Addresses {
    pub(super) const fn new(allowance: Allowance) -> Self {
        Self {
            allowance,
            known: BTreeMap::new(),
            most: MANY,
        }
    }

    /// Whether an address has at least 1 left.
    pub(super) fn has_one(&mut self, address: IpAddr, now: Duration) -> bool {
        self.of(address, now).has_one(now)
    }

    /// Uses up 1 of an address's allowance.
    pub(super) fn take(&mut self, address: IpAddr, now: Duration) {
        self.of(address, now).take(1.0, now);
    }

    /// The bucket of an address.
    fn of(&mut self, address: IpAddr, now: Duration) -> &mut Bucket {
        if self.known.len() >= self.most {
            let at_once = self.allowance.at_once;
            self.known.retain(|_, bucket| bucket.left(now) < at_once);
            self.most = MANY.max(2 * self.known.len());
        }
        let full = Bucket::full(self.allowance);
        self.known.entry(address).or_insert(full)
    }
}

/// The code of a class, and the limits on guessing it.
#[derive(Debug)]
pub struct GuardedCode {
    code: JoinCode,
    addresses: Addresses,
    firsts: Addresses,
    all: Bucket,
}

/// The verdict on a typed code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CodeVerdict {
    /// The code is right.
    Right,
    /// The code is wrong; the reply is delayed for this long.
    Wrong(Duration),
    /// The code was not checked: there were too many wrong codes.
    Unseen,
}

impl GuardedCode {
    /// A code that nobody has tried to guess yet.
    pub const fn new(code: JoinCode) -> Self {
        Self {
            code,
            addresses: Addresses::new(WRONG_CODES),
            firsts: Addresses::new(FIRST_WRONG_CODES),
            all: Bucket::full(ALL_WRONG_CODES),
        }
    }

    /// Whether the text is this code. A wrong code is not counted.
    pub fn is(&self, typed: &str) -> bool {
        typed.parse() == Ok(self.code)
    }

    /// Checks a code from an address, and counts it if it is wrong.
    pub fn judge(&mut self, typed: &str, address: IpAddr, now: Duration) -> CodeVerdict {
        let own = self.addresses.of(address, now);
        let first = self.firsts.of(address, now);
        let shared = match first.has_one(now) {
            true => first,
            false => &mut self.all,
        };
        if !own.has_one(now) || !shared.has_one(now) {
            return CodeVerdict::Unseen;
        }
        if typed.parse() == Ok(self.code) {
            return CodeVerdict::Right;
        }
        let wrong = WRONG_CODES.at_once - own.left(now);
        own.take(1.0, now);
        shared.take(1.0, now);
        CodeVerdict::Wrong(WRONG_CODE_DELAY.mul_f64(1.0 + wrong / DELAY_STEP))
    }
}

#[cfg(test)]
mod tests {
    use std::net::Ipv4Addr;

    use super::*;

    const LESSON: Duration = Duration::from_secs(45 * 60);
    /// The number of possible codes.
    const CODES: f64 = 64e6;
    /// The number of codes per second that one device sent in a measurement.
    const GUESSES_PER_S: u32 = 1277;

    fn address(host: u8) -> IpAddr {
        Ipv4Addr::new(192, 168, 43, host).into()
    }

    /// The number of codes checked in a lesson in which this number of addresses take turns sending
    /// [`GUESSES_PER_S`] codes per second. The limit is per address, so parallel or new connections
    /// do not help.
    fn looked_at(addresses: u8) -> u32 {
        let mut code = GuardedCode::new(JoinCode::of(63_999_999));
        let mut looked_at = 0;
        for guess in 0..GUESSES_PER_S * LESSON.as_secs() as u32 {
            let now = Duration::from_secs(1) * guess / GUESSES_PER_S;
            let typed = JoinCode::of(u64::from(guess)).to_string();
            let from = address((guess % u32::from(addresses)) as u8);
            match code.judge(&typed, from, now) {
                CodeVerdict::Wrong(_) => looked_at += 1,
                CodeVerdict::Unseen => {}
                CodeVerdict::Right => panic!("a wrong code was accepted"),
            }
        }
        looked_at
    }

    /// Without a limit, 1,277 codes per second would be 3.4 million in a lesson, a twentieth of all
    /// codes.
    #[test]
    fn guessing_for_a_lesson_finds_less_than_a_ten_thousandth_of_the_codes() {
        let alone = looked_at(1);
        // One address: 60 codes at once, then one every ten seconds.
        assert!((300..=331).contains(&alone), "{alone}");
        // All 254 addresses of a network: 400 codes at once, then 1.5 per second; in addition, two
        // from each address at once and another from each every half hour.
        let most = looked_at(254);
        assert!((4000..=400 + 4050 + 254 * 4).contains(&most), "{most}");
        for guesses in [alone, most] {
            assert!(f64::from(guesses) / CODES < 1e-4);
        }
    }

    /// Forty pupils behind one router arrive within a minute, and each of them first mistypes the
    /// code.
    #[test]
    fn pupils_behind_one_router_can_mistype_the_code_and_still_join() {
        let mut code = GuardedCode::new(JoinCode::of(7));
        let mut seats = Addresses::new(NEW_SEATS);
        let right = JoinCode::of(7).to_string().to_lowercase();
        for pupil in 0..40 {
            let now = Duration::from_millis(1500) * pupil;
            let wrong = code.judge("BBBBBB", address(1), now);
            let CodeVerdict::Wrong(delay) = wrong else {
                panic!("{pupil}: {wrong:?}");
            };
            assert!(delay < Duration::from_secs(6), "{pupil}: {delay:?}");
            assert_eq!(
                code.judge(&right, address(1), now + delay),
                CodeVerdict::Right
            );
            assert!(seats.has_one(address(1), now + delay));
            seats.take(address(1), now + delay);
        }
    }

    /// While somebody guesses codes from 200 addresses, a newcomer at another address who first
    /// mistypes the code can still join.
    #[test]
    fn guessing_from_many_addresses_does_not_keep_others_out() {
        let mut code = GuardedCode::new(JoinCode::of(7));
        let mut said = 0;
        for second in 0..=600 {
            let now = Duration::from_secs(second);
            for host in 0..200 {
                let verdict = code.judge("BBBBBB", address(host), now);
                said += u32::from(matches!(verdict, CodeVerdict::Wrong(_)));
            }
        }
        assert!(said > 1000, "{said}");
        let now = Duration::from_secs(600);
        assert!(matches!(
            code.judge("BBBBBC", address(250), now),
            CodeVerdict::Wrong(_)
        ));
        let right = JoinCode::of(7).to_string();
        assert_eq!(code.judge(&right, address(250), now), CodeVerdict::Right);
        assert_eq!(code.judge(&right, address(0), now), CodeVerdict::Unseen);
    }

    #[test]
    fn seats_become_available_again_and_addresses_are_forgotten() {
        let mut seats = Addresses::new(NEW_SEATS);
        let mut now = Duration::ZERO;
        let mut taken = 0;
        while seats.has_one(address(1), now) {
            seats.take(address(1), now);
            taken += 1;
        }
        assert_eq!(taken, 60);
        assert!(seats.has_one(address(2), now));
        now += Duration::from_secs(2);
        assert!(seats.has_one(address(1), now));
        seats.take(address(1), now);
        assert!(!seats.has_one(address(1), now));
        // A time earlier than the last one restores nothing.
        assert!(!seats.has_one(address(1), Duration::ZERO));
        now += Duration::from_secs(3600);
        for host in 0..=u32::from(u16::MAX) {
            seats.take(Ipv4Addr::from(host).into(), now);
            now += Duration::from_secs(1);
        }
        assert!(seats.known.len() <= MANY + 60, "{}", seats.known.len());
    }

    /// A connection waits until the balance is 0 again.
    #[test]
    fn an_exhausted_allowance_is_restored_over_time() {
        let mut bucket = Bucket::full(Allowance {
            at_once: 2.0,
            per_s: 4.0,
        });
        let start = Duration::from_secs(9);
        let waits = [1.0, 1.0, 1.0, 2.0].map(|count| bucket.take(count, start).as_secs_f64());
        assert_eq!(waits, [0.0, 0.0, 0.25, 0.75]);
        let later = start + Duration::from_secs(1);
        assert_eq!(bucket.take(1.0, later), Duration::ZERO);
    }
}
