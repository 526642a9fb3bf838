//! Days in the player's calendar.

use jiff::Timestamp;
use jiff::civil::Date;
use jiff::tz::TimeZone;

/// The current time and the player's time zone, which determines the day on which any time falls.
///
/// The caller supplies the time; this module reads no clock.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Calendar {
    /// The current time in seconds since the start of 1970 (UTC); `None` if the time is unknown.
    pub now_s: Option<i64>,
    zone: TimeZone,
}

/// A day as text: "21 November 2026".
pub(crate) fn long_day(day: Date) -> String {
    day.strftime("%-d %B %Y").to_string()
}

impl Calendar {
    /// Creates the calendar for a time zone.
    pub const fn new(now_s: Option<i64>, zone: TimeZone) -> Self {
        Self { now_s, zone }
    }

    /// Creates a calendar in UTC, for runs that must give the same results everywhere.
    pub const fn utc(now_s: Option<i64>) -> Self {
        Self::new(now_s, TimeZone::UTC)
    }

    /// The day on which a time, given in seconds since the start of 1970, falls; `None` outside the
    /// years -9999 to 9999.
    pub fn day(&self, time_s: i64) -> Option<Date> {
        let time = Timestamp::from_second(time_s).ok()?;
        Some(self.zone.to_datetime(time).date())
    }

    /// Today's date; `None` if the current time is unknown.
    pub fn today(&self) -> Option<Date> {
        self.day(self.now_s?)
    }
}

/// The default calendar has no current time.
impl Default for Calendar {
    fn default() -> Self {
        Self::utc(None)
    }
}
